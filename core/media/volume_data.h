// A volume with what its source says of it: what nodes that read or make volumes hand on.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/media/brick_volume.h"
#include "core/media/vdb_reader.h"

namespace plinian {

/// Data of this type are called by this name where they are handed on.
inline constexpr const char* volume_data_type = "plinian.volume";

struct VolumeData {
  std::shared_ptr<const BrickVolume> volume;  // never null; empty where nothing is to be shown
  dmat4 object_from_volume{1.0};              // turns and scales the file's space to metres, y up
  VdbFacts facts;                             // of a file; else only notes and warnings, if any
  std::string badge;                          // "frame 7 is missing": why it is not what was asked for
};

}  // namespace plinian
