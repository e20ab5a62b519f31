// A plug: one attribute of one node, or one element or component of it.
#pragma once

#include <cstdint>
#include <functional>

#include "host/graph/types/schema.h"

namespace plinian::graph {

/// Holds identifiers only, so that it may be kept for as long as one likes. Ordered by node, then as
/// declared.
struct Plug {
  NodeId node;
  AttributeIndex attribute = no_attribute;
  std::int32_t element =
      -1;  // of the array that the attribute is or is a part of; -1: no array, or all of it
  std::int32_t component = -1;  // x, y, z, w of a vector; -1: all of it
  auto operator<=>(const Plug&) const = default;

  /// The plug that it is a component of, or itself.
  Plug whole() const { return {node, attribute, element, -1}; }
};

}  // namespace plinian::graph

template <>
struct std::hash<plinian::graph::Plug> {
  std::size_t operator()(const plinian::graph::Plug& plug) const noexcept {
    const std::uint64_t place = std::uint64_t(plug.node.value) << 32 ^ std::uint64_t(plug.attribute) << 20 ^
                                std::uint64_t(std::uint32_t(plug.element)) << 3 ^
                                std::uint32_t(plug.component);
    return std::size_t((place * 0x9e3779b97f4a7c15ull) >> 7);
  }
};
