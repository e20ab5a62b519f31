// plinian-vdb-worker: parses, lists or writes one .vdb file for the program that started it, see
// vdb_process.h.
//
// It reads a request from its standard input and answers on its standard output (vdb_protocol.h). Everything
// that OpenVDB does wrong with a malformed file happens in here, under the limits that the request sets.
#include <fcntl.h>
#include <malloc.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetUtil.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/media/vdb_protocol.h"
#include "core/media/vdb_worker_blocks.h"
#include "core/media/vdb_worker_file.h"
#include "core/media/vdb_worker_grids.h"
#include "core/media/vdb_worker_write.h"

namespace plinian::vdb {
namespace {

using Json = nlohmann::json;

int answers = -1;  // descriptor of the parent's end; set once, before anything else runs

void send_all(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(answers, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) std::_Exit(1);  // the parent is gone
    bytes = bytes.subspan(static_cast<std::size_t>(put));
  }
}

void send(MessageKind kind, const void* payload, std::size_t bytes) {
  std::vector<std::byte> message;
  append_message(message, kind, payload, bytes);
  send_all(message);
}

void send_progress(double share) {
  const float value = static_cast<float>(share);
  send(MessageKind::progress, &value, sizeof value);
}

void send_text(MessageKind kind, const std::string& text) {
  send(kind, text.data(), std::min(text.size(), max_json_bytes));
}

/// Settles in: descriptors, limits, and what happens when memory runs out.
void set_limits(const Json& request) {
  const auto limit = [](auto resource, std::uint64_t amount) {
    const rlimit value{amount, amount};
    ::setrlimit(resource, &value);
  };
  limit(RLIMIT_CORE, 0);
  const unsigned threads = std::clamp(std::thread::hardware_concurrency(), 1u, 4u);
  const double seconds = request.at("time_limit_s").get<double>();
  // The parent watches the clock; this is for the case that it is killed itself.
  limit(RLIMIT_CPU, static_cast<std::uint64_t>(std::clamp(seconds * threads, 1.0, 1e8)) + 2);
#ifndef __SANITIZE_ADDRESS__  // which maps terabytes that it never touches
  limit(RLIMIT_AS, request.at("memory_limit_bytes").get<std::uint64_t>() + worker_base_bytes);
#endif
  std::set_new_handler([] { std::_Exit(exit_out_of_memory); });
}

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

/// A grid as floats, with its facts appended to `facts`.
openvdb::FloatGrid::Ptr load(VdbFile& file, const GridEntry& entry, Json& facts) {
  const openvdb::GridBase::Ptr grid = file.read(entry);
  facts.push_back(describe(entry, *grid, /*with_tree=*/true));
  return as_floats(grid);
}

/// Throws the reason why a grid cannot be density, before its voxels are read.
void check_density(VdbFile& file, const GridEntry& entry, const Json& request) {
  const auto refuse = [&](const std::string& why) { throw BadFile("grid \"" + entry.label() + "\" " + why); };
  if (entry.type.find("ptdata") != std::string::npos)
    refuse(
        "holds points, which are no density; rasterise them to a fog volume in the program they come from");
  if (!is_scalar(entry))
    refuse("holds " + entry.value_type() + " values, which are no density; pick a grid of numbers");
  const openvdb::GridBase::Ptr header = file.read_header(entry);
  if (const std::string fault = transform_fault(header->transform()); !fault.empty())
    refuse("cannot be placed: " + fault);
  if (header->getGridClass() == openvdb::GRID_LEVEL_SET && !request.at("level_set_fog").get<bool>())
    refuse("is a level set, a surface and no density; --level-set fog converts it to a fog volume");
  if (!header->transform().isLinear() && !request.at("frustum_resample").get<bool>())
    refuse("has a frustum transform; --frustum resample puts it onto a grid of equal voxels");
}

std::vector<GridEntry> choose_temperature(const VdbFile& file, const std::string& wanted,
                                          const std::vector<GridEntry>& density) {
  if (wanted == "none") return {};
  if (!wanted.empty()) {
    std::vector<GridEntry> picked = pick(file, wanted);
    for (const GridEntry& entry : picked)
      if (!is_scalar(entry))
        throw BadFile("grid \"" + entry.label() + "\" holds " + entry.value_type() +
                      " values, which are no temperature");
    return picked;
  }
  std::vector<GridEntry> found = pick_temperature(file, density);
  // density[2] goes with temperature[2].
  if (found.size() > 1 && density.size() == 1 && density.front().siblings == static_cast<int>(found.size()))
    return {found[static_cast<std::size_t>(density.front().index)]};
  return found;
}

void read_file(const Json& request) {
  // Reading is the larger part; what follows streams.
  const auto progress = [](double share) { send_progress(0.7 * share); };
  VdbFile file(path_of(request), progress);
  Json result = file_facts(file);
  Json notes = Json::array(), warnings = Json::array();
  const bool fog = request.at("level_set_fog").get<bool>();

  std::string note;
  const std::string wanted = request.at("grid").get<std::string>();
  if (file.entries().empty()) throw BadFile("the file has no grids");
  const std::vector<GridEntry> picked = wanted.empty() ? pick_density(file, fog, note) : pick(file, wanted);
  if (!note.empty()) notes.push_back(note);
  for (const GridEntry& entry : picked) check_density(file, entry, request);

  BlockJob job;
  std::vector<openvdb::FloatGrid::Ptr> density;
  Mended mended;
  result["density"] = Json::array();
  for (const GridEntry& entry : picked) {
    openvdb::FloatGrid::Ptr grid = load(file, entry, result["density"]);
    if (grid->getGridClass() == openvdb::GRID_LEVEL_SET) {
      openvdb::tools::sdfToFogVolume(*grid);
      notes.push_back("level set \"" + entry.label() + "\" is converted to a fog volume, 1 inside");
    } else if (const float background = grid->background(); background != 0.0f) {
      warnings.push_back(
          {{"kind", "background"},
           {"count", 1},
           {"text", "grid \"" + entry.label() + "\" has a background of " + std::to_string(background) +
                        ", which is read as 0 outside its active voxels"}});
    }
    density.push_back(grid);
  }
  job.target = common_lattice(density);
  const bool direct = density.size() == 1 && same_lattice(density.front()->transform(), *job.target);
  if (!direct)
    for (const auto& grid : density) {
      const Mended one = mend(*grid, 0.0f);
      mended.not_a_number += one.not_a_number;
      mended.infinite += one.infinite;
      mended.negative += one.negative;
    }
  if (density.size() > 1)
    notes.push_back("the " + std::to_string(density.size()) + " grids \"" + picked.front().name +
                    "\" are summed");

  const std::vector<GridEntry> hot =
      choose_temperature(file, request.at("temperature_grid").get<std::string>(), picked);
  std::vector<openvdb::FloatGrid::Ptr> temperature;
  result["temperature"] = Json::array();
  Mended mended_heat;
  for (const GridEntry& entry : hot) {
    if (const std::string fault = transform_fault(file.read_header(entry)->transform()); !fault.empty())
      throw BadFile("grid \"" + entry.label() + "\" cannot be placed: " + fault +
                    "; --temperature-grid none leaves it out");
    openvdb::FloatGrid::Ptr grid = load(file, entry, result["temperature"]);
    const float background = grid->background();
    const Mended one = mend(*grid, std::isfinite(background) ? std::max(background, 0.0f) : 0.0f);
    mended_heat.not_a_number += one.not_a_number;
    mended_heat.infinite += one.infinite;
    mended_heat.negative += one.negative;
    if (!same_lattice(grid->transform(), *job.target))
      notes.push_back("temperature \"" + entry.label() + "\" is resampled onto the voxels of the density");
    temperature.push_back(grid);
  }
  if (hot.size() > 1)
    notes.push_back("the largest of the " + std::to_string(hot.size()) + " grids \"" + hot.front().name +
                    "\" is the temperature");
  float peak = 0.0f;
  for (const auto& grid : temperature)
    for (auto value = grid->cbeginValueOn(); value; ++value) peak = std::max(peak, *value);
  constexpr float normalised_below = 100.0f, normalised_peak = 1800.0f;  // [unit of the grid], [K]
  if (peak > 0.0f && peak < normalised_below) {
    job.temperature_gain = normalised_peak / peak;
    char text[200];
    std::snprintf(text, sizeof text,
                  "peaks at %g, so it is taken as normalised and scaled to a peak of 1800 K", peak);
    notes.push_back("temperature \"" + hot.front().label() + "\" " + text);
  }
  result["temperature_gain"] = job.temperature_gain;
  result["temperature_peak"] = peak;

  job.density.assign(density.begin(), density.end());
  job.temperature.assign(temperature.begin(), temperature.end());
  job.most_bytes = request.at("voxel_limit_bytes").get<std::uint64_t>();
  BlockWriter writer;
  BlockResult blocks;
  try {
    blocks = for_each_block(
        job,
        [&](openvdb::Coord block, const float* values, const float* kelvin) {
          if (writer.full()) {
            send_all(writer.message());
            writer.clear();
          }
          writer.add({block.x(), block.y(), block.z()}, values, kelvin);
        },
        [](double share) { send_progress(0.7 + 0.3 * share); });
  } catch (const TooManyVoxels& error) {
    throw BadFile("grid \"" + picked.front().label() + "\": " + error.what() +
                  "; --vdb-memory-limit raises it");
  }
  if (!writer.empty()) send_all(writer.message());

  if (density.size() > 1 && blocks.resampled > 0)
    notes.push_back(std::to_string(blocks.resampled) +
                    " of them on other lattices are resampled onto the finest");
  else if (blocks.resampled > 0)
    notes.push_back("the frustum of grid \"" + picked.front().label() +
                    "\" is resampled onto equal voxels of " + std::to_string(job.target->voxelSize()[0]));
  mended.not_a_number += blocks.skipped.not_a_number;
  mended.infinite += blocks.skipped.infinite;
  mended.negative += blocks.skipped.negative;

  openvdb::Mat4d matrix = job.target->baseMap()->getAffineMap()->getMat4();
  openvdb::Mat4d shift = openvdb::Mat4d::identity();
  shift.setTranslation(openvdb::Vec3d(blocks.rebased));
  matrix = shift * matrix;
  result["medium_from_index"] = Json::array();  // columns, one after the other
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) result["medium_from_index"].push_back(matrix(i, j));
  if (blocks.rebased != openvdb::Vec3i(0))
    notes.push_back("index space is moved by (" + std::to_string(blocks.rebased[0]) + ", " +
                    std::to_string(blocks.rebased[1]) + ", " + std::to_string(blocks.rebased[2]) +
                    ") voxels, because the voxels lie far from its origin");
  result["notes"] = notes;
  result["warnings"] = warnings;
  result["mended"] = to_json(mended);
  result["mended_temperature"] = to_json(mended_heat);
  send_text(MessageKind::result, result.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void list_file(const Json& request) {
  VdbFile file(path_of(request), send_progress);
  Json result = file_facts(file);
  result["grids"] = Json::array();
  constexpr std::size_t most = 1000;
  for (const GridEntry& entry : file.entries()) {
    if (result["grids"].size() == most) break;
    Json info;
    std::string error;
    try {
      // Of what can be no density the voxels need not be parsed.
      const bool whole = is_scalar(entry);
      info = describe(entry, whole ? *file.read(entry) : *file.read_header(entry), whole);
    } catch (const BadFile& problem) {
      info = {{"name", entry.label()}, {"value_type", entry.value_type()}};
      error = problem.what();
    } catch (const openvdb::Exception& problem) {
      info = {{"name", entry.label()}, {"value_type", entry.value_type()}};
      error = problem.what();
    }
    info["error"] = error;
    result["grids"].push_back(std::move(info));
  }
  send_text(MessageKind::result, result.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void run() {
  Inlet inlet(0);
  const Json request = Json::parse(inlet.request());
  if (request.at("protocol").get<std::uint32_t>() != protocol_version)
    throw BadFile("plinian-vdb-worker is of another version than the program; install both together");
  set_limits(request);
  tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                              std::clamp(std::thread::hardware_concurrency(), 1u, 4u));
  openvdb::initialize();
  const std::string task = request.at("task").get<std::string>();
  if (task == "read")
    read_file(request);
  else if (task == "list")
    list_file(request);
  else if (task == "write")
    send_text(MessageKind::result, write_file(request, inlet).dump());
  else
    throw BadFile("an unknown task");
}

}  // namespace
}  // namespace plinian::vdb

int main() {
  using namespace plinian::vdb;
  if (::isatty(0)) {
    std::fputs("plinian-vdb-worker reads .vdb files for plinian; it is not for use by hand\n", stderr);
    return 2;
  }
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::mallopt(M_ARENA_MAX, 2);  // each arena takes address space, which is limited
  // What libraries print must not run into the answers.
  answers = ::fcntl(1, F_DUPFD_CLOEXEC, 3);
  ::dup2(2, 1);
  ::setenv("OPENVDB_DISABLE_DELAYED_LOAD", "1", 1);
  std::string failure;
  try {
    run();
    return 0;
  } catch (const std::exception& error) {
    failure = error.what();
  }
  std::replace(failure.begin(), failure.end(), '\n', ' ');
  send_text(MessageKind::failure, failure);
  return 0;
}
