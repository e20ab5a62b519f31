// Reading and listing of .vdb files in the worker. See vdb_worker_read.h.
#include "core/media/vdb_worker_read.h"

#include <openvdb/tools/LevelSetUtil.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/media/vdb_worker_blocks.h"
#include "core/media/vdb_worker_file.h"
#include "core/media/vdb_worker_grids.h"

namespace plinian::vdb {
namespace {

using Json = nlohmann::json;
using openvdb::FloatGrid;

Json to_json(const Mended& mended) {
  return {
      {"not_a_number", mended.not_a_number}, {"infinite", mended.infinite}, {"negative", mended.negative}};
}

Json file_facts(const VdbFile& file) {
  const openvdb::VersionId library = file.libraryVersion();
  return {{"format", std::to_string(file.fileVersion()) + ", written by OpenVDB " +
                         std::to_string(library.first) + "." + std::to_string(library.second)},
          {"metadata", describe(file.metadata())}};
}

std::string in_words(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// One file on its way to the parent. Gathers the result as it goes.
class Reading {
 public:
  Reading(const Json& request, const Outlet& outlet)
      : request_(request),
        outlet_(outlet),
        // Parsing is the larger part; what follows streams.
        file_(path_of(request), [this](double share) { outlet_.progress(0.7 * share); }),
        result_(file_facts(file_)) {
    for (const char* list : {"density", "temperature", "notes", "warnings"}) result_[list] = Json::array();
  }

  void run() {
    choose_density();
    for (const GridEntry& entry : density_) check_density(entry);
    for (const GridEntry& entry : density_) job_.density.push_back(load_density(entry));
    put_on_one_lattice();
    load_temperature();
    send_blocks();
    outlet_.result(result_);
  }

 private:
  void note(const std::string& text) { result_["notes"].push_back(text); }
  bool wants(const char* option) const { return request_.at(option).get<bool>(); }

  void choose_density() {
    const std::string wanted = request_.at("grid").get<std::string>();
    if (file_.entries().empty()) throw BadFile("the file has no grids");
    std::string choice;
    density_ = wanted.empty() ? pick_density(file_, wants("level_set_fog"), choice) : pick(file_, wanted);
    if (!choice.empty()) note(choice);
    if (density_.size() > 1)
      note("the " + std::to_string(density_.size()) + " grids \"" + density_.front().name + "\" are summed");
  }

  /// Throws the reason why a grid cannot be density, before its voxels are read.
  void check_density(const GridEntry& entry) {
    const auto refuse = [&](const std::string& why) {
      throw BadFile("grid \"" + entry.label() + "\" " + why);
    };
    if (entry.type.find("ptdata") != std::string::npos)
      refuse(
          "holds points, which are no density; rasterise them to a fog volume in the program they come from");
    if (!is_scalar(entry))
      refuse("holds " + entry.value_type() + " values, which are no density; pick a grid of numbers");
    const openvdb::GridBase::Ptr header = file_.read_header(entry);
    if (const std::string fault = transform_fault(header->transform()); !fault.empty())
      refuse("cannot be placed: " + fault);
    if (header->getGridClass() == openvdb::GRID_LEVEL_SET && !wants("level_set_fog"))
      refuse("is a level set, a surface and no density; --level-set fog converts it to a fog volume");
    if (!header->transform().isLinear() && !wants("frustum_resample"))
      refuse("has a frustum transform; --frustum resample puts it onto a grid of equal voxels");
  }

  /// A grid as floats, with its facts added to a list of the result.
  FloatGrid::Ptr load(const GridEntry& entry, const char* list) {
    const openvdb::GridBase::Ptr grid = file_.read(entry);
    result_[list].push_back(describe(entry, *grid, /*with_tree=*/true));
    return as_floats(grid);
  }

  FloatGrid::Ptr load_density(const GridEntry& entry) {
    const FloatGrid::Ptr grid = load(entry, "density");
    if (grid->getGridClass() == openvdb::GRID_LEVEL_SET) {
      openvdb::tools::sdfToFogVolume(*grid);
      note("level set \"" + entry.label() + "\" is converted to a fog volume, 1 inside");
    } else if (const float background = grid->background(); background != 0.0f) {
      result_["warnings"].push_back(
          {{"kind", "background"},
           {"count", 1},
           {"text", "grid \"" + entry.label() + "\" has a background of " + in_words(background) +
                        ", which is read as 0 outside its active voxels"}});
    }
    return grid;
  }

  /// Decides where the result's voxels lie; values that are to be blended are mended first.
  void put_on_one_lattice() {
    job_.target = common_lattice(job_.density);
    if (job_.density.size() == 1 && same_lattice(job_.density.front()->transform(), *job_.target)) return;
    for (const FloatGrid::Ptr& grid : job_.density) mended_ += mend(*grid, 0.0f);
  }

  std::vector<GridEntry> choose_temperature() const {
    const std::string wanted = request_.at("temperature_grid").get<std::string>();
    if (wanted == "none") return {};
    if (!wanted.empty()) {
      std::vector<GridEntry> picked = pick(file_, wanted);
      for (const GridEntry& entry : picked)
        if (!is_scalar(entry))
          throw BadFile("grid \"" + entry.label() + "\" holds " + entry.value_type() +
                        " values, which are no temperature");
      return picked;
    }
    std::vector<GridEntry> found = pick_temperature(file_, density_);
    // density[2] goes with temperature[2].
    if (found.size() > 1 && density_.size() == 1 &&
        density_.front().siblings == static_cast<int>(found.size()))
      return {found[static_cast<std::size_t>(density_.front().index)]};
    return found;
  }

  void load_temperature() {
    const std::vector<GridEntry> entries = choose_temperature();
    Mended mended;
    float peak = 0.0f;
    for (const GridEntry& entry : entries) {
      const std::string fault = transform_fault(file_.read_header(entry)->transform());
      if (!fault.empty())
        throw BadFile("grid \"" + entry.label() + "\" cannot be placed: " + fault +
                      "; --temperature-grid none leaves it out");
      const FloatGrid::Ptr grid = load(entry, "temperature");
      const float background = grid->background();
      mended += mend(*grid, std::isfinite(background) ? std::max(background, 0.0f) : 0.0f);
      if (!same_lattice(grid->transform(), *job_.target))
        note("temperature \"" + entry.label() + "\" is resampled onto the voxels of the density");
      for (auto value = grid->cbeginValueOn(); value; ++value) peak = std::max(peak, *value);
      job_.temperature.push_back(grid);
    }
    if (entries.size() > 1)
      note("the largest of the " + std::to_string(entries.size()) + " grids \"" + entries.front().name +
           "\" is the temperature");
    constexpr float normalised_below = 100.0f, normalised_peak = 1800.0f;  // [unit of the grid], [K]
    if (peak > 0.0f && peak < normalised_below) {
      job_.temperature_gain = normalised_peak / peak;
      note("temperature \"" + entries.front().label() + "\" peaks at " + in_words(peak) +
           ", so it is taken as normalised and scaled to a peak of 1800 K");
    }
    result_["temperature_gain"] = job_.temperature_gain;
    result_["temperature_peak"] = peak;
    result_["mended_temperature"] = to_json(mended);
  }

  void send_blocks() {
    job_.most_bytes = request_.at("voxel_limit_bytes").get<std::uint64_t>();
    BlockWriter writer;
    const auto flush = [&] {
      if (!writer.empty()) outlet_.send(writer.message());
      writer.clear();
    };
    BlockResult blocks;
    try {
      blocks = for_each_block(
          job_,
          [&](openvdb::Coord block, const float* values, const float* kelvin) {
            if (writer.full()) flush();
            writer.add({block.x(), block.y(), block.z()}, values, kelvin);
          },
          [&](double share) { outlet_.progress(0.7 + 0.3 * share); });
    } catch (const TooManyVoxels& error) {
      throw BadFile("grid \"" + density_.front().label() + "\": " + error.what() +
                    "; --vdb-memory-limit raises it");
    }
    flush();
    describe_blocks(blocks);
  }

  void describe_blocks(const BlockResult& blocks) {
    if (blocks.resampled > 0 && density_.size() > 1)
      note(std::to_string(blocks.resampled) + " of them on other lattices are resampled onto the finest");
    else if (blocks.resampled > 0)
      note("the frustum of grid \"" + density_.front().label() + "\" is resampled onto equal voxels of " +
           in_words(job_.target->voxelSize()[0]));
    if (blocks.rebased != openvdb::Vec3i(0))
      note("index space is moved by (" + std::to_string(blocks.rebased[0]) + ", " +
           std::to_string(blocks.rebased[1]) + ", " + std::to_string(blocks.rebased[2]) +
           ") voxels, because the voxels lie far from its origin");
    mended_ += blocks.skipped;
    result_["mended"] = to_json(mended_);
    openvdb::Mat4d shift = openvdb::Mat4d::identity();
    shift.setTranslation(openvdb::Vec3d(blocks.rebased));
    const openvdb::Mat4d matrix = shift * job_.target->baseMap()->getAffineMap()->getMat4();
    Json& columns = result_["medium_from_index"] = Json::array();  // one after the other
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) columns.push_back(matrix(i, j));
  }

  const Json& request_;
  const Outlet& outlet_;
  VdbFile file_;
  Json result_;
  std::vector<GridEntry> density_;
  BlockJob job_;
  Mended mended_;  // of the density
};

}  // namespace

void read_file(const Json& request, const Outlet& outlet) {
  Reading(request, outlet).run();
}

void list_file(const Json& request, const Outlet& outlet) {
  VdbFile file(path_of(request), [&](double share) { outlet.progress(share); });
  Json result = file_facts(file);
  Json& grids = result["grids"] = Json::array();
  constexpr std::size_t most = 1000;
  const bool parses = request.at("voxels").get<bool>();
  for (const GridEntry& entry : file.entries()) {
    if (grids.size() == most) break;
    Json info;
    std::string error;
    try {
      // Of what can be no density the voxels need not be parsed.
      const bool whole = parses && is_scalar(entry);
      info = describe(entry, whole ? *file.read(entry) : *file.read_header(entry), whole);
    } catch (const std::exception& problem) {  // of one grid; the others may be whole
      info = {{"name", entry.label()}, {"value_type", entry.value_type()}};
      error = problem.what();
    }
    info["error"] = error;
    info["stored_bytes"] = std::max<std::int64_t>(0, entry.end_at - entry.grid_at);
    grids.push_back(std::move(info));
  }
  outlet.result(result);
}

}  // namespace plinian::vdb
