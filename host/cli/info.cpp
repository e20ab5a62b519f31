// plinian info: what is in a .vdb file, a picture or a scene.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <variant>

#include "core/image/image_io.h"
#include "core/media/vdb_reader.h"
#include "core/scene/renderer.h"
#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/info_scene.h"
#include "host/cli/progress.h"
#include "host/cli/scene_arguments.h"
#include "host/scene/volume_options.h"

namespace plinian::cli {

using nlohmann::ordered_json;

namespace {

struct InfoArguments {
  std::string file;
  bool json = false;
  double time_limit_s = 0.0;
  std::string memory_limit;
};

constexpr const char* examples = R"(
Examples:
  plinian info smoke.vdb
  plinian info smoke.vdb --json
  plinian info picture.exr
  plinian info shot.plinian
The names of grids are those that --grid takes; a grid that cannot be density says why.)";

// Text columns as wide as their widest cell.
std::string table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i >= widths.size()) widths.push_back(0);
      widths[i] = std::max(widths[i], row[i].size());
    }
  std::string text;
  for (const auto& row : rows) {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format(" {:<{}} ", row[i], widths[i]);
    while (line.back() == ' ') line.pop_back();
    text += line + "\n";
  }
  return text;
}

std::string range_text(const VdbGridInfo& grid) {
  return grid.minimum && grid.maximum ? fmt::format("{:.4g} .. {:.4g}", *grid.minimum, *grid.maximum) : "-";
}

std::string vdb_text(const VdbInfo& info) {
  std::string text = fmt::format("{}: {}, {}\n{}\n", info.path, bytes_text(double(info.file_bytes)),
                                 info.format, info.orientation.reason);
  if (info.grids.empty()) return text + "no grids\n";
  std::vector<std::vector<std::string>> rows = {
      {"grid", "values", "class", "size", "active voxels", "range", "voxel", "in memory"}};
  for (const VdbGridInfo& grid : info.grids)
    rows.push_back({grid.name, grid.value_type, grid.grid_class,
                    fmt::format("{}x{}x{}", grid.dims[0], grid.dims[1], grid.dims[2]),
                    fmt::format("{}", grid.active_voxels), range_text(grid),
                    grid.transform == "uniform"
                        ? fmt::format("{:.4g}", grid.voxel_size.x)
                        : fmt::format("{:.4g}x{:.4g}x{:.4g} {}", grid.voxel_size.x, grid.voxel_size.y,
                                      grid.voxel_size.z, grid.transform),
                    bytes_text(double(grid.memory_bytes))});
  text += table(rows);
  for (const VdbGridInfo& grid : info.grids) {
    if (!grid.error.empty()) text += fmt::format("{}: {}\n", grid.name, grid.error);
    if (!grid.refusal.empty()) text += fmt::format("{}: {}\n", grid.name, grid.refusal);
  }
  for (const auto& [key, value] : info.metadata) text += fmt::format("  {}: {}\n", key, value);
  return text;
}

ordered_json vdb_json(const VdbInfo& info) {
  ordered_json grids = ordered_json::array();
  for (const VdbGridInfo& grid : info.grids) {
    ordered_json one = {{"name", grid.name},
                        {"value_type", grid.value_type},
                        {"class", grid.grid_class},
                        {"transform", grid.transform},
                        {"voxel_size", {grid.voxel_size.x, grid.voxel_size.y, grid.voxel_size.z}},
                        {"index_min", grid.index_min},
                        {"dims", grid.dims},
                        {"active_voxels", grid.active_voxels},
                        {"leaves", grid.leaves},
                        {"memory_bytes", grid.memory_bytes},
                        {"background", grid.background},
                        {"refusal", grid.refusal},
                        {"error", grid.error},
                        {"metadata", grid.metadata}};
    one["minimum"] = grid.minimum ? ordered_json(*grid.minimum) : ordered_json(nullptr);
    one["maximum"] = grid.maximum ? ordered_json(*grid.maximum) : ordered_json(nullptr);
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 3; ++row)
        one["medium_from_index"][std::size_t(row)].push_back(grid.medium_from_index[column][row]);
    grids.push_back(one);
  }
  return {{"path", info.path},
          {"kind", "vdb"},
          {"file_bytes", info.file_bytes},
          {"format", info.format},
          {"up_axis", std::string(1, info.orientation.up_axis)},
          {"file_unit", info.orientation.file_unit},
          {"orientation_reason", info.orientation.reason},
          {"metadata", info.metadata},
          {"grids", grids}};
}

ordered_json value_json(const Attribute& value) {
  if (const auto* number = std::get_if<int>(&value)) return *number;
  if (const auto* number = std::get_if<float>(&value)) return *number;
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  ordered_json rows = ordered_json::array();
  const mat4& matrix = std::get<mat4>(value);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) rows.push_back(matrix[column][row]);
  return rows;
}

// Mean and range of a channel over its finite pixels, and how many are not.
struct ChannelFacts {
  double mean = 0.0, minimum = INFINITY, maximum = -INFINITY;
  std::size_t bad = 0;
};
ChannelFacts facts_of(const Channel& channel) {
  ChannelFacts facts;
  for (const float value : channel.values) {
    if (!std::isfinite(value)) {
      ++facts.bad;
      continue;
    }
    facts.mean += value;
    facts.minimum = std::min(facts.minimum, double(value));
    facts.maximum = std::max(facts.maximum, double(value));
  }
  const std::size_t good = channel.values.size() - facts.bad;
  if (good) facts.mean /= double(good);
  return facts;
}

void print_image(const std::string& path, const Image& image, bool json) {
  if (json) {
    ordered_json channels = ordered_json::array(), metadata = ordered_json::object();
    for (const Channel& channel : image.channels) {
      const ChannelFacts facts = facts_of(channel);
      ordered_json one = {{"name", channel.name}, {"mean", facts.mean}, {"not_finite", facts.bad}};
      one["minimum"] =
          facts.bad < channel.values.size() ? ordered_json(facts.minimum) : ordered_json(nullptr);
      one["maximum"] =
          facts.bad < channel.values.size() ? ordered_json(facts.maximum) : ordered_json(nullptr);
      channels.push_back(one);
    }
    for (const auto& [key, value] : image.metadata) metadata[key] = value_json(value);
    print(ordered_json({{"path", path},
                        {"kind", "picture"},
                        {"size", {image.width, image.height}},
                        {"channels", channels},
                        {"metadata", metadata}})
              .dump(2) +
          "\n");
    return;
  }
  std::string text = fmt::format("{}: {}x{} pixels\n", path, image.width, image.height);
  std::vector<std::vector<std::string>> rows = {{"channel", "mean", "range", "not finite"}};
  for (const Channel& channel : image.channels) {
    const ChannelFacts facts = facts_of(channel);
    rows.push_back({channel.name, fmt::format("{:.5g}", facts.mean),
                    fmt::format("{:.4g} .. {:.4g}", facts.minimum, facts.maximum),
                    fmt::format("{}", facts.bad)});
  }
  text += table(rows);
  for (const auto& [key, value] : image.metadata)
    text += fmt::format("  {}: {}\n", key, value_json(value).dump());
  print(text);
}

int run_info(const InfoArguments& arguments) {
  const auto dot = arguments.file.rfind('.');
  const std::string extension = dot == std::string::npos ? "" : arguments.file.substr(dot);
  if (extension == ".exr" || extension == ".png" || extension == ".tif" || extension == ".hdr" ||
      extension == ".jpg") {
    print_image(arguments.file, read_image(arguments.file), arguments.json);
    return exit_success;
  }
  refuse_script(arguments.file);
  if (extension == ".plinian") {
    print(scene_info(arguments.file, arguments.json));
    return exit_success;
  }
  VdbOptions options;
  options.time_limit_s = arguments.time_limit_s;
  if (!arguments.memory_limit.empty())
    options.memory_limit_bytes = scene::parse_bytes(arguments.memory_limit, "--vdb-memory-limit");
  VdbInfo info;
  try {
    ProgressBar bar("reading");
    options.progress = [&](double share) { return bar(share); };
    info = inspect_vdb(arguments.file, options);
  } catch (const VdbCancelled&) {
    throw RenderCancelled();
  }
  print(arguments.json ? vdb_json(info).dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n"
                       : vdb_text(info));
  for (const VdbGridInfo& grid : info.grids)
    if (!grid.error.empty()) throw VdbError(arguments.file + ": " + grid.error);
  return exit_success;
}

}  // namespace

Run set_up_info(CLI::App& app) {
  auto arguments = std::make_shared<InfoArguments>();
  app.footer(examples);
  app.add_option("FILE", arguments->file, "a .vdb file, a picture or a .plinian scene")->required();
  app.add_flag("--json", arguments->json, "for scripts");
  app.add_option("--vdb-time-limit", arguments->time_limit_s, "for reading a .vdb (grows with the file)")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  app.add_option("--vdb-memory-limit", arguments->memory_limit, "for reading a .vdb, such as 4G")
      ->type_name("BYTES");
  return [arguments](const std::string&) { return run_info(*arguments); };
}

}  // namespace plinian::cli
