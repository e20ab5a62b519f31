// All that a node's compute function may see of the world.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/graph/types/schema.h"

namespace plinian::graph {

class ComputeContext {
 public:
  virtual ~ComputeContext() = default;

  /// The value of an input, as set or as driven. The reference holds until the compute function returns.
  /// Reading an input that does not affect the output is a mistake that is told of once. A path comes whole:
  /// with its variables filled in, and from the scene's folder on where it is relative.
  virtual const Value& input(AttributeIndex attribute, std::int32_t element = -1) = 0;
  /// Elements of an array that exist, ascending.
  virtual std::vector<std::int32_t> elements(AttributeIndex array) = 0;
  /// The value that an input has at another time [frames].
  virtual Value input_at(double time, AttributeIndex attribute, std::int32_t element = -1) = 0;
  virtual void set_output(AttributeIndex attribute, Value value) = 0;

  /// Whether nobody waits for the result any more: return soon, whatever is written is thrown away.
  virtual bool cancelled() const = 0;
  /// How far a long computation is. fraction: in [0, 1].
  virtual void progress(double fraction, std::string_view what) = 0;
  /// Says something of the result that is no failure, in one line; told when the result is new.
  virtual void warn(const std::string& line) = 0;

  /// [frames] For types that tell the time only.
  virtual double time() const = 0;
  virtual const std::string& node_name() const = 0;

  /// Inputs as what they are declared to be; an enum is an integer.
  double number(AttributeIndex attribute, std::int32_t element = -1);
  int integer(AttributeIndex attribute, std::int32_t element = -1);
  bool boolean(AttributeIndex attribute, std::int32_t element = -1);
  const std::string& text(AttributeIndex attribute, std::int32_t element = -1);
  vec3 vector(AttributeIndex attribute, std::int32_t element = -1);
};

}  // namespace plinian::graph
