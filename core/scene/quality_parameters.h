// Every quality parameter, declared once: presets, --set and the help listing derive from this table.
#pragma once

#include <vector>

#include "core/scene/parameter.h"
#include "core/scene/quality.h"

namespace plinian {

/// In the order in which presets and help list them. Names have the form "map.threshold": object and key.
const std::vector<Parameter<Quality>>& quality_parameters();

}  // namespace plinian
