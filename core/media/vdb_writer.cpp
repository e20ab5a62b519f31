// Hands a volume's bricks to the worker, which writes them. See vdb_writer.h.
#include "core/media/vdb_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/files/atomic_file.h"
#include "core/media/brick_walk.h"
#include "core/media/vdb_protocol.h"
#include "core/media/vdb_task.h"

namespace plinian {
namespace {

/// The bricks of a volume as 8^3 blocks, in the order in which blocks travel.
class BlockSource {
 public:
  explicit BlockSource(const BrickVolume& volume) : volume_(volume) {
    bricks_.reserve(volume.brick_count());
    for_each_brick(volume, [&](ivec3 corner, std::size_t brick, BrickEntry entry) {
      bricks_.push_back({corner / 8, brick, brick_maximum(volume, entry) / 65535.0f});
    });
    std::sort(bricks_.begin(), bricks_.end(),
              [](const Brick& a, const Brick& b) { return vdb::BlockReader::after(b.block, a.block); });
  }

  /// Appends the next message; false when the end has been sent.
  bool next(std::vector<std::byte>& out) {
    if (ended_) return false;
    writer_.clear();
    for (; next_ < bricks_.size() && !writer_.full(); ++next_) add(bricks_[next_]);
    if (writer_.empty()) {
      vdb::append_message(out, vdb::MessageKind::end, nullptr, 0);
      ended_ = true;
    } else {
      const auto message = writer_.message();
      out.insert(out.end(), message.begin(), message.end());
    }
    return true;
  }

 private:
  struct Brick {
    ivec3 block;
    std::size_t number;
    float scale;  // [unit of the file] of a stored 1
  };
  void add(const Brick& brick) {
    float density[vdb::block_voxels], temperature[vdb::block_voxels];
    const bool hot = brick.number < volume_.hot_brick_count();
    bool any = false, warm = false;
    for (int i = 0; i < vdb::block_voxels; ++i) {
      const std::size_t from =
          brick.number * BrickVolume::brick_voxels +
          ((i >> 6) * BrickVolume::brick_stride + ((i >> 3) & 7)) * BrickVolume::brick_stride + (i & 7);
      density[i] = float(volume_.density[from]) * brick.scale;
      any = any || density[i] != 0.0f;
      if (!hot) continue;
      temperature[i] = float(volume_.temperature[from]) * (volume_.temperature_max / 65535.0f);
      warm = warm || temperature[i] != 0.0f;
    }
    // A brick may hold nothing but the apron of its neighbours.
    if (any) writer_.add(brick.block, density, warm ? temperature : nullptr);
  }

  const BrickVolume& volume_;
  std::vector<Brick> bricks_;
  std::size_t next_ = 0;
  vdb::BlockWriter writer_;
  bool ended_ = false;
};

}  // namespace

void write_vdb(const std::string& path, const BrickVolume& volume, const VdbWriteOptions& options) {
  BlockSource source(volume);
  vdb::Task task;
  const std::uint64_t bytes =
      volume.brick_count() * vdb::block_voxels * sizeof(float) * (volume.temperature.empty() ? 1 : 2);
  task.limits = vdb::limits_for(bytes, {});
  nlohmann::json columns = nlohmann::json::array();
  for (int i = 0; i < 16; ++i) columns.push_back(volume.medium_from_index[i / 4][i % 4]);
  std::map<std::string, std::string> metadata = options.metadata;
  metadata.insert({"creator", "Plinian"});
  metadata[vdb::up_axis_key] = std::string(1, options.up_axis);
  metadata[vdb::file_unit_key] = fmt::format("{}", options.file_unit);
  task.request = {{"task", "write"},
                  {"density_grid", options.density_grid},
                  {"temperature_grid", options.temperature_grid},
                  {"half", options.half},
                  {"medium_from_index", columns},
                  {"metadata", metadata}};
  task.more_input = [&](std::vector<std::byte>& out) { return source.next(out); };
  try {
    write_file(path, [&](const std::string& temporary) {
      task.path = temporary;
      try {
        vdb::run_task(task);
      } catch (const VdbError& error) {
        // What went wrong is about the file to be, not about the temporary one.
        std::string text = error.what();
        if (text.starts_with(temporary)) text.replace(0, temporary.size(), path);
        throw VdbError(text);
      }
    });
  } catch (const FileError& error) {
    throw VdbError(error.what());
  }
}

}  // namespace plinian
