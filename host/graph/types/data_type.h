// Opaque data that a scene file can hold: how they become bytes, and how bytes become them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "host/graph/values/value.h"

namespace plinian::graph {

struct DataType {
  std::string name;    // as attributes name it
  std::string plugin;  // who registers it; empty: the program itself
  /// The bytes of an object, and the object of bytes. Throw to fail.
  std::function<std::string(const void* object)> serialise;
  std::function<DataPtr(std::string_view bytes)> deserialise;
};
using DataTypePtr = std::shared_ptr<const DataType>;

/// What attributes of one data type share. The type may come and go with its plug-in while nodes live.
struct DataSlot {
  DataTypePtr type;  // null: not registered; then values have no text
};
using DataSlotPtr = std::shared_ptr<const DataSlot>;

/// Data as a word of a scene: quoted where the bytes are text, else base64 behind "base64:". Empty where
/// there are none or where their type is not registered.
std::string write_data(const DataSlotPtr& slot, const DataPtr& data);

struct Word;
/// What that word stands for. Throws GraphError.
DataPtr read_data(const DataSlotPtr& slot, const std::string& data_type, const Word& word);

}  // namespace plinian::graph
