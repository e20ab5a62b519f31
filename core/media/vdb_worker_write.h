// The worker's ear: what the parent sends; and the writing of a file from blocks that arrive this way.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/media/vdb_protocol.h"

namespace plinian::vdb {

/// Messages from the parent. Throws std::runtime_error when they end too early.
class Inlet {
 public:
  explicit Inlet(int descriptor) : descriptor_(descriptor) {}
  std::string request();
  /// The next message of blocks; empty after the last.
  std::span<const std::byte> blocks();

 private:
  MessageKind next();
  void take(void* to, std::size_t bytes);
  int descriptor_;
  std::vector<std::byte> payload_;
};

/// The file that a request is about. It travels as bytes: a path need not be UTF-8, JSON must be.
std::string path_of(const nlohmann::json& request);

/// Writes the grids that arrive through `inlet` to the file that the request names; returns the voxel counts.
nlohmann::json write_file(const nlohmann::json& request, Inlet& inlet);

}  // namespace plinian::vdb
