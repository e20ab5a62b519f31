// The worker's ends of the pipes to the program that started it: Inlet hears, Outlet answers.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/media/vdb_protocol.h"

namespace plinian::vdb {

/// Messages from the parent. Throws std::runtime_error when they end too early.
class Inlet {
 public:
  explicit Inlet(int descriptor) : descriptor_(descriptor) {}
  nlohmann::json request();
  /// The next message of blocks; empty after the last.
  std::span<const std::byte> blocks();

 private:
  MessageKind next();
  void take(void* to, std::size_t bytes);
  int descriptor_;
  std::vector<std::byte> payload_;
};

/// Answers to the parent. Ends the process where nobody listens any more.
class Outlet {
 public:
  explicit Outlet(int descriptor) : descriptor_(descriptor) {}
  /// message: framed, as BlockWriter::message gives it.
  void send(std::span<const std::byte> message) const;
  void progress(double share) const;
  void result(const nlohmann::json& json) const;
  void failure(std::string line) const;

 private:
  void send(MessageKind kind, const void* payload, std::size_t bytes) const;
  int descriptor_;
};

/// The file that a request is about. It travels as bytes: a path need not be UTF-8, JSON must be.
std::string path_of(const nlohmann::json& request);

}  // namespace plinian::vdb
