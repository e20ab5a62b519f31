// The command "preset": quality presets for renderSettings, and looks for media.
#include <filesystem>

#include "core/files/atomic_file.h"
#include "core/scene/nearest_word.h"
#include "core/scene/preset.h"
#include "core/scene/resources.h"
#include "host/graph/graph_error.h"
#include "host/scene/looks.h"
#include "host/scene/quality_set.h"
#include "host/scene/scene_commands.h"

namespace plinian::scene {

namespace fs = std::filesystem;
using graph::Arguments;
using graph::CommandResult;
using graph::GraphError;
using graph::Session;

namespace {

bool is_set(const std::string& name) {
  return name == "fast" || name == "high";
}

// The media that a look goes onto: the one that is named, else those that are selected, else the only one.
std::vector<std::string> targets(Session& session, const std::string& named) {
  if (!named.empty()) return {session.graph().get(named).name};
  std::vector<std::string> all, selected;
  for (const graph::Node* node : session.graph().nodes())
    if (node->type->name() == "medium") all.push_back(node->name);
  for (const graph::NodeId id : session.graph().selection())
    if (session.graph().find(id)->type->name() == "medium")
      selected.push_back(session.graph().find(id)->name);
  if (!selected.empty()) return selected;
  if (all.size() == 1) return all;
  throw GraphError(all.empty() ? "preset: there is no medium to put a look on"
                               : "preset: name the medium, or select it; there are: " + join(all));
}

CommandResult apply(Workspace& workspace, const std::string& name, const std::string& target) {
  Session& session = workspace.session();
  const auto presets = preset_names(preset_folders()), looks = look_names();
  const auto has = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const bool file = name.find('/') != name.npos || name.ends_with(".json");
  const bool onto_medium = !target.empty() && !is_set(target);
  // A name may be that of a preset and of a look; what it is for decides.
  const bool quality = is_set(target) || (!onto_medium && has(presets));
  if (!quality && !onto_medium && !has(looks) && !file) {
    std::vector<std::string> all = presets;
    all.insert(all.end(), looks.begin(), looks.end());
    throw GraphError("preset: there is no preset or look " + graph::shown(name) + did_you_mean(name, all) +
                     "; there are: " + join(all));
  }
  if (quality) {
    const Preset preset = load_preset(name, preset_folders());
    for (const std::string& warning : preset.warnings) session.warn(warning);
    const std::string set = !target.empty() ? target : is_set(name) ? name : workspace.view().quality;
    write_quality(session, set, preset.quality);
    return {set};
  }
  const Look look = load_look(name);
  const std::vector<std::string> nodes = targets(session, target);
  for (const std::string& node : nodes) apply_look(session, node, look);
  return nodes;
}

CommandResult save(Workspace& workspace, const std::string& name, const std::string& target) {
  if (name.empty() || name.find_first_of("/\\.") != name.npos)
    throw GraphError("preset: " + graph::shown(name) + " cannot name a preset: no dots and slashes");
  const fs::path user = user_config_folder();
  if (user.empty()) throw GraphError("preset: there is no folder of yours: set HOME or XDG_CONFIG_HOME");
  const bool onto_medium = !target.empty() && !is_set(target);
  const fs::path folder = user / "presets" / (onto_medium ? "looks" : "");
  const std::string path = (folder / (name + ".json")).lexically_normal().string();
  std::string text;
  if (onto_medium) {
    text = look_text(workspace.session(), target, name);
  } else {
    Quality quality = quality_of(workspace.session(), target.empty() ? workspace.view().quality : target);
    quality.name = name;
    text = preset_text(quality);
  }
  std::error_code error;
  fs::create_directories(folder, error);
  write_file(path, std::string_view(text));
  return {path};
}

CommandResult list(const Session& session) {
  CommandResult lines;
  for (const std::string& name : preset_names(preset_folders())) lines.push_back("preset " + name);
  for (const std::string& name : look_names()) lines.push_back("look " + name);
  session.note(
      "preset apply NAME puts a preset on the quality set that is on, or a look on the medium; preset "
      "apply NAME MEDIUM names the medium");
  return lines;
}

}  // namespace

void add_preset_commands(Workspace& workspace) {
  using enum graph::ArgumentKind;
  workspace.session().commands().add(
      {.name = "preset",
       .help = "Puts a quality preset on a set of renderSettings, or a look on media; saves one; lists them.",
       .parameters = {{"action", text, "apply, save or list"},
                      {"name", text, "of the preset or look, or a file", true},
                      {"target", text,
                       "fast or high, or a medium; else the set that is on, or what is selected", true}},
       .run = [&workspace](Session& session, const Arguments& arguments) -> CommandResult {
         const std::string action = arguments.text("action"), name = arguments.text("name");
         if (action == "list") return list(session);
         if (action != "apply" && action != "save")
           throw GraphError("preset: there is no action " + graph::shown(action) +
                            "; there are: apply, save, list");
         if (name.empty()) throw GraphError("preset: " + action + " needs a name");
         try {
           return action == "apply" ? apply(workspace, name, arguments.text("target"))
                                    : save(workspace, name, arguments.text("target"));
         } catch (const GraphError&) {
           throw;
         } catch (const std::runtime_error& error) {
           throw GraphError(std::string("preset: ") + error.what());
         }
       }});
}

}  // namespace plinian::scene
