// No exception leaves a function that a plug-in calls.
#include "host/sdk/compute_table.h"

#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"
#include "host/sdk/data_type_table.h"
#include "host/sdk/plain_text.h"
#include "host/sdk/volume_table.h"

namespace plinian::sdk {

using graph::DataPtr;
using graph::GraphError;
using graph::Value;

const Value& input_of(ComputeState& state, std::int32_t attribute, std::int32_t element, const double* time) {
  if (!time) return state.context.input(attribute, element);
  state.held.push_front(state.context.input_at(*time, attribute, element));
  return state.held.front();
}

namespace {

int read_number(PlinianContext* c, std::int32_t attribute, std::int32_t element, const double* time,
                double* value) {
  return guarded(c,
                 [&](ComputeState& s) { *value = graph::number_of(input_of(s, attribute, element, time)); });
}

int read_vector(PlinianContext* c, std::int32_t attribute, std::int32_t element, const double* time,
                float* value) {
  return guarded(c, [&](ComputeState& s) {
    const Value& input = input_of(s, attribute, element, time);
    const int count = std::holds_alternative<vec2>(input) ? 2 : std::holds_alternative<vec4>(input) ? 4 : 3;
    for (int i = 0; i < 4; ++i)
      value[i] = i < count ? float(graph::number_of(graph::component_of(input, i))) : 0.0f;
  });
}

int read_matrix(PlinianContext* c, std::int32_t attribute, std::int32_t element, const double* time,
                double* value) {
  return guarded(c, [&](ComputeState& s) {
    const dmat4& matrix = *std::get<graph::Boxed<dmat4>>(input_of(s, attribute, element, time));
    for (int i = 0; i < 16; ++i) value[i] = matrix[i / 4][i % 4];
  });
}

int read_text(PlinianContext* c, std::int32_t attribute, std::int32_t element, const double* time,
              const char** value) {
  return guarded(c, [&](ComputeState& s) {
    s.held.push_front(std::get<std::string>(input_of(s, attribute, element, time)));
    *value = std::get<std::string>(s.held.front()).c_str();
  });
}

int read_data(PlinianContext* c, std::int32_t attribute, std::int32_t element, const double* time,
              const void** object) {
  return guarded(c, [&](ComputeState& s) {
    const Value& input = input_of(s, attribute, element, time);
    *object = nullptr;
    if (std::holds_alternative<std::monostate>(input)) return;
    s.held.push_front(input);
    if (const DataPtr& data = std::get<DataPtr>(input)) *object = data->object.get();
  });
}

std::size_t elements(PlinianContext* c, std::int32_t array, const std::int32_t** found) {
  // Its answer has no room for a failure, which is then the computation's.
  if (!guarded(c, [&](ComputeState& s) { s.elements = s.context.elements(array); })) {
    state_of(c).elements.clear();
    state_of(c).failure = state_of(c).error;
  }
  *found = state_of(c).elements.data();
  return state_of(c).elements.size();
}

int write_number(PlinianContext* c, std::int32_t attribute, double value) {
  return guarded(c, [&](ComputeState& s) { s.context.set_output(attribute, value); });
}

int write_vector(PlinianContext* c, std::int32_t attribute, const float* value, std::int32_t count) {
  return guarded(c, [&](ComputeState& s) {
    if (count == 2)
      s.context.set_output(attribute, vec2(value[0], value[1]));
    else if (count == 3)
      s.context.set_output(attribute, vec3(value[0], value[1], value[2]));
    else if (count == 4)
      s.context.set_output(attribute, vec4(value[0], value[1], value[2], value[3]));
    else
      throw GraphError("a vector has 2 to 4 numbers");
  });
}

int write_matrix(PlinianContext* c, std::int32_t attribute, const double* value) {
  return guarded(c, [&](ComputeState& s) {
    dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = value[i];
    s.context.set_output(attribute, graph::Boxed<dmat4>(matrix));
  });
}

int write_text(PlinianContext* c, std::int32_t attribute, const char* value) {
  return guarded(c, [&](ComputeState& s) { s.context.set_output(attribute, text_of(value)); });
}

int write_data(PlinianContext* c, std::int32_t attribute, const PlinianData* plain) {
  const DataPtr data = data_from(plain, state_of(c).data);
  return guarded(c, [&](ComputeState& s) {
    if (data->type.starts_with("plinian."))
      throw GraphError("data of the type " + data->type + " are the program's own");
    s.context.set_output(attribute, data);
  });
}

int cancelled(PlinianContext* c) {
  return state_of(c).context.cancelled();
}

void progress(PlinianContext* c, double fraction, const char* what) {
  guarded(c, [&](ComputeState& s) { s.context.progress(fraction, text_of(what)); });
}

void fail(PlinianContext* c, const char* message) {
  state_of(c).failure = text_of(message);
}

const char* last_error(PlinianContext* c) {
  return state_of(c).error.c_str();
}

int time(PlinianContext* c, double* frames) {
  return guarded(c, [&](ComputeState& s) { *frames = s.context.time(); });
}

int sample_ramp(PlinianContext* c, std::int32_t attribute, std::int32_t element, const double* time,
                float position, float* value) {
  return guarded(c, [&](ComputeState& s) {
    const vec3 found = graph::evaluate(
        *std::get<graph::Boxed<graph::Ramp>>(input_of(s, attribute, element, time)), position);
    for (int i = 0; i < 3; ++i) value[i] = found[i];
  });
}

}  // namespace

const PlinianCompute compute_table = {sizeof(PlinianCompute),
                                      read_number,
                                      read_vector,
                                      read_matrix,
                                      read_text,
                                      read_data,
                                      elements,
                                      write_number,
                                      write_vector,
                                      write_matrix,
                                      write_text,
                                      write_data,
                                      cancelled,
                                      progress,
                                      fail,
                                      last_error,
                                      time,
                                      sample_ramp,
                                      volumes::read,
                                      volumes::make,
                                      volumes::write,
                                      volumes::info,
                                      volumes::read_voxels};

}  // namespace plinian::sdk
