// The values that attributes hold and computations hand on.
//
// Conventions, stated once: a distance is in metres, an angle in degrees, a time in frames; a colour is
// linear Rec.709; a matrix takes column vectors.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "core/shared/glue.h"
#include "host/graph/values/hash.h"
#include "host/graph/values/ramp.h"

namespace plinian::graph {

enum class AttributeType : std::uint8_t {
  boolean,
  integer,
  float1,
  double1,
  choice,  // "enum": an integer that has words; may have gaps
  string,
  path,  // as typed, environment variables and all
  float2,
  float3,
  float4,
  colour,
  matrix,
  distance,  // [m]
  angle,     // [degrees]
  time,      // [frames]
  node,      // a reference to a node
  ramp,
  compound,  // holds no value; its children do
  data,      // opaque: a volume, a picture
};

/// "bool", "float3", "enum", as scenes and commands spell a type.
std::string_view type_name(AttributeType type);

/// The type of that name. Throws GraphError, with the nearest name, where there is none.
AttributeType type_of_name(std::string_view name);

/// Numbers in a value of the type that can be driven one by one: 2 to 4 for vectors and colours, else 0.
int component_count(AttributeType type);

/// One number, whatever it measures: bool, int, float, double, enum, distance, angle, time.
bool is_number(AttributeType type);

/// A node's number: never used twice in a scene, so that it may be kept where a pointer may not. 0: none.
struct NodeId {
  std::uint32_t value = 0;
  explicit operator bool() const { return value != 0; }
  auto operator<=>(const NodeId&) const = default;
};

/// A value too large for the variant, shared between its copies and compared by content.
template <class T>
class Boxed {
 public:
  Boxed() : value_(std::make_shared<const T>()) {}
  explicit Boxed(T value) : value_(std::make_shared<const T>(std::move(value))) {}
  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }
  bool operator==(const Boxed& other) const { return value_ == other.value_ || *value_ == *other.value_; }

 private:
  std::shared_ptr<const T> value_;
};

/// Something that the graph hands on without looking inside: a volume, a picture, a mesh.
struct Data {
  std::string type;                    // only attributes that name the same type connect
  std::shared_ptr<const void> object;  // what it is, the readers of the type know
  std::size_t bytes = 0;               // held in memory by it
  std::uint64_t content = 0;           // equal for equal content; 0: not known
  bool asleep = false;                 // object: the bytes (std::string) of what nobody here can read now
};
using DataPtr = std::shared_ptr<const Data>;

/// Empty (monostate) means: nothing yet, as data have before they are computed.
/// bool; int for integer and enum; double for double, distance, angle and time.
using Value = std::variant<std::monostate, bool, int, float, double, std::string, vec2, vec3, vec4,
                           Boxed<dmat4>, NodeId, Boxed<Ramp>, DataPtr>;

/// 0, false, "", black, the identity, no node, no points, no data.
Value zero_value(AttributeType type);

/// What the value holds, in words: "a text", "3 numbers".
std::string_view describe(const Value& value);

/// Takes a value's content into a hash. Data without a known content count as their address.
void add_to_hash(Hasher& hasher, const Value& value);

/// Memory that the value holds beside itself [bytes].
std::size_t bytes_held(const Value& value);

}  // namespace plinian::graph

template <>
struct std::hash<plinian::graph::NodeId> {
  std::size_t operator()(plinian::graph::NodeId id) const noexcept { return id.value; }
};
