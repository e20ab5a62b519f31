// The arguments that say what is rendered and how well, shared by the commands that render.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene_loader.h"
#include "core/scene/snapshot.h"

namespace CLI {
class App;
}

namespace plinian::cli {

struct SceneArguments {
  std::string input;
  std::string preset = "fast";
  std::string size;                                         // WIDTHxHEIGHT
  std::vector<std::string> set;                             // KEY=VALUE
  std::vector<std::pair<std::string, std::string>> values;  // of options that stand for a scene key:
                                                            // "--grid" and its value
  double vdb_time_limit_s = 0.0;
  std::string vdb_memory_limit;  // "2G"
};

/// Declares INPUT and the options on `app`. with_preset: --preset and the options that change it.
void add_scene_arguments(CLI::App& app, SceneArguments& arguments, bool with_preset);

struct PreparedScene {
  LoadedScene loaded;    // its snapshot has the quality of the preset
  double load_ms = 0.0;  // wall clock
};

/// Reads the scene, its volumes and the preset, and says aloud what was assumed. Throws std::runtime_error.
PreparedScene prepare_scene(const SceneArguments& arguments);

/// The preset of that name or path with --set and the like applied.
Quality prepare_quality(const SceneArguments& arguments, const std::string& preset);

/// Every quality parameter and scene key, for --help-quality and --help-scene.
std::string quality_help();
std::string scene_help();

/// "512x256". Throws std::runtime_error.
ivec2 parse_size(const std::string& text);
/// "512M", "2G", "1000000". Throws std::runtime_error that names the option.
std::uint64_t parse_bytes(const std::string& text, const std::string& option);

}  // namespace plinian::cli
