#include "host/sdk/contribution.h"

namespace plinian::sdk {

dmat4 rigid_part(const dmat4& matrix) {
  dvec3 axes[3];
  for (int i = 2; i >= 0; --i) {
    axes[i] = dvec3(matrix[i]);
    for (int done = 2; done > i; --done) axes[i] -= dot(axes[i], axes[done]) * axes[done];
    axes[i] /= length(axes[i]);
  }
  return {dvec4(axes[0], 0.0), dvec4(axes[1], 0.0), dvec4(axes[2], 0.0), matrix[3]};
}

graph::AttributeIndex contribution_of(const graph::NodeType& type) {
  const graph::AttributeIndex output = type.schema()->find(contribution_output);
  const bool shape =
      output != graph::no_attribute && (*type.schema())[output].spec.data_type == contribution_type;
  return shape ? output : graph::no_attribute;
}

ShapeContributionPtr contribution_in(const graph::Value& value) {
  const auto* data = std::get_if<graph::DataPtr>(&value);
  if (!data || !*data || (*data)->type != contribution_type) return nullptr;
  return std::static_pointer_cast<const ShapeContribution>((*data)->object);
}

}  // namespace plinian::sdk
