// Data types in C++: what opaque objects of a plug-in are in a scene file.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "host/sdk/abi.h"
#include "host/sdk/plugin/support.h"

namespace plinian {
namespace PLINIAN_HIDDEN sdk {

/// Attributes of this data type can be set, and are stored in scenes. Make one with DataType::of.
struct DataType {
  std::string name{};
  std::function<std::string(const void* object)> serialise{};
  std::function<PlinianData(std::string_view bytes)> deserialise{};

  /// Of objects of type T, handed on by Context::set_data. write: an object as bytes, best as text, which
  /// diffs well; read: the object again; throws for bytes that are none. bytes_of: held in memory by one.
  template <class T>
  static DataType of(std::string name, std::function<std::string(const T&)> write,
                     std::function<std::unique_ptr<const T>(std::string_view)> read,
                     std::function<std::size_t(const T&)> bytes_of = {}) {
    DataType type;
    type.name = std::move(name);
    if (!write || !read) return type;  // the host refuses it, and says why
    type.serialise = [write](const void* object) { return write(*static_cast<const T*>(object)); };
    type.deserialise = [read, bytes_of](std::string_view bytes) {
      std::unique_ptr<const T> object = read(bytes);
      if (!object) throw Error("nothing came of the bytes");
      const std::size_t size = bytes_of ? bytes_of(*object) : sizeof(T);
      return PlinianData{sizeof(PlinianData), nullptr, object.release(), size, 0, [](const void* p) {
                           delete static_cast<const T*>(p);
                         }};
    };
    return type;
  }
};

namespace detail {

// type: stays where it is until the plug-in is uninitialised.
inline int register_data_type(const PlinianHost& host, DataType& type) {
  PlinianDataType plain{};
  plain.size = sizeof(plain);
  plain.name = type.name.c_str();
  plain.user = &type;
  if (type.serialise)
    plain.serialise = [](void* user, const void* object, const PlinianSerial* table, PlinianSink* sink) {
      guarded(
          [&] {
            const std::string bytes = static_cast<DataType*>(user)->serialise(object);
            table->write(sink, bytes.data(), bytes.size());
          },
          [&](const char* message) { table->fail(sink, message); });
    };
  if (type.deserialise)
    plain.deserialise = [](void* user, const void* bytes, std::size_t count, const PlinianSerial* table,
                           PlinianSink* sink) {
      guarded(
          [&] {
            const PlinianData data = static_cast<DataType*>(user)->deserialise(
                std::string_view(static_cast<const char*>(bytes), count));
            table->give(sink, &data);
          },
          [&](const char* message) { table->fail(sink, message); });
    };
  return host.register_data_type(host.self, &plain);
}

}  // namespace detail

}  // namespace sdk
}  // namespace plinian
