// Lets one source be compiled as C++20 through GLM and as GLSL 4.50. Every other file of this folder includes
// it first and is written in the common subset: pure functions, values in, values out, `1.0f` literals, no
// swizzles.
#ifndef PLINIAN_SHARED_GLUE_H
#define PLINIAN_SHARED_GLUE_H

#ifdef __cplusplus

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>

namespace plinian {
using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::mat3;
using glm::mat4;
using glm::uvec2;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;

// Shared functions live in plinian::shared, where the GLSL built-ins have their GLSL names.
namespace shared {
using glm::abs;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::exp;
using glm::floatBitsToUint;
using glm::floor;
using glm::fract;
using glm::greaterThan;
using glm::greaterThanEqual;
using glm::length;
using glm::lessThan;
using glm::log;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::packHalf2x16;
using glm::pow;
using glm::sin;
using glm::sqrt;
using glm::uintBitsToFloat;
using glm::unpackHalf2x16;
}  // namespace shared
}  // namespace plinian

#define PLN_BEGIN     \
  namespace plinian { \
  namespace shared {
#define PLN_END \
  }             \
  }
#define PLN_FN inline
#define PLN_CONST inline constexpr
#define PLN_OUT(type) type&
#define PLN_INOUT(type) type&
#define PLN_COEFFICIENTS(name) float(&name)[16]

#else  // GLSL

#define PLN_BEGIN
#define PLN_END
#define PLN_FN
#define PLN_CONST const
#define PLN_OUT(type) out type
#define PLN_INOUT(type) inout type
#define PLN_COEFFICIENTS(name) inout float name[16]

#endif
#endif
