// Keys of a medium that people reach for first, with a short name: --level-set of the command line, -levelSet
// of import.
#pragma once

#include <span>
#include <string>

namespace plinian::scene {

struct VolumeOption {
  const char* name;        // "level-set"
  const char* key;         // of set_scene_value(): "medium.level_set"
  const char* value_name;  // "refuse|fog"
  const char* help;
};

std::span<const VolumeOption> volume_options();

/// The name as flags of commands are spelled: "levelSet".
std::string flag_name(const VolumeOption& option);

}  // namespace plinian::scene
