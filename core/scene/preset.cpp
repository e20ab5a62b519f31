// Presets from JSON.
#include "core/scene/preset.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "core/scene/nearest_word.h"
#include "core/scene/parameter_json.h"
#include "core/scene/quality_parameters.h"
#include "core/scene/resources.h"

namespace plinian {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr int max_bases = 8;  // presets that stand on one another; more is taken for a loop

int version_part(const json& version, const char* part, const std::string& path) {
  ParameterSpec spec{.name = part, .type = ParameterType::integer, .range = ParameterRange::at_least(0)};
  const std::string where = fmt::format("{}: plinian_preset.{}", path, part);
  if (!version.contains(part)) throw std::runtime_error(where + ": the key is missing");
  return std::get<int>(read_parameter(spec, version[part], where));
}

// The minor version of the file, once its major version is known to be ours.
int checked_minor(const json& file, const std::string& path) {
  if (!file.is_object() || !file.contains("plinian_preset") || !file["plinian_preset"].is_object())
    throw std::runtime_error(path +
                             ": not a preset: it needs \"plinian_preset\": {\"major\": 1, \"minor\": 0}");
  const json& version = file["plinian_preset"];
  for (const auto& [key, value] : version.items())
    if (!key.starts_with('_') && key != "major" && key != "minor")
      throw std::runtime_error(fmt::format("{}: plinian_preset.{}: unknown key", path, key));
  const int major = version_part(version, "major", path), minor = version_part(version, "minor", path);
  if (major != preset_major)
    throw std::runtime_error(fmt::format("{}: plinian_preset.major: this program reads version {}, not {}{}",
                                         path, preset_major, major,
                                         major > preset_major ? "; a newer one is needed" : ""));
  return minor;
}

// `not_this`: the file whose base it is, or empty. A user's own `fast` may stand on the `fast` of the
// installation, and not on itself.
std::string find_preset(const std::string& name, const std::vector<std::string>& folders,
                        const std::string& not_this) {
  if (name.find('/') != std::string::npos || name.ends_with(".json")) return name;
  bool is_itself = false;
  for (const std::string& folder : folders) {
    const fs::path path = fs::path(folder) / (name + ".json");
    std::error_code error;
    if (path.string() == not_this)
      is_itself = true;
    else if (fs::is_regular_file(path, error))
      return path.string();
  }
  if (is_itself)
    throw std::runtime_error(
        fmt::format("{}: base: {} is this preset itself; name another one, or leave the base out for fast",
                    not_this, name));
  const auto names = preset_names(folders);
  throw std::runtime_error(fmt::format(
      "{}{}: no such preset{}; there are: {}", not_this.empty() ? "" : not_this + ": base: ", name,
      did_you_mean(name, names), names.empty() ? "none (looked in " + join(folders) + ")" : join(names)));
}

// Says that a preset is not the one that comes with the program under its name: in the last of the folders.
void warn_of_shadow(const std::string& name, const std::vector<std::string>& folders, Preset& preset) {
  if (folders.size() < 2 || name.find('/') != name.npos || name.ends_with(".json")) return;
  const fs::path shipped = fs::path(folders.back()) / (name + ".json");
  std::error_code error;
  if (preset.path != shipped.string() && fs::is_regular_file(shipped, error))
    preset.warnings.push_back(
        fmt::format("{}: stands in for the preset '{}' that comes with the program", preset.path, name));
}

Preset load(const std::string& name_or_path, const std::vector<std::string>& folders,
            const std::string& stands_on_it, int depth) {
  if (depth > max_bases)
    throw std::runtime_error(name_or_path + ": base: presets stand on each other in a loop");
  Preset preset;
  preset.path = find_preset(name_or_path, folders, stands_on_it);
  const std::string& path = preset.path;
  warn_of_shadow(name_or_path, folders, preset);
  const json file = read_json_file(path);
  const bool newer = checked_minor(file, path) > preset_minor;

  const auto& table = quality_parameters();
  std::set<std::string> objects, given;
  for (const auto& parameter : table)
    objects.insert(parameter.spec.name.substr(0, parameter.spec.name.find('.')));

  // A key that we do not know is a mistake, unless the file says that it may know more than we do.
  const auto unknown = [&](const std::string& key, std::vector<std::string> known) {
    const std::string line = fmt::format("{}: {}: unknown key{}", path, key, did_you_mean(key, known));
    if (!newer) throw std::runtime_error(line);
    preset.warnings.push_back(line + ", left aside: the preset was written for a newer version");
  };

  Quality own;  // only what the file gives is read from it
  std::string base = "fast";
  for (const auto& [key, value] : file.items()) {
    const std::string where = path + ": " + key;
    if (key.starts_with('_') || key == "plinian_preset") continue;
    if (key == "name" || key == "base") {
      if (!value.is_string()) throw std::runtime_error(where + ": expected a text, got " + short_text(value));
      // A file is known by its name in the folder: copies keep what the original says inside.
      if (key == "base") base = value.get<std::string>();
      continue;
    }
    if (!objects.contains(key)) {
      std::vector<std::string> known(objects.begin(), objects.end());
      known.insert(known.end(), {"name", "base"});
      unknown(key, known);
      continue;
    }
    if (!value.is_object())
      throw std::runtime_error(where + ": expected an object, got " + short_text(value));
    for (const auto& [inner, inner_value] : value.items()) {
      if (inner.starts_with('_')) continue;
      const std::string full = key + "." + inner;
      const auto* parameter = find_parameter(table, full);
      if (!parameter) {
        unknown(full, parameter_names(table));
        continue;
      }
      parameter->set(own, read_parameter(parameter->spec, inner_value, path + ": " + full));
      given.insert(full);
    }
  }

  if (given.size() < table.size() || file.contains("base")) {
    Preset below = load(base, folders, path, depth + 1);
    preset.quality = below.quality;
    preset.warnings.insert(preset.warnings.begin(), below.warnings.begin(), below.warnings.end());
  }
  for (const auto& parameter : table)
    if (given.contains(parameter.spec.name)) parameter.set(preset.quality, *parameter.get(own));
  preset.quality.name = fs::path(path).stem().string();
  return preset;
}

}  // namespace

Preset load_preset(const std::string& name_or_path, const std::vector<std::string>& folders) {
  return load(name_or_path, folders, "", 0);
}

std::vector<std::string> preset_names(const std::vector<std::string>& folders) {
  std::set<std::string> names;
  for (const std::string& folder : folders) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
      if (entry.path().extension() == ".json") names.insert(entry.path().stem().string());
  }
  return {names.begin(), names.end()};
}

std::vector<std::string> preset_folders() {
  std::vector<std::string> folders;
  for (const fs::path& folder : search_folders()) folders.push_back((folder / "presets").string());
  return folders;
}

std::string preset_text(const Quality& quality) {
  // Ordered, so that the file reads in the order of the table.
  nlohmann::ordered_json file;
  file["plinian_preset"] = {{"major", preset_major}, {"minor", preset_minor}};
  file["name"] = quality.name;
  for (const auto& parameter : quality_parameters()) {
    const auto dot = parameter.spec.name.find('.');
    file[parameter.spec.name.substr(0, dot)][parameter.spec.name.substr(dot + 1)] =
        to_json(parameter.spec, *parameter.get(quality));
  }
  return file.dump(2) + "\n";
}

bool set_quality(Quality& quality, const std::string& name, const std::string& value,
                 const std::string& where) {
  const auto* parameter = find_parameter(quality_parameters(), name);
  if (!parameter) return false;
  parameter->set(quality, read_parameter(parameter->spec, json_from_text(value),
                                         where.empty() ? "--set " + name : where));
  return true;
}

}  // namespace plinian
