// Manipulator handles in C++.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "host/sdk/abi.h"
#include "host/sdk/plugin/support.h"

namespace plinian {
namespace PLINIAN_HIDDEN sdk {

enum class Grip : std::uint32_t {
  point,      // on a float3: a place
  direction,  // on a float3: a direction whose length is kept
  distance,   // on a number >= 0: along the axis from the origin
  cone        // on an angle: the full angle around the axis
};

/// What an artist takes hold of in a viewport; names of attributes are empty where one is not needed.
struct Handle {
  std::string name{};
  Grip grip = Grip::point;
  std::string attribute{};  // that dragging sets
  std::string origin{};     // float3: where it begins; empty: 0 0 0
  std::string along{};      // float3: its direction; empty: axis
  std::array<float, 3> axis{0, 0, 1};
  std::string length{};     // number: how far from the origin it is shown; empty: 1
  std::string transform{};  // matrix: from the handle's space to the object's; empty: the same
  std::array<float, 3> colour{1, 1, 1};
};

namespace detail {

inline std::vector<PlinianHandle> plain(const std::vector<Handle>& handles) {
  std::vector<PlinianHandle> result;
  for (const Handle& h : handles) {
    PlinianHandle plain{};
    plain.size = sizeof(plain);
    plain.name = h.name.c_str();
    plain.kind = std::uint32_t(h.grip);
    plain.attribute = text_or_null(h.attribute);
    plain.origin = text_or_null(h.origin);
    plain.along = text_or_null(h.along);
    plain.length = text_or_null(h.length);
    plain.transform = text_or_null(h.transform);
    for (std::size_t i = 0; i < 3; ++i) {
      plain.axis[i] = h.axis[i];
      plain.colour[i] = h.colour[i];
    }
    result.push_back(plain);
  }
  return result;
}

}  // namespace detail

}  // namespace sdk
}  // namespace plinian
