// Writes a BrickVolume as a .vdb file that other programs open: fog-volume grids of 8^3 leaves, through the
// worker process (vdb_process.h). The file appears whole or not at all.
#pragma once

#include <map>
#include <string>

#include "core/media/brick_volume.h"

namespace plinian {

struct VdbWriteOptions {
  std::string density_grid = "density";
  std::string temperature_grid = "temperature";  // written where the volume has temperatures [K]
  bool half = true;                              // values are stored as halves
  char up_axis = 'y';      // 'y' or 'z': what is up in medium space; told in the metadata
  double file_unit = 1.0;  // [m] length of a unit of medium space, likewise
  std::map<std::string, std::string> metadata;  // of the file, beside those that Plinian itself writes
};

/// Writes through a temporary file beside `path`, then renames. Throws VdbError (vdb_reader.h) and leaves a
/// file that was there before untouched.
void write_vdb(const std::string& path, const BrickVolume& volume, const VdbWriteOptions& options = {});

}  // namespace plinian
