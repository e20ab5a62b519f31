// What the picture holds in a pixel and, where it is compared, what the other one holds there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/window/view/developer.h"

namespace plinian::window {

/// What a value of the layer is that is seen.
enum class PixelValue { radiance, alpha, depth, map_error };

struct PixelSeen {
  vec3 radiance{0.0f};         // [radiance] of the layers that are seen, where they are of light
  std::optional<float> alpha;  // [-] none where a file has none
  float depth = INFINITY;      // [world] infinite where there is nothing, or where that is not known
  bool operator==(const PixelSeen&) const = default;
};

struct PixelReadout {
  ivec2 pixel{0};  // of the picture at rest, from the upper left
  PixelValue value = PixelValue::radiance;
  std::string layer;               // that is seen, where it is not the whole: "alpha", "emission"
  PixelSeen picture;               // linear, whatever the display shows
  std::optional<float> map_error;  // [-] where that is what is seen
  std::optional<PixelSeen> other;  // as it was measured: matched, where it was
  std::string other_name;          // "reference", "ref.0012.exr"
  std::string matched;             // what was done to the other; "not matched" where it could not be
  bool operator==(const PixelReadout&) const = default;
};

/// at: [-] of the picture's sides, from the upper left; other_at: of those of the one that it is held
/// against, where that is to be read too. Nothing beside the picture.
std::optional<PixelReadout> read_pixel(const Developed& shown, const Development& how, vec2 at,
                                       std::optional<vec2> other_at, const std::string& other_name);

/// A line of the picture, with the value of the layer that is seen; with the other below it one for that, and
/// one for by how much the picture is above it. columns: [characters] that there are; depths and what was
/// matched give way.
std::vector<std::string> readout_lines(const PixelReadout& readout, std::size_t columns = std::string::npos);

}  // namespace plinian::window
