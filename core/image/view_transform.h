// How a picture's linear radiance is turned into what a display shows: exposure, then sRGB, the filmic curve
// or an OpenColorIO view, then gamma.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/image/image.h"

namespace plinian {

enum class View {
  srgb,    // clip to [0, 1], sRGB encoding: exact, for measuring
  filmic,  // core/shared/view_curve.h: for looking
  ocio,    // a display and view of an OpenColorIO configuration
};

struct ViewSettings {
  View view = View::filmic;
  float exposure = 0.0f;     // [stops] radiance is multiplied by 2^exposure first
  std::string ocio_config;   // path of a configuration; empty: the one that $OCIO names
  std::string ocio_display;  // empty: the configuration's default
  std::string ocio_view;     // empty: that display's default
  float gamma = 1.0f;        // [-] > 0: what would be shown is raised to 1 / gamma
};

struct OcioView {
  std::string display, view;
};
/// Of the configuration that $OCIO names, its default first; none where there is none or it cannot be read.
std::vector<OcioView> ocio_views();

/// "srgb", "filmic", "ocio" or "ocio:DISPLAY/VIEW". Throws ImageError that lists them.
ViewSettings parse_view(const std::string& text);

/// filmic, or ocio where $OCIO is set.
View default_view();

/// Immutable; copies are cheap and may be used from several threads.
class ViewTransform {
 public:
  /// Throws ImageError where an OpenColorIO configuration is missing, cannot be read or lacks the display or
  /// view; the message lists those there are.
  explicit ViewTransform(const ViewSettings& settings = {});
  /// Linear Rec.709 radiance to display values, for `count` pixels of three floats, in place. Not-a-number
  /// becomes 0, infinity 1e30. Results are in [0, 1].
  void apply(float* rgb, std::size_t count) const;
  vec3 operator()(vec3 radiance) const;
  const ViewSettings& settings() const { return settings_; }
  /// What it is called: "filmic, +1 stop".
  std::string description() const;

 private:
  struct Ocio;
  ViewSettings settings_;
  std::shared_ptr<const Ocio> ocio_;
};

/// 8 bits per channel, interleaved r g b, width * height * 3 bytes. `dither` spreads the rounding over
/// neighbouring pixels with interleaved gradient noise [Jimenez 2014], the same for every picture and for the
/// three channels: no banding in dark gradients, greys stay grey, and values that 8 bits hold exactly (black,
/// white) stay exact.
std::vector<std::uint8_t> to_display_bytes(const Image& image, const ViewTransform& view, bool dither = true);

}  // namespace plinian
