// Data through plain C. No exception leaves a function that a plug-in calls.
#include "host/sdk/data_type_table.h"

#include "host/graph/graph_error.h"
#include "host/graph/types/attribute_spec.h"
#include "host/graph/values/words.h"
#include "host/sdk/inside_plugin.h"
#include "host/sdk/plain_text.h"

namespace plinian::sdk {

using graph::GraphError;

namespace {

struct SerialState {
  std::shared_ptr<DataCount> count;
  std::string bytes, failure;
  graph::DataPtr data;
};

SerialState& state_of(PlinianSink* sink) {
  return *reinterpret_cast<SerialState*>(sink);
}

const PlinianSerial serial_table = {
    sizeof(PlinianSerial),
    [](PlinianSink* s, const void* bytes, std::size_t count) {
      try {
        state_of(s).bytes.append(static_cast<const char*>(bytes), count);
      } catch (const std::exception& error) {
        state_of(s).failure = error.what();
      }
    },
    [](PlinianSink* s, const PlinianData* data) { state_of(s).data = data_from(data, state_of(s).count); },
    [](PlinianSink* s, const char* message) { state_of(s).failure = text_of(message); }};

}  // namespace

graph::DataPtr data_from(const PlinianData* plain, const std::shared_ptr<DataCount>& count) {
  const PlinianData from = whole(plain);
  ++count->objects;
  const auto release = [free = from.release, count](const void* object) {
    const InsidePlugin inside(count->owner, "releasing data");
    if (free) free(object);
    --count->objects;
  };
  const std::shared_ptr<const void> object(from.object, release);
  return std::make_shared<const graph::Data>(
      graph::Data{text_of(from.type), object, from.bytes, from.content});
}

graph::DataType data_type_from(const PlinianDataType* plain, const std::shared_ptr<DataCount>& count) {
  const PlinianDataType from = whole(plain);
  graph::DataType type;
  type.name = text_of(from.name);
  if (!graph::is_identifier(type.name))
    throw GraphError(graph::shown(type.name) + " cannot name a data type");
  if (!from.serialise || !from.deserialise)
    throw GraphError("the data type '" + type.name + "' needs functions to write and to read it");
  type.serialise = [from, count, name = type.name](const void* object) {
    const InsidePlugin inside(count->owner, "writing data of the type", name.c_str());
    SerialState state{count, "", "", nullptr};
    from.serialise(from.user, object, &serial_table, reinterpret_cast<PlinianSink*>(&state));
    if (!state.failure.empty()) throw GraphError(state.failure);
    return std::move(state.bytes);
  };
  type.deserialise = [from, count, name = type.name](std::string_view bytes) {
    const InsidePlugin inside(count->owner, "reading data of the type", name.c_str());
    SerialState state{count, "", "", nullptr};
    from.deserialise(from.user, bytes.data(), bytes.size(), &serial_table,
                     reinterpret_cast<PlinianSink*>(&state));
    if (!state.failure.empty()) throw GraphError(state.failure);
    if (!state.data) throw GraphError("nothing came of the bytes");
    return std::move(state.data);
  };
  return type;
}

}  // namespace plinian::sdk
