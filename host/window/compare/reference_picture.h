// From a picture in a file to one that the view can be compared with: its layer, its colour space, and what
// it has behind its medium.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/scene/frame.h"

namespace plinian::window {

/// Layers of a picture that have a colour, by name: "" for its own, then those with R, G and B. May be empty.
std::vector<std::string> colour_layers(const Image& image);

struct ReadPicture {
  Frame frame;  // beauty is what the file holds; transmittance 1 - alpha; background its own share;
                // ambient, emission and lights of the layers that have a colour
  bool has_alpha = false;                          // else the transmittance is 0 everywhere
  bool has_ambient = false, has_emission = false;  // likewise
  bool is_scene_linear = false;                    // its exposure was not lost in a view
};

/// layer: one of colour_layers, or empty. colour_space: auto, linear, srgb. exposure: [stops] on all of it.
/// Its background is the layer of that name or, where pixels with no alpha have a colour, that colour behind
/// all of it. Throws ImageError, listing the layers, where there is no such one.
ReadPicture read_picture(const Image& image, const std::string& layer, const std::string& colour_space,
                         float exposure);

/// What a picture from a file is rid of before it is measured.
struct Matching {
  bool exposure = false, background = false;
  bool operator==(const Matching&) const = default;
};

/// What tells nothing of a medium and its light: what is behind it, where an alpha says how much of that is
/// seen, and the exposure of what went through a view. That of scene-linear radiance is looked for.
Matching usual_matching(const ReadPicture& other);

struct Match {
  Frame frame;  // the other picture as it is measured
  std::optional<float>
      stops;                // [EV] it was made brighter by; none where it was not, or that could not be told
  bool background = false;  // the picture's stands behind it in place of its own
  /// "matched by +0.31 EV, over this background" or "" where nothing was done.
  std::string text() const;
};

/// Makes another picture differ from `picture` in nothing that is a matter of how it was put out, of what is
/// asked for: puts the picture's background [radiance] behind it (where it has an alpha) and gives it the
/// exposure at which the sum of squared differences of radiance is least. Both of one size.
Match match(const Frame& picture, vec3 background, const ReadPicture& other, Matching matching);

}  // namespace plinian::window
