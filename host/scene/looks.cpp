// Looks from JSON, and onto nodes.
#include "host/scene/looks.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "core/scene/nearest_word.h"
#include "core/scene/parameter_json.h"
#include "core/scene/preset.h"
#include "core/scene/scene_parameters.h"
#include "host/graph/graph_error.h"
#include "host/graph/values/hash.h"
#include "host/scene/placed.h"
#include "host/scene/preset_writer.h"
#include "host/scene/snapshot.h"

namespace plinian::scene {

namespace fs = std::filesystem;
using graph::GraphError;
using nlohmann::json;

namespace {

constexpr int look_major = 1, look_minor = 0;

// What says how a medium looks; each is an attribute of the node of the same name.
const std::vector<std::string> keys = {"density_scale",
                                       "albedo",
                                       "extinction",
                                       "sigma_s",
                                       "sigma_a",
                                       "phase",
                                       "g",
                                       "g_back",
                                       "blend",
                                       "emission_scale",
                                       "emission_exposure",
                                       "temperature_scale",
                                       "temperature_offset"};

const Parameter<MediumDescription>& parameter(const std::string& key) {
  return *find_parameter(medium_parameters(), key);
}

std::vector<std::string> look_folders() {
  std::vector<std::string> folders = preset_folders();
  for (std::string& folder : folders) folder += "/looks";
  return folders;
}

// As setAttr takes it.
std::string words_of(const std::string& key, const MediumDescription& medium) {
  std::string words = to_text(parameter(key).spec, *parameter(key).get(medium));
  std::replace(words.begin(), words.end(), ',', ' ');
  return words;
}

const graph::Node& medium_node(graph::Session& session, const std::string& name) {
  const graph::Node& node = session.graph().get(name);
  if (node.type->name() != "medium" || node.type->is_unknown())
    throw GraphError(node.name + " is no medium: looks are for media");
  return node;
}

void check_version(const json& file, const std::string& path) {
  const json* version = file.is_object() && file.contains("plinian_look") ? &file["plinian_look"] : nullptr;
  if (!version || !version->is_object() || !version->contains("major") ||
      !(*version)["major"].is_number_integer())
    throw std::runtime_error(path + ": not a look: it needs \"plinian_look\": {\"major\": 1, \"minor\": 0}");
  if ((*version)["major"] != look_major)
    throw std::runtime_error(fmt::format("{}: plinian_look.major: this program reads version {}, not {}",
                                         path, look_major, (*version)["major"].dump()));
}

}  // namespace

std::vector<std::string> look_names() {
  return preset_names(look_folders());
}

Look load_look(const std::string& name_or_path) {
  Look look;
  look.path = name_or_path;
  if (name_or_path.find('/') == name_or_path.npos && !name_or_path.ends_with(".json")) {
    std::error_code error;
    look.path.clear();
    for (const std::string& folder : look_folders())
      if (const fs::path path = fs::path(folder) / (name_or_path + ".json");
          look.path.empty() && fs::is_regular_file(path, error))
        look.path = path.string();
    if (look.path.empty())
      throw std::runtime_error(fmt::format("{}: no such look{}; there are: {}", name_or_path,
                                           did_you_mean(name_or_path, look_names()), join(look_names())));
  }
  const json file = read_json_file(look.path);
  check_version(file, look.path);
  look.name = fs::path(look.path).stem().string();
  for (const auto& [key, value] : file.items()) {
    // A file is known by its name in the folder: copies keep what the original says inside.
    if (key.starts_with('_') || key == "plinian_look" || (key == "name" && value.is_string())) continue;
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      throw std::runtime_error(fmt::format("{}: {}: unknown key{}", look.path, key, did_you_mean(key, keys)));
    for (const std::string& other : parameter(key).spec.excludes)
      if (file.contains(other))
        throw std::runtime_error(fmt::format("{}: {}: cannot stand beside {}", look.path, key, other));
    parameter(key).set(look.medium, read_parameter(parameter(key).spec, value, look.path + ": " + key));
  }
  graph::Hasher hash;
  for (const std::string& key : keys)
    if (parameter(key).get(look.medium)) hash.add(std::string_view(key + " " + words_of(key, look.medium)));
  look.hash = fmt::format("{:016x}", hash.result().low);
  return look;
}

void apply_look(graph::Session& session, const std::string& name, const Look& look) {
  const graph::Node& node = medium_node(session, name);
  PresetWriter writer(session, node);
  for (const std::string& key : keys) {
    const bool given = parameter(key).get(look.medium).has_value();
    if (given || key != "density_scale") writer.write(key, given ? words_of(key, look.medium) : "");
  }
  writer.write("coefficients", look.medium.sigma_s || look.medium.sigma_a ? "sigma" : "albedo_extinction");
  writer.write("look", graph::quote(look.name));
  writer.write("look_hash", graph::quote(look.hash));
  writer.tell_left();
}

const graph::Node* medium_for_looks(const graph::Graph& graph) {
  for (const graph::NodeId id : graph.selection())
    if (graph.find(id)->type->name() == "medium") return graph.find(id);
  return first_of_type(graph, "medium");
}

std::string look_text(graph::Session& session, const std::string& name, const std::string& look) {
  const graph::Node& node = medium_node(session, name);
  const Placed placed(session.graph(), session.evaluator());
  const bool by_sigma = placed.number(placed.plug(node, "coefficients")) != 0.0;
  nlohmann::ordered_json file = {{"plinian_look", {{"major", look_major}, {"minor", look_minor}}},
                                 {"name", look}};
  for (const std::string& key : keys) {
    if (key == "density_scale") continue;
    if (key == (by_sigma ? "albedo" : "sigma_s") || key == (by_sigma ? "extinction" : "sigma_a")) continue;
    const graph::Plug plug = placed.plug(node, key);
    const std::string words = graph::write_value(session.graph().attribute(plug).spec, placed.value(plug));
    std::string value = words;
    std::replace(value.begin(), value.end(), ' ', ',');
    file[key] = to_json(parameter(key).spec,
                        read_parameter(parameter(key).spec, json_from_text(value), name + "." + key));
  }
  return file.dump(2) + "\n";
}

std::vector<std::string> changed_looks(graph::Session& session) {
  std::vector<std::string> lines;
  for (const graph::Node* node : session.graph().nodes()) {
    if (node->type->name() != "medium" || node->type->is_unknown()) continue;
    const auto text = [&](const char* attribute) {
      return std::get<std::string>(node->value(node->schema->find(attribute)));
    };
    const std::string name = text("look");
    if (name.empty()) continue;
    try {
      if (load_look(name).hash != text("look_hash"))
        lines.push_back(
            fmt::format("{}: the look '{}' says something else now than when it was put on; 'preset apply "
                        "{} {}' takes it as it is now",
                        node->name, name, name, node->name));
    } catch (const std::runtime_error& error) {
      lines.push_back(fmt::format("{}: its look: {}", node->name, error.what()));
    }
  }
  return lines;
}

}  // namespace plinian::scene
