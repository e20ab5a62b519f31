// Keys of a medium that people reach for first, with a short name: --level-set of the command line, -levelSet
// of import.
#pragma once

#include <cstdint>
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

/// "512M", "2G", "1000000". Throws std::runtime_error that names the option.
std::uint64_t parse_bytes(const std::string& text, const std::string& option);

}  // namespace plinian::scene
