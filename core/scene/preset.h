// Presets: quality settings in JSON files, found by name or by path.
//
//   { "plinian_preset": {"major": 1, "minor": 0}, "base": "fast", "map": {"threshold": 0.02}, "view": {...} }
//
// What a preset leaves out, it takes from its base (`fast` where it names none). Keys that begin with `_` are
// comments.
#pragma once

#include <string>
#include <vector>

#include "core/scene/quality.h"

namespace plinian {

struct Preset {
  Quality quality;
  std::string path;                   // of the file
  std::vector<std::string> warnings;  // keys of a newer minor version that were left aside; that it stands in
                                      // for the program's own of that name
};

inline constexpr int preset_major = 1, preset_minor = 0;  // of the format that this program writes

/// Reads a preset. name_or_path: a path where it ends in .json or holds a slash, else the name of a file
/// NAME.json in one of the folders, the first that has it. Throws std::runtime_error with one line: no such
/// preset (listing those there are), unknown key, wrong type, out of range, newer major version.
Preset load_preset(const std::string& name_or_path, const std::vector<std::string>& folders);

/// Names of the presets in the folders, sorted, each once.
std::vector<std::string> preset_names(const std::vector<std::string>& folders);

/// Where presets are looked for: `presets` in the folders of $PLINIAN_PATH, then in the user's
/// ($XDG_CONFIG_HOME/plinian or ~/.config/plinian), then in share/plinian beside the folder of the running
/// program.
std::vector<std::string> preset_folders();

/// A preset file with every quality parameter in it.
std::string preset_text(const Quality& quality);

/// Sets one parameter from text ("map.threshold", "0.02"). Returns false if there is none of that name.
/// where: what errors begin with; empty: "--set NAME". Throws std::runtime_error where the value has a wrong
/// type or is out of range.
bool set_quality(Quality& quality, const std::string& name, const std::string& value,
                 const std::string& where = "");

}  // namespace plinian
