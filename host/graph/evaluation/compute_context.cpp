// Typed reading of inputs.
#include "host/graph/evaluation/compute_context.h"

#include "host/graph/model/conversion.h"

namespace plinian::graph {

double ComputeContext::number(AttributeIndex attribute, std::int32_t element) {
  return number_of(input(attribute, element));
}
int ComputeContext::integer(AttributeIndex attribute, std::int32_t element) {
  return std::get<int>(input(attribute, element));
}
bool ComputeContext::boolean(AttributeIndex attribute, std::int32_t element) {
  return std::get<bool>(input(attribute, element));
}
const std::string& ComputeContext::text(AttributeIndex attribute, std::int32_t element) {
  return std::get<std::string>(input(attribute, element));
}
vec3 ComputeContext::vector(AttributeIndex attribute, std::int32_t element) {
  return std::get<vec3>(input(attribute, element));
}

}  // namespace plinian::graph
