// Data as text. Base64 as in RFC 4648.
#include "host/graph/types/data_type.h"

#include <array>
#include <cstdint>

#include "host/graph/graph_error.h"
#include "host/graph/values/words.h"

namespace plinian::graph {

namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::string_view prefix = "base64:";

std::string encoded(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() / 3 * 4 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? std::uint8_t(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string decoded(std::string_view text) {
  static const std::array<std::int8_t, 256> values = [] {
    std::array<std::int8_t, 256> result;
    result.fill(-1);
    for (std::size_t i = 0; i < digits.size(); ++i) result[std::uint8_t(digits[i])] = std::int8_t(i);
    return result;
  }();
  if (text.size() % 4 != 0) throw GraphError("holds base64 that was cut");
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t i = 0; i < text.size(); i += 4) {
    const bool last = i + 4 == text.size();
    const int count = !last || text[i + 3] != '=' ? 3 : text[i + 2] != '=' ? 2 : 1;
    std::uint32_t group = 0;
    for (int k = 0; k < 4; ++k) {
      const int value = k <= count ? values[std::uint8_t(text[i + std::size_t(k)])] : 0;
      if (value < 0) throw GraphError("holds what is no base64");
      group = group << 6 | std::uint32_t(value);
    }
    for (int k = 0; k < count; ++k) bytes += char(group >> (16 - 8 * k) & 255);
  }
  return bytes;
}

}  // namespace

std::string write_data(const DataSlotPtr& slot, const DataPtr& data) {
  if (!data || !slot || !slot->type) return "";
  std::string bytes;
  try {
    bytes = slot->type->serialise(data->object.get());
  } catch (const std::exception& error) {
    throw GraphError("data of type '" + slot->type->name + "' cannot be written: " + error.what());
  }
  const std::string text = quote(bytes), base64 = encoded(bytes);
  return text.size() <= base64.size() + 2 ? text : std::string(prefix) + base64;
}

DataPtr read_data(const DataSlotPtr& slot, const std::string& data_type, const Word& word) {
  if (!slot || !slot->type)
    throw GraphError("holds data of type '" + data_type + "', which have no text form here");
  if (!word.quoted && !word.text.starts_with(prefix))
    throw GraphError("expects data of type '" + data_type + "' in quotes or as base64, not " +
                     shown(word.text));
  const std::string bytes =
      word.quoted ? word.text : decoded(std::string_view(word.text).substr(prefix.size()));
  DataPtr data;
  try {
    data = slot->type->deserialise(bytes);
  } catch (const std::exception& error) {
    throw GraphError("holds data of type '" + data_type + "' that cannot be read: " + error.what());
  }
  if (!data) throw GraphError("holds data of type '" + data_type + "' that cannot be read");
  // Equal bytes are equal content.
  Hasher hasher;
  hasher.add(std::string_view(bytes));
  Data known = *data;
  known.type = data_type;
  known.content = hasher.result().low | 1u;
  return std::make_shared<const Data>(std::move(known));
}

}  // namespace plinian::graph
