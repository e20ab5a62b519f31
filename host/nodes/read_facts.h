// What a volumeRead says of the file that it shows, for whoever sets a scene up from it.
#pragma once

#include "core/media/vdb_reader.h"
#include "host/graph/values/value.h"

namespace plinian::nodes {

/// The data type of its output `facts`; the object is a VdbFacts, without path where nothing is shown.
inline constexpr const char* facts_type = "file_facts";

}  // namespace plinian::nodes
