// What Plinian and its .vdb worker say to each other over pipes: framed messages, of which the bulk are
// blocks of voxels. Both ends run on one machine and come from one build, so numbers travel as they lie in
// memory.
//
// The worker may have been taken over by the file that it parses: whoever receives trusts no size, coordinate
// or order (BlockReader throws).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/shared/glue.h"

namespace plinian::vdb {

inline constexpr std::uint32_t protocol_version = 1;

enum class MessageKind : std::uint32_t {
  request = 1,   // to the worker: JSON
  blocks = 2,    // either way: records of voxels, see BlockWriter
  end = 3,       // to the worker: no more blocks; empty
  progress = 4,  // from the worker: one float in [0, 1]
  result = 5,    // from the worker, last: JSON
  failure = 6,   // from the worker, last: one line of text
};

struct MessageHeader {
  MessageKind kind;     // checked before use
  std::uint32_t bytes;  // of what follows
};
static_assert(sizeof(MessageHeader) == 8);

inline constexpr std::size_t max_blocks_bytes = 1u << 20;  // [bytes] of a message of blocks
inline constexpr std::size_t max_json_bytes = 16u << 20;   // [bytes] of a request or result
inline constexpr int block_voxels = 512;                   // 8^3, x fastest
inline constexpr int max_block_coordinate = 1 << 26;       // [blocks] from the origin; 2^29 voxels

/// Exit status of a worker that ran into its limit on memory.
inline constexpr int exit_out_of_memory = 3;
/// Address space that the worker takes before it has read anything [bytes].
inline constexpr std::uint64_t worker_base_bytes = 384ull << 20;

inline void append_bytes(std::vector<std::byte>& out, const void* data, std::size_t bytes) {
  if (bytes == 0) return;
  const std::size_t at = out.size();
  out.resize(at + bytes);
  std::memcpy(out.data() + at, data, bytes);
}

/// Appends header and payload to `out`.
inline void append_message(std::vector<std::byte>& out, MessageKind kind, const void* payload,
                           std::size_t bytes) {
  const MessageHeader header{kind, static_cast<std::uint32_t>(bytes)};
  append_bytes(out, &header, sizeof header);
  append_bytes(out, payload, bytes);
}

/// Gathers blocks into one message. A record: block coordinate (3 int32), flags, then 512 densities or, where
/// they are all the same, one; then 512 temperatures where there are any.
class BlockWriter {
 public:
  BlockWriter() { clear(); }
  /// density, temperature: 512 values, x fastest; temperature may be null.
  void add(ivec3 block, const float* density, const float* temperature) {
    bool constant = true;
    for (int i = 1; i < block_voxels && constant; ++i) constant = density[i] == density[0];
    const Record record{block.x, block.y, block.z,
                        (constant ? flag_constant : 0u) | (temperature ? flag_temperature : 0u)};
    append_bytes(buffer_, &record, sizeof record);
    append_bytes(buffer_, density, (constant ? 1 : block_voxels) * sizeof(float));
    if (temperature) append_bytes(buffer_, temperature, block_voxels * sizeof(float));
  }
  /// Whether another block might not fit.
  bool full() const { return buffer_.size() + sizeof(Record) + 8 * block_voxels > max_blocks_bytes; }
  bool empty() const { return buffer_.size() == sizeof(MessageHeader); }
  /// The message, header included; valid until the next call of add or clear.
  std::span<const std::byte> message() {
    const MessageHeader header{MessageKind::blocks,
                               static_cast<std::uint32_t>(buffer_.size() - sizeof(MessageHeader))};
    std::memcpy(buffer_.data(), &header, sizeof header);
    return buffer_;
  }
  void clear() { buffer_.resize(sizeof(MessageHeader)); }

 private:
  friend class BlockReader;
  static constexpr std::uint32_t flag_constant = 1, flag_temperature = 2;
  struct Record {
    std::int32_t x, y, z;
    std::uint32_t flags;
  };
  std::vector<std::byte> buffer_;
};

/// Takes messages of blocks apart and distrusts them: a record that is cut short, lies too far out, or does
/// not come after the one before it (by z, y, x, so that none can come twice) throws std::runtime_error.
class BlockReader {
 public:
  /// Calls f(ivec3 block, const float* density, const float* temperature or null) for each record.
  template <class F>
  void read(std::span<const std::byte> payload, F&& f) {
    while (!payload.empty()) {
      BlockWriter::Record record;
      take(payload, &record, sizeof record);
      const ivec3 block(record.x, record.y, record.z);
      if ((record.flags & ~(BlockWriter::flag_constant | BlockWriter::flag_temperature)) != 0 ||
          !in_range(block.x) || !in_range(block.y) || !in_range(block.z) || (any_ && !after(block, last_)))
        throw std::runtime_error("a block of voxels makes no sense");
      any_ = true;
      last_ = block;
      if (record.flags & BlockWriter::flag_constant) {
        take(payload, density_, sizeof(float));
        for (int i = 1; i < block_voxels; ++i) density_[i] = density_[0];
      } else {
        take(payload, density_, sizeof density_);
      }
      const bool hot = (record.flags & BlockWriter::flag_temperature) != 0;
      if (hot) take(payload, temperature_, sizeof temperature_);
      f(block, density_, hot ? temperature_ : nullptr);
    }
  }

  /// The order in which blocks travel.
  static bool after(ivec3 a, ivec3 b) { return a.z != b.z ? a.z > b.z : a.y != b.y ? a.y > b.y : a.x > b.x; }

 private:
  static bool in_range(int c) { return c >= -max_block_coordinate && c < max_block_coordinate; }
  static void take(std::span<const std::byte>& from, void* to, std::size_t bytes) {
    if (from.size() < bytes) throw std::runtime_error("a block of voxels is cut short");
    std::memcpy(to, from.data(), bytes);
    from = from.subspan(bytes);
  }
  ivec3 last_{0};
  bool any_ = false;
  float density_[block_voxels], temperature_[block_voxels];
};

}  // namespace plinian::vdb
