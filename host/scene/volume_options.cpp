// The short names.
#include "host/scene/volume_options.h"

#include <cctype>

namespace plinian::scene {

std::span<const VolumeOption> volume_options() {
  static constexpr VolumeOption options[] = {
      {"grid", "medium.grid", "NAME",
       "density grid of the file: NAME, NAME[INDEX], or NAME[*] for their sum"},
      {"temperature-grid", "medium.temperature_grid", "NAME", "temperature grid of the file, or none"},
      {"level-set", "medium.level_set", "refuse|fog", "fog: a level set is converted to a fog volume"},
      {"frustum", "medium.frustum", "refuse|resample",
       "resample: a grid with a frustum transform is resampled"},
      {"up-axis", "medium.up_axis", "y|z", "which way is up in the file (guessed from its metadata)"},
      {"file-unit", "medium.file_unit", "METRES",
       "length of one unit of the file (guessed from its metadata)"},
      {"rescale", "medium.rescale", "extinction|optical_depth", "what stays where a volume is resized"},
      {"density-scale", "medium.density_scale", "FACTOR",
       "on density (median optical depth 12 if not given)"},
      {"resolution", "medium.resolution", "N", "voxels along the longest side of a procedural medium"},
      {"seed", "medium.seed", "N", "of a procedural medium"},
  };
  return options;
}

std::string flag_name(const VolumeOption& option) {
  std::string flag;
  bool raised = false;
  for (const char* c = option.name; *c; ++c) {
    if (*c != '-') flag += raised ? char(std::toupper((unsigned char)*c)) : *c;
    raised = *c == '-';
  }
  return flag;
}

}  // namespace plinian::scene
