// Talking with the parent. See vdb_worker_pipe.h.
#include "core/media/vdb_worker_pipe.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>

namespace plinian::vdb {

void Inlet::take(void* to, std::size_t bytes) {
  auto* at = static_cast<std::byte*>(to);
  while (bytes > 0) {
    const ssize_t got = ::read(descriptor_, at, bytes);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw std::runtime_error("the program stopped talking");
    at += got;
    bytes -= static_cast<std::size_t>(got);
  }
}

MessageKind Inlet::next() {
  MessageHeader header;
  take(&header, sizeof header);
  if (header.bytes > max_json_bytes) throw std::runtime_error("the program sent nonsense");
  payload_.resize(header.bytes);
  take(payload_.data(), header.bytes);
  return header.kind;
}

nlohmann::json Inlet::request() {
  if (next() != MessageKind::request) throw std::runtime_error("the program sent nonsense");
  const auto* text = reinterpret_cast<const char*>(payload_.data());
  return nlohmann::json::parse(text, text + payload_.size());
}

std::span<const std::byte> Inlet::blocks() {
  if (next() == MessageKind::end) return {};
  return payload_;
}

void Outlet::send(std::span<const std::byte> message) const {
  while (!message.empty()) {
    const ssize_t put = ::write(descriptor_, message.data(), message.size());
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) std::_Exit(1);
    message = message.subspan(static_cast<std::size_t>(put));
  }
}

void Outlet::send(MessageKind kind, const void* payload, std::size_t bytes) const {
  std::vector<std::byte> message;
  append_message(message, kind, payload, bytes);
  send(message);
}

void Outlet::progress(double share) const {
  const float value = static_cast<float>(share);
  send(MessageKind::progress, &value, sizeof value);
}

void Outlet::result(const nlohmann::json& json) const {
  // Names in a file need not be UTF-8.
  const std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (text.size() > max_json_bytes) return failure("the file says too much about itself");
  send(MessageKind::result, text.data(), text.size());
}

void Outlet::failure(std::string line) const {
  std::replace(line.begin(), line.end(), '\n', ' ');
  send(MessageKind::failure, line.data(), std::min(line.size(), max_json_bytes));
}

std::string path_of(const nlohmann::json& request) {
  const auto bytes = request.at("path").get<std::vector<std::uint8_t>>();
  return {bytes.begin(), bytes.end()};
}

}  // namespace plinian::vdb
