// The short names, and what goes with them.
#include "host/scene/volume_options.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

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

std::uint64_t parse_bytes(const std::string& text, const std::string& option) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const std::string unit(rest, end);
  const std::vector<std::pair<std::string, double>> units = {{"", 0},     {"K", 10},   {"KiB", 10},
                                                             {"M", 20},   {"MiB", 20}, {"G", 30},
                                                             {"GiB", 30}, {"T", 40},   {"TiB", 40}};
  if (error == std::errc() && std::isfinite(number) && number > 0.0)
    for (const auto& [name, power] : units)
      if (unit == name && number * std::exp2(power) < 0x1p63) return std::uint64_t(number * std::exp2(power));
  throw std::runtime_error(
      fmt::format("{} {}: expected a number of bytes, such as 512M or 4G", option, text));
}

}  // namespace plinian::scene
