// Scenes from JSON.
#include "core/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "core/scene/nearest_word.h"
#include "core/scene/parameter_json.h"
#include "core/scene/scene_parameters.h"

namespace plinian {

using nlohmann::json;

namespace {

constexpr int max_side = 32768;  // [pixels] of a picture

void expect_object(const json& value, const std::string& where) {
  if (!value.is_object())
    throw std::runtime_error(fmt::format("{}: expected an object, got {}", where, short_text(value)));
}

// Reads the keys of an object that the table knows; `prefix` is "FILE: lights[0].". Other keys are errors,
// unless they are in `elsewhere`.
template <class T>
void read_object(const std::vector<Parameter<T>>& table, const json& object, const std::string& prefix,
                 T& target, const std::vector<std::string>& elsewhere = {}) {
  for (const auto& [key, value] : object.items()) {
    if (key.starts_with('_') || std::find(elsewhere.begin(), elsewhere.end(), key) != elsewhere.end())
      continue;
    const auto* parameter = find_parameter(table, key);
    if (!parameter) {
      std::vector<std::string> known = parameter_names(table);
      known.insert(known.end(), elsewhere.begin(), elsewhere.end());
      throw std::runtime_error(prefix + key + ": unknown key" + did_you_mean(key, known));
    }
    for (const std::string& other : parameter->spec.excludes)
      if (object.contains(other))
        throw std::runtime_error(
            fmt::format("{}{}: cannot stand beside {}; give one of them", prefix, key, other));
    parameter->set(target, read_parameter(parameter->spec, value, prefix + key));
  }
}

// Numbers that shape a procedural medium; which there are depends on its kind, and it checks them.
void read_shape_value(MediumDescription& medium, const std::string& name, const json& value,
                      const std::string& where) {
  const ParameterSpec spec{.name = name, .type = ParameterType::real};
  medium.shape[name] = float(std::get<double>(read_parameter(spec, value, where)));
}

void read_medium(const json& object, const std::string& prefix, MediumDescription& medium,
                 std::vector<std::string> elsewhere = {}) {
  elsewhere.push_back("shape");
  read_object(medium_parameters(), object, prefix, medium, elsewhere);
  if (!object.contains("shape")) return;
  expect_object(object["shape"], prefix + "shape");
  for (const auto& [name, value] : object["shape"].items())
    if (!name.starts_with('_')) read_shape_value(medium, name, value, prefix + "shape." + name);
}

ivec2 read_size(const json& value, const std::string& where) {
  const ParameterSpec spec{
      .name = "size", .type = ParameterType::integer, .range = ParameterRange::closed(1, max_side)};
  if (!value.is_array() || value.size() != 2)
    throw std::runtime_error(fmt::format("{}: expected [width, height], got {}", where, short_text(value)));
  const auto side = [&](int i) {
    return std::get<int>(read_parameter(spec, value[std::size_t(i)], fmt::format("{}[{}]", where, i)));
  };
  return {side(0), side(1)};
}

// A name is the name of a layer and a word before a dot, so it must not be more than a word.
void check_name(const std::string& name, const std::string& where, std::set<std::string>& taken) {
  const bool word = !name.empty() && name.find_first_not_of(
                                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                         "0123456789_-") == std::string::npos;
  if (!word)
    throw std::runtime_error(fmt::format("{}: expected letters, digits, _ and - , got '{}'", where, name));
  static const std::set<std::string> reserved = {"camera", "map",           "view",      "medium",
                                                 "media",  "lights",        "ambient",   "emission",
                                                 "scene",  "transmittance", "background"};
  if (reserved.contains(name))
    throw std::runtime_error(fmt::format("{}: '{}' means something else here", where, name));
  if (!taken.insert(name).second) throw std::runtime_error(fmt::format("{}: '{}' is taken", where, name));
}

void add_default_lights(SceneDescription& scene) {
  scene.default_lights = true;
  scene.lights = {{.name = "key", .role = LightRole::key}, {.name = "rim", .role = LightRole::rim}};
}

}  // namespace

SceneDescription read_scene_file(const std::string& path) {
  const json file = read_json_file(path);
  const std::string prefix = path + ": ";
  expect_object(file, path);
  SceneDescription scene;
  scene.file = path;

  // The keys of a single medium may stand in the scene itself.
  std::vector<std::string> own = {"size", "camera", "lights", "media"};
  for (const auto& name : parameter_names(scene_parameters())) own.push_back(name);
  MediumDescription medium;
  read_medium(file, prefix, medium, own);
  bool medium_keys = false;
  for (const auto& [key, value] : file.items()) {
    if (const auto* parameter = find_parameter(scene_parameters(), key))
      parameter->set(scene, read_parameter(parameter->spec, value, prefix + key));
    medium_keys |= key == "shape" || find_parameter(medium_parameters(), key) != nullptr;
  }
  if (file.contains("media")) {
    if (medium_keys)
      throw std::runtime_error(prefix + "media: keys of a medium stand beside it; put them into it");
    const json& media = file["media"];
    if (!media.is_array())
      throw std::runtime_error(fmt::format("{}media: expected a list, got {}", prefix, short_text(media)));
    for (std::size_t i = 0; i < media.size(); ++i) {
      const std::string where = fmt::format("{}media[{}]", prefix, i);
      expect_object(media[i], where);
      read_medium(media[i], where + ".", scene.media.emplace_back());
    }
  } else {
    scene.media.push_back(medium);
  }
  std::set<std::string> taken;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    MediumDescription& one = scene.media[i];
    const std::string where = file.contains("media") ? fmt::format("{}media[{}].", prefix, i) : prefix;
    if (one.volume.empty()) throw std::runtime_error(where + "volume: the key is missing");
    one.folder = std::filesystem::path(path).parent_path().string();
    if (!one.name.empty())
      check_name(one.name, where + "name", taken);
    else if (scene.media.size() > 1)
      taken.insert(one.name = fmt::format("medium{}", i));
  }

  if (file.contains("camera")) {
    expect_object(file["camera"], prefix + "camera");
    read_object(camera_parameters(), file["camera"], prefix + "camera.", scene.camera);
  }
  if (file.contains("lights")) {
    const json& lights = file["lights"];
    if (!lights.is_array())
      throw std::runtime_error(fmt::format("{}lights: expected a list, got {}", prefix, short_text(lights)));
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const std::string where = fmt::format("{}lights[{}]", prefix, i);
      expect_object(lights[i], where);
      LightDescription& light = scene.lights.emplace_back();
      read_object(light_parameters(), lights[i], where + ".", light);
      if (lights[i].contains("name"))
        check_name(light.name, where + ".name", taken);
      else
        taken.insert(light.name = fmt::format("light{}", i));
    }
  } else {
    add_default_lights(scene);
  }
  if (file.contains("size")) scene.size = read_size(file["size"], prefix + "size");
  return scene;
}

SceneDescription describe_input(const std::string& input) {
  if (input.ends_with(".json")) return read_scene_file(input);
  SceneDescription scene;
  scene.media.push_back({.volume = input, .guess_orientation = true});
  add_default_lights(scene);
  return scene;
}

std::vector<std::string> scene_object_names(const SceneDescription& scene) {
  std::vector<std::string> names = {"camera", "medium", "lights"};
  for (const MediumDescription& medium : scene.media)
    if (!medium.name.empty()) names.push_back(medium.name);
  for (const LightDescription& light : scene.lights) names.push_back(light.name);
  return names;
}

void set_scene_value(SceneDescription& scene, const std::string& name, const std::string& value,
                     const std::string& start) {
  const std::string where = start.empty() ? "--set " + name : start;
  const json parsed = json_from_text(value);
  // Where a key is known elsewhere: "camera.azimuth" for azimuth, "key.exposure" for lights.key.exposure.
  const auto elsewhere = [&](const std::string& key) -> std::string {
    const auto meant = [](const std::string& name) { return " (did you mean '" + name + "'?)"; };
    const auto names = scene_object_names(scene);
    const auto inner = key.find('.');
    if (inner != std::string::npos && std::ranges::count(names, key.substr(0, inner))) return meant(key);
    if (find_parameter(camera_parameters(), key)) return meant("camera." + key);
    if (find_parameter(medium_parameters(), key)) return meant("medium." + key);
    if (find_parameter(light_parameters(), key)) return meant("lights." + key);
    return "";
  };
  const auto apply = [&](const auto& table, const std::string& key, auto& object) {
    const auto* parameter = find_parameter(table, key);
    if (!parameter)
      throw std::runtime_error(
          where + ": unknown key" +
          (elsewhere(key).empty() ? did_you_mean(key, parameter_names(table)) : elsewhere(key)) +
          "; there are: " + join(parameter_names(table)));
    // A text may look like a number or a list: --set medium.grid=2.
    const json& given = parameter->spec.type == ParameterType::text ? json(value) : parsed;
    set_parameter(table, *parameter, object, read_parameter(parameter->spec, given, where));
  };

  const auto dot = name.find('.');
  if (dot == std::string::npos) {
    if (name == "size")
      scene.size = read_size(parsed, where);
    else
      apply(scene_parameters(), name, scene);
    return;
  }
  const std::string object = name.substr(0, dot), key = name.substr(dot + 1);
  if (key == "name") throw std::runtime_error(where + ": names are given in scene files");
  bool known = object == "camera" || object == "medium" || object == "media" || object == "lights";
  if (object == "camera") apply(camera_parameters(), key, scene.camera);
  for (MediumDescription& medium : scene.media)
    if (object == "medium" || object == "media" || object == medium.name) {
      if (key.starts_with("shape."))
        read_shape_value(medium, key.substr(6), parsed, where);
      else
        apply(medium_parameters(), key, medium);
      known = true;
    }
  for (LightDescription& light : scene.lights)
    if (object == "lights" || object == light.name) {
      apply(light_parameters(), key, light);
      known = true;
    }
  if (!known) {
    const auto names = scene_object_names(scene);
    throw std::runtime_error(fmt::format("{}: nothing is called '{}'{}; there are: map, view, {}", where,
                                         object, did_you_mean(object, names), join(names)));
  }
}

}  // namespace plinian
