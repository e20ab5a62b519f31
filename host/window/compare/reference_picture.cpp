// Takes pictures apart and matches them.
#include "host/window/compare/reference_picture.h"

#include <fmt/format.h>

#include <cmath>

#include "core/scene/nearest_word.h"

namespace plinian::window {

namespace {

constexpr float seen_alpha = 1e-3f;

float mean(vec3 v) {
  return (v.x + v.y + v.z) / 3.0f;
}

float linear_of_srgb(float v) {
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}
float srgb_of_linear(float v) {
  return v <= 0.0031308f ? v * 12.92f : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
}

struct Planes {
  const float *r = nullptr, *g = nullptr, *b = nullptr;
};

std::optional<Planes> planes_of(const Image& image, const std::string& layer) {
  const Channel *r = image.find(layer + ".R"), *g = image.find(layer + ".G"), *b = image.find(layer + ".B");
  if (!r || !g || !b) return std::nullopt;
  return Planes{r->values.data(), g->values.data(), b->values.data()};
}

// The colour of what has no alpha, where that is more than a few pixels.
vec3 empty_colour(const Frame& frame) {
  vec3 sum(0.0f);
  std::size_t count = 0;
  for (std::size_t i = 0; i < frame.beauty.size(); ++i)
    if (mean(frame.transmittance[i]) > 1.0f - seen_alpha) {
      sum += frame.beauty[i];
      ++count;
    }
  return count >= 16 ? sum / float(count) : vec3(0.0f);
}

}  // namespace

std::vector<std::string> colour_layers(const Image& image) {
  std::vector<std::string> layers;
  if (image.find("R") && image.find("G") && image.find("B")) layers.push_back("");
  for (const Channel& channel : image.channels)
    if (channel.name.ends_with(".R"))
      if (const std::string layer = channel.name.substr(0, channel.name.size() - 2); planes_of(image, layer))
        layers.push_back(layer);
  return layers;
}

ReadPicture read_picture(const Image& image, const std::string& layer, const std::string& colour_space,
                         float exposure) {
  Planes planes;
  if (layer.empty()) {
    const Colour colour = colour_of(image);
    planes = {colour.r, colour.g, colour.b};
  } else if (const auto found = planes_of(image, layer)) {
    planes = *found;
  } else {
    std::vector<std::string> named = colour_layers(image);
    std::erase(named, "");
    throw ImageError("no layer '" + layer + "'" + did_you_mean(layer, named) +
                     (named.empty() ? ": the picture has no layers with a name, leave it empty"
                                    : "; there are: " + join(named)));
  }
  const float gain = std::exp2(exposure);
  const auto value = [&](float v) {
    // What was read is linear where the file said how it is encoded; pictures of 8 bits say sRGB.
    if (colour_space == "srgb" && !image.display_referred) v = linear_of_srgb(v);
    if (colour_space == "linear" && image.display_referred) v = srgb_of_linear(v);
    return v * gain;
  };
  ReadPicture read;
  read.is_scene_linear = colour_space == "linear" || (colour_space == "auto" && !image.display_referred);
  Frame& frame = read.frame;
  frame.width = image.width;
  frame.height = image.height;
  const std::size_t pixels = image.pixel_count();
  frame.beauty.resize(pixels);
  const auto colours = [&](const Planes& of) {
    std::vector<vec3> result(pixels);
    for (std::size_t i = 0; i < pixels; ++i) result[i] = vec3(value(of.r[i]), value(of.g[i]), value(of.b[i]));
    return result;
  };
  frame.beauty = colours(planes);
  frame.transmittance.assign(pixels, vec3(0.0f));
  frame.depth.assign(pixels, INFINITY);
  frame.ambient = frame.emission = frame.background = std::vector<vec3>(pixels, vec3(0.0f));
  // As this program writes them: one for each light, beside others that are known by their names.
  if (layer.empty())
    for (const std::string& name : colour_layers(image)) {
      if (name.empty() || name == "background" || name == "transmittance") continue;
      std::vector<vec3> radiance = colours(*planes_of(image, name));
      if (name == "ambient" || name == "emission") {
        (name == "ambient" ? frame.ambient : frame.emission) = std::move(radiance);
        (name == "ambient" ? read.has_ambient : read.has_emission) = true;
      } else {
        frame.lights.push_back({name, std::move(radiance)});
      }
    }
  const Channel* alpha = image.find("A");
  if (!alpha) return read;
  read.has_alpha = true;
  for (std::size_t i = 0; i < pixels; ++i) frame.transmittance[i] = vec3(1.0f - alpha->values[i]);
  const auto own = planes_of(image, "background");
  const vec3 colour = own ? vec3(0.0f) : empty_colour(frame);
  for (std::size_t i = 0; i < pixels; ++i)
    frame.background[i] =
        own ? vec3(own->r[i], own->g[i], own->b[i]) * gain : colour * frame.transmittance[i];
  return read;
}

Matching usual_matching(const ReadPicture& other) {
  return {!other.is_scene_linear, other.has_alpha};
}

Match match(const Frame& picture, vec3 background, const ReadPicture& other, Matching matching) {
  Match matched;
  matched.frame = other.frame;
  Frame& frame = matched.frame;
  const std::size_t pixels = frame.beauty.size();
  constexpr float negligible = 2e-3f;
  if (other.has_alpha)
    for (std::size_t i = 0; i < pixels; ++i) {
      const vec3 wanted = matching.background ? background * frame.transmittance[i] : frame.background[i];
      const vec3 change = glm::abs(wanted - frame.background[i]);
      if (glm::max(change.x, glm::max(change.y, change.z)) > negligible) matched.background = true;
      frame.beauty[i] -= frame.background[i];
      frame.background[i] = wanted;
    }
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const vec3 a = other.has_alpha ? picture.beauty[i] - picture.background[i] : picture.beauty[i];
    const vec3 b = frame.beauty[i];
    const double ab = double(glm::dot(a, b)), bb = double(glm::dot(b, b));
    if (!std::isfinite(ab) || !std::isfinite(bb)) continue;
    product += ab;
    square += bb;
  }
  if (matching.exposure && product > 0.0 && square > 0.0) {
    matched.stops = float(std::log2(product / square));
    const float gain = float(product / square);
    for (vec3& colour : frame.beauty) colour *= gain;
  }
  if (other.has_alpha)
    for (std::size_t i = 0; i < pixels; ++i) frame.beauty[i] += frame.background[i];
  return matched;
}

std::string Match::text() const {
  std::string words;
  // Also where it is nothing: that it was looked for hides what comes later.
  if (stops) words = fmt::format("matched by {:+.2f} EV", std::abs(*stops) < 0.005f ? 0.0f : *stops);
  if (background) words += words.empty() ? "over this background" : ", over this background";
  return words;
}

}  // namespace plinian::window
