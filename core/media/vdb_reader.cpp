// Reading of .vdb files from the program's side: asking the worker, checking what it says, building the
// volume and the sentences. See vdb_reader.h.
#include "core/media/vdb_reader.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "core/media/vdb_protocol.h"
#include "core/media/vdb_task.h"

namespace plinian {
namespace {

using Json = nlohmann::json;

/// What can be said without parsing anything; returns the file's size.
std::uint64_t check_file(const std::string& path) {
  struct Closer {
    int fd;
    ~Closer() {
      if (fd >= 0) ::close(fd);
    }
  };
  // Non-blocking: opening a pipe that nobody writes would wait for ever.
  const Closer file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  if (file.fd < 0) throw VdbError(path + ": " + (errno == ENOENT ? "no such file" : std::strerror(errno)));
  struct stat status;
  if (::fstat(file.fd, &status) != 0) throw VdbError(path + ": " + std::strerror(errno));
  if (S_ISDIR(status.st_mode)) throw VdbError(path + ": it is a folder, not a .vdb file");
  if (!S_ISREG(status.st_mode)) throw VdbError(path + ": it is not a regular file");
  if (status.st_size == 0) throw VdbError(path + ": the file is empty");
  char magic[8];
  if (::read(file.fd, magic, sizeof magic) != sizeof magic || std::memcmp(magic, " BDV\0\0\0\0", 8) != 0)
    throw VdbError(path + ": not a .vdb file");
  return static_cast<std::uint64_t>(status.st_size);
}

/// A number that may be null where the file's was not finite.
double number(const Json& value, double otherwise) {
  return value.is_number() ? value.get<double>() : otherwise;
}

dmat4 matrix(const Json& columns) {
  dmat4 m(1.0);
  for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = number(columns.at(i), 0.0);
  return m;
}

VdbGridInfo grid_info(const Json& json) {
  VdbGridInfo info;
  info.name = json.at("name").get<std::string>();
  info.value_type = json.at("value_type").get<std::string>();
  info.error = json.value("error", "");
  if (!info.error.empty()) return info;
  info.grid_class = json.at("grid_class").get<std::string>();
  info.transform = json.at("transform").get<std::string>();
  info.refusal = json.at("refusal").get<std::string>();
  if (json.contains("medium_from_index")) info.medium_from_index = matrix(json.at("medium_from_index"));
  for (int axis = 0; axis < 3; ++axis) {
    info.voxel_size[axis] = number(json.at("voxel_size").at(axis), 0.0);
    info.index_min[axis] = json.at("index_min").at(axis).get<std::int64_t>();
    info.dims[axis] = json.at("dims").at(axis).get<std::int64_t>();
  }
  info.active_voxels = json.at("active_voxels").get<std::int64_t>();
  info.leaves = json.value("leaves", std::uint64_t(0));
  info.memory_bytes = json.value("memory_bytes", std::uint64_t(0));
  info.stored_bytes = json.value("stored_bytes", std::uint64_t(0));
  if (json.contains("minimum")) info.minimum = json.at("minimum").get<double>();
  if (json.contains("maximum")) info.maximum = json.at("maximum").get<double>();
  if (json.contains("background")) info.background = number(json.at("background"), 0.0);
  info.metadata = json.at("metadata").get<std::map<std::string, std::string>>();
  return info;
}

std::vector<VdbGridInfo> grid_infos(const Json& json) {
  std::vector<VdbGridInfo> infos;
  for (const Json& one : json) infos.push_back(grid_info(one));
  return infos;
}

VoxelRepairs repairs(const Json& json) {
  VoxelRepairs counts;
  counts.not_a_number = json.at("not_a_number").get<std::int64_t>();
  counts.infinite = json.at("infinite").get<std::int64_t>();
  counts.negative = json.at("negative").get<std::int64_t>();
  return counts;
}

void warn_of_repairs(std::vector<VdbWarning>& warnings, const VoxelRepairs& counts, const std::string& what) {
  const auto voxels = [](std::int64_t n) { return fmt::format("{} {}", n, n == 1 ? "voxel" : "voxels"); };
  if (counts.not_a_number > 0)
    warnings.push_back({"not_a_number", counts.not_a_number,
                        fmt::format("{} of {} not numbers, read as 0", voxels(counts.not_a_number), what)});
  if (counts.infinite > 0)
    warnings.push_back(
        {"infinite", counts.infinite,
         fmt::format("{} of {} infinite, read as the largest finite value (or 0 where negative)",
                     voxels(counts.infinite), what)});
  if (counts.negative > 0)
    warnings.push_back({"negative", counts.negative,
                        fmt::format("{} of {} negative, read as 0", voxels(counts.negative), what)});
}

void warn_of_shape(std::vector<VdbWarning>& warnings, const BrickVolume& volume) {
  if (volume.empty()) {
    warnings.push_back({"empty", 1, "there is no density in it: nothing will be seen"});
    return;
  }
  // Voxels, without the cell of interpolation around them.
  const dvec3 box = dvec3(volume.bounds_max) - dvec3(volume.bounds_min) - 1.0;
  const double cells = box.x * box.y * box.z;
  const double longest = std::max({box.x, box.y, box.z});
  if (longest > 4096.0 && cells > 1e4 * double(volume.active_voxels))
    warnings.push_back(
        {"sparse_box", volume.active_voxels,
         fmt::format("{} voxels are spread over a box of {:.0f} x {:.0f} x {:.0f}: the volume may look empty",
                     volume.active_voxels, box.x, box.y, box.z)});
}

vdb::Task make_task(const char* kind, const std::string& path, std::uint64_t bytes,
                    const VdbOptions& options) {
  vdb::Task task;
  task.path = path;
  task.limits = vdb::limits_for(bytes, options);
  task.progress = options.progress;
  task.request = {{"task", kind}};
  return task;
}

[[noreturn]] void nonsense(const std::string& path) {
  throw VdbError(path + ": the file is damaged: the reader sent nonsense");
}

}  // namespace

VdbVolume read_vdb(const std::string& path, const VdbOptions& options) {
  VdbVolume result;
  VdbFacts& facts = result.facts;
  facts.path = path;
  facts.file_bytes = check_file(path);
  vdb::Task task = make_task("read", path, facts.file_bytes, options);
  task.request["grid"] = options.grid;
  task.request["temperature_grid"] = options.temperature_grid;
  task.request["level_set_fog"] = options.level_set == LevelSetMode::fog;
  task.request["frustum_resample"] = options.frustum == FrustumMode::resample;

  BrickVolumeBuilder builder;
  vdb::BlockReader reader;
  std::uint64_t bytes = 0;
  task.on_blocks = [&](std::span<const std::byte> payload) {
    reader.read(payload, [&](ivec3 block, const float* density, const float* temperature) {
      bytes += vdb::block_voxels * sizeof(float) * (temperature ? 2 : 1);
      if (bytes > task.limits.voxel_bytes) nonsense(path);
      builder.add(block, density, temperature);
    });
  };
  const Json json = vdb::run_task(task);
  try {
    facts.format = json.at("format").get<std::string>();
    facts.metadata = json.at("metadata").get<std::map<std::string, std::string>>();
    facts.density = grid_infos(json.at("density"));
    facts.temperature = grid_infos(json.at("temperature"));
    facts.temperature_gain = number(json.at("temperature_gain"), 1.0);
    facts.temperature_peak = number(json.at("temperature_peak"), 0.0);
    facts.notes = json.at("notes").get<std::vector<std::string>>();
    facts.orientation = vdb::guess_orientation(facts.metadata, facts.density);
    if (facts.density.empty()) nonsense(path);
    for (const Json& warning : json.at("warnings"))
      facts.warnings.push_back({warning.at("kind").get<std::string>(),
                                warning.at("count").get<std::int64_t>(),
                                warning.at("text").get<std::string>()});
    const dmat4 medium_from_index = matrix(json.at("medium_from_index"));
    if (!(std::abs(glm::determinant(medium_from_index)) > 0.0)) nonsense(path);
    result.volume = std::make_shared<const BrickVolume>(builder.build(medium_from_index));
    VoxelRepairs counts = builder.repairs();
    const VoxelRepairs beforehand = repairs(json.at("mended"));
    counts.not_a_number += beforehand.not_a_number;
    counts.infinite += beforehand.infinite;
    counts.negative += beforehand.negative;
    warn_of_repairs(facts.warnings, counts, "the density are");
    warn_of_repairs(facts.warnings, repairs(json.at("mended_temperature")), "the temperature are");
    warn_of_shape(facts.warnings, *result.volume);
  } catch (const Json::exception&) {
    nonsense(path);
  }
  return result;
}

namespace {

VdbInfo list_grids(const std::string& path, const VdbOptions& options, bool with_voxels) {
  VdbInfo info;
  info.path = path;
  info.file_bytes = check_file(path);
  vdb::Task task = make_task("list", path, info.file_bytes, options);
  task.request["voxels"] = with_voxels;
  const Json json = vdb::run_task(task);
  try {
    info.format = json.at("format").get<std::string>();
    info.metadata = json.at("metadata").get<std::map<std::string, std::string>>();
    info.grids = grid_infos(json.at("grids"));
    info.orientation = vdb::guess_orientation(info.metadata, info.grids);
  } catch (const Json::exception&) {
    nonsense(path);
  }
  return info;
}

}  // namespace

VdbInfo inspect_vdb(const std::string& path, const VdbOptions& options) {
  return list_grids(path, options, true);
}

VdbInfo list_vdb(const std::string& path, const VdbOptions& options) {
  return list_grids(path, options, false);
}

}  // namespace plinian
