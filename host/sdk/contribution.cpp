#include "host/sdk/contribution.h"

namespace plinian::sdk {

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
