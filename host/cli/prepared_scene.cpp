// Scenes from arguments.
#include "host/cli/prepared_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <stdexcept>

#include "core/media/frame_sequence.h"
#include "core/scene/nearest_word.h"
#include "core/scene/preset.h"
#include "core/scene/quality_parameters.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_loader.h"
#include "core/scene/scene_parameters.h"
#include "host/cli/console.h"
#include "host/cli/interruption.h"
#include "host/cli/progress.h"
#include "host/cli/reader_badges.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"
#include "host/graph/values/file_path.h"
#include "host/scene/import_description.h"
#include "host/scene/missing_types.h"
#include "host/scene/quality_set.h"
#include "host/scene/volume_options.h"

namespace plinian::cli {

namespace fs = std::filesystem;

namespace {

bool is_scene(const std::string& input) {
  return input.ends_with(".plinian");
}

// The quality set that a preset's name turns on.
std::string set_of(const std::string& preset) {
  return preset == "high" ? "high" : "fast";
}

template <class T>
bool declares(const std::vector<Parameter<T>>& table, const std::string& key) {
  return find_parameter(table, key) != nullptr;
}

// Whether a key is one of the description's own; else it names an attribute of a node.
bool is_described(const SceneDescription& description, const std::string& key) {
  const auto dot = key.find('.');
  if (dot == key.npos) return true;
  const std::string object = key.substr(0, dot), name = key.substr(dot + 1);
  if (object == "camera") return declares(camera_parameters(), name);
  const auto& media = description.media;
  const bool medium =
      object == "medium" || object == "media" ||
      std::any_of(media.begin(), media.end(), [&](const auto& m) { return m.name == object; });
  if (medium) return declares(medium_parameters(), name) || name.starts_with("shape.");
  const auto& lights = description.lights;
  const bool light = object == "lights" || std::any_of(lights.begin(), lights.end(),
                                                       [&](const auto& l) { return l.name == object; });
  return light && (object == "lights" || declares(light_parameters(), name));
}

// The camera that camera.azimuth or camera.elevation moves: what a description places a camera by moves one
// that is there as well.
std::optional<std::string> placed_camera_of(const graph::Graph& graph, const std::string& key) {
  const auto dot = key.find('.');
  if (dot == key.npos || (key.substr(dot) != ".azimuth" && key.substr(dot) != ".elevation")) return {};
  const graph::Node* node = graph.find(key.substr(0, dot));
  return node && node->type->name() == "camera" ? std::optional(node->name) : std::nullopt;
}

// A scene may call its cameras anything, or have none.
std::string no_camera(const graph::Graph& graph, const SceneEdit& edit) {
  std::vector<std::string> cameras;
  for (const graph::Node* node : graph.nodes())
    if (node->type->name() == "camera") cameras.push_back(node->name);
  if (!cameras.empty())
    return fmt::format("{}: no camera is called 'camera'; there are: {}", edit.where, join(cameras));
  return edit.where +
         ": the scene has no camera: the one that is placed to show everything cannot be set; a script with "
         "createNode camera -name camera, frameView and save gives it one";
}

// What drives an attribute that is to be set for one picture, and what to do.
void refuse_driven(const graph::Graph& graph, const graph::Plug& plug, const SceneEdit& edit) {
  for (const graph::Plug& leaf : graph::leaf_plugs(graph, plug))
    for (const graph::Input& input : graph.find(leaf.node)->inputs_of(leaf.attribute, leaf.element)) {
      if (leaf.component >= 0 && input.component >= 0 && leaf.component != input.component) continue;
      const graph::Node& driver = *graph.find(input.source.node);
      const bool keyed = driver.type->name() == "animCurve";
      throw std::runtime_error(
          fmt::format("{}: {} is {} {}, which would win: a script with '{} {}' and save makes a scene in "
                      "which it can be set",
                      edit.where, graph.name_of(leaf), keyed ? "keyed by" : "driven by",
                      keyed ? driver.name : graph.name_of(input.source), keyed ? "cutKey" : "disconnectAttr",
                      graph.name_of(leaf)));
    }
}

// A namespace stands for all that is in it.
std::vector<std::string> by_namespace(const std::vector<std::string>& names) {
  std::vector<std::string> result;
  for (const std::string& name : names) {
    const std::size_t colon = name.find(':');
    const std::string shown = colon == name.npos ? name : name.substr(0, colon + 1) + "*";
    if (std::find(result.begin(), result.end(), shown) == result.end()) result.push_back(shown);
  }
  return result;
}

// Where the attribute is that an option for a volume means, in a scene of nodes; empty where nowhere.
std::string option_in_scene(const graph::Graph& graph, const SceneEdit& edit) {
  if (!edit.where.starts_with("--") || edit.where.find(' ') != edit.where.npos) return "";
  const std::string attribute = edit.key.substr(edit.key.rfind('.') + 1);
  for (const graph::Node* node : graph.nodes())
    if ((node->type->name() == "volumeRead" || node->type->name() == "volumeNoise") &&
        node->schema->find(attribute) != graph::no_attribute)
      return node->name + "." + attribute;
  return "";
}

graph::Plug plug_of(const graph::Graph& graph, const SceneEdit& edit) {
  const auto dot = edit.key.find('.');
  const std::string node = edit.key.substr(0, dot);
  const graph::Node* named = graph.find(node);
  if (!named || named->schema->find(edit.key.substr(dot + 1)) == graph::no_attribute)
    if (const std::string there = option_in_scene(graph, edit); !there.empty())
      throw std::runtime_error(
          fmt::format("{}: is for a volume; the scene says it by an attribute: --set {}={}", edit.where,
                      there, edit.value));
  if (dot == edit.key.npos || !graph.find(node)) {
    if (node == "camera" && dot != edit.key.npos) throw std::runtime_error(no_camera(graph, edit));
    std::vector<std::string> names;
    for (const graph::Node* known : graph.nodes()) names.push_back(known->name);
    if (node == "settings")
      throw std::runtime_error(
          edit.where +
          ": the scene has no settings: --size sets the size, and a script with createNode "
          "renderSettings -name settings and save gives it some");
    std::string meant = did_you_mean(node, names);
    for (const std::string& name : names)
      if (meant.empty() && name.ends_with(":" + node)) meant = " (did you mean '" + name + "'?)";
    throw std::runtime_error(fmt::format("{}: nothing is called '{}'{}; there are: map, view, {}", edit.where,
                                         node, meant, join(by_namespace(names))));
  }
  try {
    return graph.plug(edit.key);
  } catch (const graph::GraphError& error) {
    // What places a camera is no attribute of it, and is mistyped as easily.
    std::string said = error.what();
    // What lists them in a script.
    if (const std::size_t advice = said.find("; getAttr "); advice != said.npos)
      said = fmt::format("{}; 'plinian plugins --type {}' lists those it has", said.substr(0, advice),
                         graph.find(node)->type->name());
    const auto meant = node == "camera" && said.find("did you mean") == said.npos
                           ? nearest_word(edit.key.substr(dot + 1), parameter_names(camera_parameters()))
                           : std::nullopt;
    throw std::runtime_error(edit.where + ": " + said +
                             (meant ? " (did you mean 'camera." + *meant + "'?)" : ""));
  }
}

// Reads a scene that was saved.
void open_scene(PreparedScene& scene, const SceneArguments& arguments) {
  scene::Workspace& workspace = *scene.workspace;
  const std::string set = set_of(arguments.preset);
  workspace.view().quality = set;
  workspace.view().skip_unknown = arguments.skip_unknown;
  if (!arguments.size.empty()) workspace.view().size = parse_size(arguments.size);
  // The scene's own sets have the names fast and high.
  const bool foreign = arguments.preset != set;
  Preset preset;
  if (foreign) preset = load_preset(arguments.preset, preset_folders());
  for (const std::string& warning : preset.warnings) warn(warning);
  std::vector<std::string> warnings;
  workspace.session().on_warning = [&](const std::string& line) { warnings.push_back(line); };
  workspace.session().open_scene(arguments.input);
  workspace.session().on_warning = warn;
  // A picture without a shape looks like one of another scene: nobody gets that who did not ask for it.
  const std::string missing = scene::missing_types(workspace.session().graph());
  if (!missing.empty() && !arguments.skip_unknown)
    throw std::runtime_error(fmt::format(
        "{}: {}{}: put it into a folder of $PLINIAN_PLUGIN_PATH, or leave it out with --skip-unknown",
        arguments.input, missing, warnings.empty() ? "" : "; " + warnings.front()));
  for (const std::string& line : warnings) warn(line);
  if (foreign) scene::write_quality(workspace.session(), set, preset.quality);
  for (const SceneEdit& edit : edits_of(arguments)) apply_edit(workspace, edit);
}

// Makes the nodes that anything else stands for.
void import_input(PreparedScene& scene, const SceneArguments& arguments) {
  scene::Workspace& workspace = *scene.workspace;
  // Everything that is wrong with the words is told before anything is read that takes time.
  const Quality quality = prepare_quality(arguments, arguments.preset);
  SceneDescription description = describe_input(arguments.input);
  std::vector<SceneEdit> of_nodes;
  for (const SceneEdit& edit : edits_of(arguments)) {
    if (is_quality_key(edit.key)) continue;
    if (is_described(description, edit.key))
      set_scene_value(description, edit.key, edit.value, edit.where);
    else
      of_nodes.push_back(edit);
  }
  if (!arguments.size.empty()) description.size = parse_size(arguments.size);
  scene::ImportOptions options;
  options.vdb_time_limit_s = arguments.vdb_time_limit_s;
  if (!arguments.vdb_memory_limit.empty())
    options.vdb_memory_limit_bytes = scene::parse_bytes(arguments.vdb_memory_limit, "--vdb-memory-limit");
  options.nodes_made = [&] {
    for (const SceneEdit& edit : of_nodes) plug_of(workspace.session().graph(), edit);
  };
  scene::ImportReport report;
  {
    ProgressBar bar("reading");
    options.progress = [&](double share) { return bar(share); };
    report = import_description(workspace.session(), description, options);
  }
  workspace.view().quality = set_of(arguments.preset);
  scene::write_quality(workspace.session(), workspace.view().quality, quality);
  for (const SceneEdit& edit : of_nodes) apply_edit(workspace, edit);
  for (const std::string& line : report.notes) note(line);
  for (const std::string& line : report.warnings) warn(line);
  scene.notes = std::move(report.notes);
  scene.warnings.insert(scene.warnings.end(), report.warnings.begin(), report.warnings.end());
  scene.seed = report.seed;
}

// What is shown in place of frames that are missing; once, where it is the same for many.
void tell_badges(PreparedScene& scene) {
  for (const std::string& line : reader_badges(scene.workspace->session())) {
    if (std::find(scene.warnings.begin(), scene.warnings.end(), line) != scene.warnings.end()) continue;
    scene.warnings.push_back(line);
    warn(line);
  }
}

}  // namespace

void apply_edit(scene::Workspace& workspace, const SceneEdit& edit) {
  graph::Session& session = workspace.session();
  if (is_quality_key(edit.key)) {
    Quality quality = scene::quality_of(session, workspace.view().quality);
    if (!set_quality(quality, edit.key, edit.value, edit.where))
      throw std::runtime_error(fmt::format("{}: unknown key{}; --help-quality lists them", edit.where,
                                           did_you_mean(edit.key, parameter_names(quality_parameters()))));
    if (const graph::Node* settings = scene::first_of_type(session.graph(), "renderSettings")) {
      const graph::Plug plug = graph::Graph::plug(*settings, workspace.view().quality + "." + edit.key);
      refuse_driven(session.graph(), plug, edit);
      if (const std::string problem = session.editor().set_problem(plug); !problem.empty())
        throw std::runtime_error(edit.where + ": " + problem);
    }
    return scene::write_quality(session, workspace.view().quality, quality);
  }
  if (const auto camera = placed_camera_of(session.graph(), edit.key)) {
    try {
      session.execute(fmt::format("frameView -camera {} -{} {}", *camera,
                                  edit.key.substr(edit.key.rfind('.') + 1), edit.value));
    } catch (const graph::GraphError& error) {
      throw std::runtime_error(edit.where + ": " + error.what());
    }
    return;
  }
  const graph::Plug plug = plug_of(session.graph(), edit);
  refuse_driven(session.graph(), plug, edit);
  // A look is put on as a whole: its name alone would change nothing.
  const bool look = edit.key.ends_with(".look");
  const graph::AttributeType type = session.graph().attribute(plug).spec.type;
  std::string words = edit.value;
  if (type == graph::AttributeType::string || type == graph::AttributeType::path)
    words = graph::quote(words);
  else if (type != graph::AttributeType::ramp)
    std::replace(words.begin(), words.end(), ',', ' ');
  try {
    session.execute(look ? "preset apply " + words + " " + edit.key.substr(0, edit.key.rfind('.'))
                         : "setAttr " + edit.key + " " + words);
  } catch (const graph::GraphError& error) {
    throw std::runtime_error(edit.where + ": " + error.what());
  }
}

void tell_shown_frames(PreparedScene& scene) {
  graph::Session& session = scene.workspace->session();
  for (const graph::Node* node : volume_readers(session.graph())) {
    const auto frame = reader_output(session, *node, "frame");
    if (!frame) continue;
    const std::string file = graph::expand_path(
        std::get<std::string>(node->value(node->schema->find("file"))), session.scene_folder());
    const auto pattern = FramePattern::parse(file);
    if (!pattern || fs::exists(file)) continue;
    const std::vector<int> frames = pattern->frames_on_disk();
    if (frames.empty()) continue;
    scene.notes.push_back(fmt::format("{}: the picture is of frame {} (--frames {}-{} makes one of each)",
                                      fs::path(file).filename().string(), graph::number_of(*frame),
                                      frames.front(), frames.back()));
    note(scene.notes.back());
  }
}

SceneSnapshot take_snapshot(PreparedScene& scene) {
  graph::Session& session = scene.workspace->session();
  {
    ProgressBar bar("reading");
    if (!compute_contributions(session, scene.workspace->view(), [&](double share) { return bar(share); }))
      throw SceneLoadCancelled();
  }
  scene::BuiltSnapshot built = build_snapshot(session, scene.workspace->view());
  if (!built.problems.empty()) throw std::runtime_error(built.problems.front());
  for (const std::string& line : built.left_out) {
    if (std::find(scene.warnings.begin(), scene.warnings.end(), line) != scene.warnings.end()) continue;
    warn(line);
    scene.warnings.push_back(line);
  }
  for (const std::string& line : built.notes) {
    if (std::find(scene.notes.begin(), scene.notes.end(), line) != scene.notes.end()) continue;  // of frames
    note(line);
    scene.notes.push_back(line);
  }
  tell_badges(scene);
  return std::move(built.snapshot);
}

PreparedScene prepare_scene(const SceneArguments& arguments, FirstSnapshot first) {
  const auto start = std::chrono::steady_clock::now();
  refuse_script(arguments.input);
  std::string save_as = arguments.save_as;
  if (!save_as.empty() && fs::path(save_as).extension().empty() && !fs::path(save_as).filename().empty())
    save_as += ".plinian";
  if (!save_as.empty() && !is_scene(save_as))
    throw std::runtime_error(save_as + ": the name of a scene ends in .plinian");
  PreparedScene scene;
  scene.workspace = std::make_unique<scene::Workspace>();
  scene.workspace->session().on_warning = [](const std::string& line) { warn(line); };
  scene.workspace->session().evaluator().set_interrupt(&interrupt_flag());
  if (is_scene(arguments.input))
    open_scene(scene, arguments);
  else
    import_input(scene, arguments);
  if (first == FirstSnapshot::taken) scene.snapshot = take_snapshot(scene);
  if (!save_as.empty()) {
    scene.workspace->session().save_scene(save_as);
    note(save_as + ": the scene, saved");
  }
  scene.load_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return scene;
}

}  // namespace plinian::cli
