// Which values a connection may carry, and what becomes of them on the way.
#pragma once

#include "host/graph/types/attribute_spec.h"

namespace plinian::graph {

/// Why `source` cannot drive `destination` (one sentence), or empty where it can. Numbers drive numbers
/// unless they measure different things; a component counts as a number; vectors drive vectors of their
/// length; texts drive paths; the rest drives its own kind.
std::string connection_problem(const AttributeSpec& source, bool source_component,
                               const AttributeSpec& destination, bool destination_component);

/// The value as the destination takes it: numbers rounded to integers, clamped to the hard range. Throws
/// GraphError where it cannot hold it, as an enum may not.
Value converted(const Value& value, const AttributeSpec& destination);

/// One number of a vector; `value` itself for component -1.
Value component_of(const Value& value, int component);

/// The vector with one of its numbers replaced.
Value with_component(const Value& vector, int component, double number);

/// A number as a double. Throws GraphError where the value is none.
double number_of(const Value& value);

}  // namespace plinian::graph
