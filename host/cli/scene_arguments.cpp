// Scene arguments: from words to a snapshot.
#include "host/cli/scene_arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "core/scene/nearest_word.h"
#include "core/scene/preset.h"
#include "core/scene/quality_parameters.h"
#include "core/scene/scene_parameters.h"
#include "host/cli/console.h"
#include "host/scene/volume_options.h"

namespace plinian::cli {

namespace {

// Options that are another word for --set, beside those of host/scene/volume_options.h.
struct ShortOption {
  const char *option, *key, *value_name, *help;
};
constexpr ShortOption quality_options[] = {
    {"--encoding", "map.encoding", "tfm|atfm", "how light is stored along a ray"},
    {"--coefficients", "map.coefficients", "N", "cosine terms per texel, 2 to 16"},
    {"--threshold", "map.threshold", "T", "transmittance under which a light ray counts as dead"},
};

// Two lines per parameter. value_text: what stands in brackets behind what it may be.
template <class T>
std::string list_parameters(const std::string& prefix, const std::vector<Parameter<T>>& table,
                            const std::function<std::string(const Parameter<T>&)>& value_text = {}) {
  std::string text;
  for (const auto& parameter : table) {
    const ParameterSpec& spec = parameter.spec;
    text += fmt::format("  {:<26} {}", prefix + spec.name, expectation(spec));
    if (!spec.unit.empty()) text += " [" + spec.unit + "]";
    if (value_text) text += " (" + value_text(parameter) + ")";
    text += fmt::format("\n  {:<26}   {}\n", "", spec.help);
  }
  return text;
}

}  // namespace

bool is_quality_key(const std::string& key) {
  return key.starts_with("map.") || key.starts_with("view.");
}

std::vector<SceneEdit> edits_of(const SceneArguments& arguments) {
  std::vector<SceneEdit> edits;
  for (const auto& [option, value] : arguments.values) {
    for (const scene::VolumeOption& known : scene::volume_options())
      if (option == "--" + std::string(known.name)) edits.push_back({known.key, value, option});
    for (const ShortOption& known : quality_options)
      if (option == known.option) edits.push_back({known.key, value, option});
  }
  for (const std::string& text : arguments.set) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
      throw std::runtime_error(fmt::format("--set {}: expected KEY=VALUE, such as medium.albedo=0.5", text));
    edits.push_back({text.substr(0, equals), text.substr(equals + 1), "--set " + text.substr(0, equals)});
  }
  return edits;
}

void add_scene_arguments(CLI::App& app, SceneArguments& arguments, bool with_preset) {
  app.add_option(
         "INPUT", arguments.input,
         "a .vdb file, a sequence of them (smoke.####.vdb), a procedural medium (ash, cloud, sandstorm, "
         "explosion), a .plinian or a .json scene")
      ->required();
  const auto add = [&](const std::string& name, const auto& option, const char* group) {
    app.add_option_function<std::string>(
           name, [&arguments, name](const std::string& value) { arguments.values.emplace_back(name, value); },
           option.help)
        ->type_name(option.value_name)
        ->group(group);
  };
  if (with_preset)
    app.add_option("--preset", arguments.preset, "fast, high, one of your own, or a file")
        ->type_name("NAME|FILE")
        ->capture_default_str()
        ->group("Quality");
  for (const ShortOption& option : quality_options) add(option.option, option, "Quality");
  for (const scene::VolumeOption& option : scene::volume_options())
    add("--" + std::string(option.name), option, "Volume");
  app.add_option("--vdb-time-limit", arguments.vdb_time_limit_s, "for reading a .vdb (grows with the file)")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber)
      ->group("Volume");
  app.add_option("--vdb-memory-limit", arguments.vdb_memory_limit, "for reading a .vdb, such as 4G")
      ->type_name("BYTES")
      ->group("Volume");
  app.add_option("--size", arguments.size, "of the picture (512x512, or what the scene says)")
      ->type_name("WIDTHxHEIGHT");
  app.add_option(
         "--set", arguments.set,
         "any value of scene or preset: medium.albedo=0.5,0.5,0.5, key.exposure=1, map.threshold=0.02, or "
         "NODE.ATTRIBUTE=VALUE; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  app.add_flag("--skip-unknown", arguments.skip_unknown,
               "where a scene's plug-ins are missing, render what there is without them");
  app.add_flag_callback(
      "--help-quality",
      [] {
        print(quality_help());
        throw CLI::Success();
      },
      "list what presets hold");
  app.add_flag_callback(
      "--help-scene",
      [] {
        print(scene_help());
        throw CLI::Success();
      },
      "list what scenes hold");
}

Quality prepare_quality(const SceneArguments& arguments, const std::string& name) {
  Preset preset = load_preset(name, preset_folders());
  for (const std::string& warning : preset.warnings) warn(warning);
  for (const SceneEdit& edit : edits_of(arguments))
    if (is_quality_key(edit.key) && !set_quality(preset.quality, edit.key, edit.value, edit.where))
      throw std::runtime_error(fmt::format("{}: unknown key{}; --help-quality lists them", edit.where,
                                           did_you_mean(edit.key, parameter_names(quality_parameters()))));
  return preset.quality;
}

std::string quality_help() {
  const auto folders = preset_folders();
  const auto names = preset_names(folders);
  std::vector<Preset> presets;
  for (const std::string& name : names) presets.push_back(load_preset(name, folders));
  std::string text = "Quality parameters, for presets and --set:\n";
  text += list_parameters<Quality>("", quality_parameters(), [&](const Parameter<Quality>& parameter) {
    std::vector<std::string> values;
    for (std::size_t i = 0; i < presets.size(); ++i)
      values.push_back(names[i] + " " + to_text(parameter.spec, *parameter.get(presets[i].quality)));
    return join(values);
  });
  return text + "Presets: " + (names.empty() ? "none" : join(names)) + "\nLooked for in: " + join(folders) +
         "\n";
}

std::string scene_help() {
  std::string text = "Keys of a scene, for .json files and --set:\n";
  text += list_parameters("", scene_parameters());
  text += fmt::format("  {:<26} [width, height] in pixels\n", "size");
  text += "of the camera:\n" + list_parameters("camera.", camera_parameters());
  text += "of each medium (in \"media\": [...], or in the scene itself where there is one):\n" +
          list_parameters("medium.", medium_parameters());
  text += fmt::format(
      "  {:<26} a number\n  {:<26}   shape of a procedural medium; 'plinian make --help' lists them\n",
      "medium.shape.NAME", "");
  text += "of each light (in \"lights\": [...]; without them there are two, called key and rim):\n" +
          list_parameters("LIGHT.", light_parameters());
  return text;
}

ivec2 parse_size(const std::string& text, const std::string& option) {
  ivec2 size(0);
  const char* const end = text.data() + text.size();
  const auto [middle, error] = std::from_chars(text.data(), end, size.x);
  if (error == std::errc() && middle != end && (*middle == 'x' || *middle == 'X')) {
    const auto [rest, second_error] = std::from_chars(middle + 1, end, size.y);
    if (second_error == std::errc() && rest == end && size.x >= 1 && size.y >= 1 && size.x <= 32768 &&
        size.y <= 32768)
      return size;
  }
  throw std::runtime_error(
      fmt::format("{} {}: expected WIDTHxHEIGHT in pixels from 1 to 32768, such as 1280x720", option, text));
}

void refuse_script(const std::string& input) {
  if (input.ends_with(".pln"))
    throw std::runtime_error(fmt::format("{0}: is a script: 'plinian run {0}' runs it", input));
}

}  // namespace plinian::cli
