// The arguments that say what is rendered and how well, shared by the commands that render.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scene/quality.h"
#include "core/shared/glue.h"

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
  bool skip_unknown = false;     // nodes of plug-ins that are missing are left out
  std::string save_as;           // where the scene goes, .plinian; empty: nowhere
};

/// Declares INPUT and the options on `app`. with_preset: --preset and the options that change it.
void add_scene_arguments(CLI::App& app, SceneArguments& arguments, bool with_preset);

/// --set and the options that stand for one.
struct SceneEdit {
  std::string key, value;
  std::string where;  // what errors begin with: "--set KEY", "--grid"
};
/// In the order of the command line within each kind; --set comes last. Throws std::runtime_error where one
/// is no KEY=VALUE.
std::vector<SceneEdit> edits_of(const SceneArguments& arguments);

/// Whether a key is one of a quality set: map.threshold, view.step.
bool is_quality_key(const std::string& key);

/// The preset of that name or path with --set and the like applied.
Quality prepare_quality(const SceneArguments& arguments, const std::string& preset);

/// Every quality parameter and scene key, for --help-quality and --help-scene.
std::string quality_help();
std::string scene_help();

/// "512x256". Throws std::runtime_error that names the option.
ivec2 parse_size(const std::string& text, const std::string& option = "--size");
/// Says what to do with a script (.pln) where something else is wanted. Throws std::runtime_error.
void refuse_script(const std::string& input);

}  // namespace plinian::cli
