// How long a file's unit is and which way its up points: .vdb has no field for either, so it is guessed from
// who wrote the file. A guess says what it rests on; without anything to rest on it is y and a metre, and
// says so.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "core/media/vdb_task.h"

namespace plinian {

dmat4 VdbOrientation::world_from_medium() const {
  dmat4 world = glm::scale(dmat4(1.0), dvec3(file_unit));
  if (up_axis == 'z') world = world * glm::rotate(dmat4(1.0), -1.5707963267948966, dvec3(1.0, 0.0, 0.0));
  // A quarter turn has no sixteenths of an ulp in it.
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (std::abs(world[i][j]) < 1e-15 * file_unit) world[i][j] = 0.0;
  return world;
}

namespace vdb {
namespace {

std::string value_of(const std::map<std::string, std::string>& metadata, const char* key) {
  const auto found = metadata.find(key);
  return found == metadata.end() ? std::string() : found->second;
}

}  // namespace

VdbOrientation guess_orientation(const std::map<std::string, std::string>& file,
                                 const std::vector<VdbGridInfo>& grids) {
  VdbOrientation guess;
  const std::string up = value_of(file, up_axis_key), unit = value_of(file, file_unit_key);
  if (up == "y" || up == "z") {
    guess.up_axis = up[0];
    guess.up_assumed = false;
  }
  if (const double metres = std::strtod(unit.c_str(), nullptr); metres > 0.0 && std::isfinite(metres)) {
    guess.file_unit = metres;
    guess.unit_assumed = false;
  }
  if (!guess.up_assumed && !guess.unit_assumed) {
    guess.reason =
        fmt::format("{} is up and a unit is {:.6g} m, as the file says", guess.up_axis, guess.file_unit);
    return guess;
  }
  const std::string creator = value_of(file, "creator");
  const auto settle = [&](char axis, const std::string& program) {
    guess.up_axis = axis;
    guess.up_assumed = guess.unit_assumed = false;
    guess.reason = fmt::format("{} is up and a unit is 1 m, as in {}", axis, program);
  };
  const auto blender_key = file.lower_bound("blender/");
  const bool from_blender = blender_key != file.end() && blender_key->first.starts_with("blender/");
  if (from_blender || creator.find("Blender") != std::string::npos) {
    settle('z', creator.empty() ? "Blender (by its metadata)" : "Blender (creator: " + creator + ")");
    return guess;
  }
  if (creator.find("Houdini") != std::string::npos) {
    settle('y', "Houdini (creator: " + creator + ")");
    return guess;
  }
  for (const VdbGridInfo& grid : grids)
    if (grid.metadata.contains("_bifrost_volume_index")) {
      guess.up_axis = 'y';
      guess.up_assumed = false;
      guess.reason = "y is up, as in Bifrost (by its metadata), and a unit is 1 m, which is assumed";
      return guess;
    }
  guess.reason = "y is up and a unit is 1 m, both assumed: nothing in the file says";
  return guess;
}

}  // namespace vdb
}  // namespace plinian
