#include "core/image/view_transform.h"

#include <OpenColorIO/OpenColorIO.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/shared/view_curve.h"

namespace OCIO = OCIO_NAMESPACE;

namespace plinian {
namespace {

std::string list(int count, const auto& name_of) {
  std::string names;
  for (int i = 0; i < count; ++i) names += (i ? ", " : "") + std::string(name_of(i));
  return names;
}

// Our radiance has the primaries of Rec.709. Configurations name that space in a few ways; failing those, the
// scene_linear role is what a studio's own pictures are in.
std::string linear_space(const OCIO::Config& config) {
  for (const char* name :
       {"Linear Rec.709 (sRGB)", "lin_rec709", "lin_rec709_scene", "lin_srgb", "Utility - Linear - sRGB",
        "Utility - Linear - Rec.709", "Linear Rec.709", "Linear"})
    if (config.getColorSpace(name)) return name;
  return OCIO::ROLE_SCENE_LINEAR;
}

float finite_radiance(float value) {
  if (std::isnan(value)) return 0.0f;
  constexpr float largest = 1e30f;  // far enough from overflow for sums of channels
  return std::fmin(std::fmax(value, -largest), largest);
}

// In [-0.5, 0.5) of a code value.
float gradient_noise(int x, int y) {
  const float inner = 0.06711056f * float(x) + 0.00583715f * float(y);
  const float value = 52.9829189f * (inner - std::floor(inner));
  return value - std::floor(value) - 0.5f;
}

}  // namespace

struct ViewTransform::Ocio {
  OCIO::ConstCPUProcessorRcPtr processor;
};

ViewSettings parse_view(const std::string& text) {
  ViewSettings settings;
  if (text == "srgb") {
    settings.view = View::srgb;
  } else if (text == "filmic") {
    settings.view = View::filmic;
  } else if (text == "ocio") {
    settings.view = View::ocio;
  } else if (const std::size_t slash = text.find('/');
             text.starts_with("ocio:") && slash != std::string::npos) {
    settings.view = View::ocio;
    settings.ocio_display = text.substr(5, slash - 5);
    settings.ocio_view = text.substr(slash + 1);
  } else {
    throw ImageError("view: unknown view '" + text + "': use srgb, filmic, ocio or ocio:DISPLAY/VIEW");
  }
  return settings;
}

View default_view() {
  const char* config = std::getenv("OCIO");
  return config && *config ? View::ocio : View::filmic;
}

std::vector<OcioView> ocio_views() {
  std::vector<OcioView> views;
  const char* path = std::getenv("OCIO");
  if (!path || !*path) return views;
  try {
    const OCIO::ConstConfigRcPtr config = OCIO::Config::CreateFromFile(path);
    const auto add = [&](const std::string& display, const std::string& view) {
      for (const OcioView& known : views)
        if (known.display == display && known.view == view) return;
      views.push_back({display, view});
    };
    add(config->getDefaultDisplay(), config->getDefaultView(config->getDefaultDisplay()));
    for (int d = 0; d < config->getNumDisplays(); ++d)
      for (int v = 0; v < config->getNumViews(config->getDisplay(d)); ++v)
        add(config->getDisplay(d), config->getView(config->getDisplay(d), v));
  } catch (const OCIO::Exception&) {
    views.clear();  // whoever asks for a view hears why
  }
  return views;
}

ViewTransform::ViewTransform(const ViewSettings& settings) : settings_(settings) {
  if (!std::isfinite(settings_.exposure))
    throw ImageError("view: the exposure is not a finite number of stops");
  if (!(settings_.gamma > 0.0f && std::isfinite(settings_.gamma)))
    throw ImageError("view: the gamma is not a number over 0");
  if (settings_.view != View::ocio) return;
  std::string path = settings_.ocio_config;
  if (path.empty()) {
    const char* variable = std::getenv("OCIO");
    if (!variable || !*variable)
      throw ImageError("view: ocio needs a configuration: set $OCIO to its file, or use srgb or filmic");
    path = variable;
  }
  try {
    const OCIO::ConstConfigRcPtr config = OCIO::Config::CreateFromFile(path.c_str());
    std::string& display = settings_.ocio_display;
    std::string& view = settings_.ocio_view;
    if (display.empty()) display = config->getDefaultDisplay();
    if (config->getNumViews(display.c_str()) == 0)
      throw ImageError(path + ": no display '" + display + "' in this OpenColorIO configuration; it has " +
                       list(config->getNumDisplays(), [&](int i) { return config->getDisplay(i); }));
    if (view.empty()) view = config->getDefaultView(display.c_str());
    bool known = false;
    for (int i = 0; i < config->getNumViews(display.c_str()); ++i)
      known = known || view == config->getView(display.c_str(), i);
    if (!known)
      throw ImageError(path + ": no view '" + view + "' on the display '" + display + "'; it has " +
                       list(config->getNumViews(display.c_str()),
                            [&](int i) { return config->getView(display.c_str(), i); }));
    const OCIO::ConstProcessorRcPtr processor = config->getProcessor(
        linear_space(*config).c_str(), display.c_str(), view.c_str(), OCIO::TRANSFORM_DIR_FORWARD);
    ocio_ = std::make_shared<Ocio>(Ocio{processor->getDefaultCPUProcessor()});
  } catch (const OCIO::Exception& error) {
    std::string reason = error.what();
    for (char& c : reason)
      if (c == '\n') c = ' ';
    throw ImageError(path + ": OpenColorIO cannot use this configuration: " + reason);
  }
}

void ViewTransform::apply(float* rgb, std::size_t count) const {
  const float gain = std::exp2(settings_.exposure);
  for (std::size_t i = 0; i < 3 * count; ++i) rgb[i] = finite_radiance(finite_radiance(rgb[i]) * gain);
  if (ocio_ && count > 0) {
    OCIO::PackedImageDesc pixels(rgb, long(count), 1, 3);
    ocio_->processor->apply(pixels);
    for (std::size_t i = 0; i < 3 * count; ++i) rgb[i] = std::fmin(std::fmax(rgb[i], 0.0f), 1.0f);
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      float* p = rgb + 3 * i;
      const vec3 radiance(p[0], p[1], p[2]);
      const vec3 shown =
          settings_.view == View::srgb ? shared::srgb_view(radiance) : shared::filmic_view(radiance);
      for (int c = 0; c < 3; ++c) p[c] = shown[c];
    }
  }
  if (settings_.gamma != 1.0f)
    for (std::size_t i = 0; i < 3 * count; ++i) rgb[i] = std::pow(rgb[i], 1.0f / settings_.gamma);
}

vec3 ViewTransform::operator()(vec3 radiance) const {
  float rgb[3] = {radiance.r, radiance.g, radiance.b};
  apply(rgb, 1);
  return {rgb[0], rgb[1], rgb[2]};
}

std::string ViewTransform::description() const {
  std::string name = settings_.view == View::srgb     ? "sRGB"
                     : settings_.view == View::filmic ? "filmic"
                                                      : settings_.ocio_display + " / " + settings_.ocio_view;
  if (settings_.exposure != 0.0f) {
    char stops[32];
    std::snprintf(stops, sizeof stops, ", %+g stop%s", settings_.exposure,
                  std::abs(settings_.exposure) == 1.0f ? "" : "s");
    name += stops;
  }
  if (settings_.gamma != 1.0f) {
    char gamma[32];
    std::snprintf(gamma, sizeof gamma, ", gamma %g", settings_.gamma);
    name += gamma;
  }
  return name;
}

std::vector<std::uint8_t> to_display_bytes(const Image& image, const ViewTransform& view, bool dither) {
  const Colour colour = colour_of(image);
  const std::size_t width = std::size_t(image.width);
  std::vector<std::uint8_t> bytes(image.pixel_count() * 3);
  tbb::parallel_for(tbb::blocked_range<int>(0, image.height, 16), [&](const tbb::blocked_range<int>& rows) {
    std::vector<float> row(3 * width);
    for (int y = rows.begin(); y != rows.end(); ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        const vec3 radiance = colour[std::size_t(y) * width + x];
        for (int c = 0; c < 3; ++c) row[3 * x + c] = radiance[c];
      }
      view.apply(row.data(), width);
      for (std::size_t i = 0; i < 3 * width; ++i) {
        const float noise = dither ? gradient_noise(int(i / 3), y) : 0.0f;
        // A value within 1/500 of a code value is that value: rounding in the curve must not make it flicker.
        const float level = 255.0f * row[i], nearest = std::round(level);
        const float rounded = std::abs(level - nearest) < 0.002f ? nearest : std::floor(level + noise + 0.5f);
        bytes[std::size_t(y) * 3 * width + i] = std::uint8_t(std::fmin(std::fmax(rounded, 0.0f), 255.0f));
      }
    }
  });
  return bytes;
}

}  // namespace plinian
