// A pixel of each, and words for them.
#include "host/window/compare/pixel_readout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plinian::window {

namespace {

std::optional<std::size_t> index_of(const Frame& frame, vec2 at) {
  if (at.x < 0.0f || at.y < 0.0f || at.x >= 1.0f || at.y >= 1.0f || frame.beauty.empty()) return std::nullopt;
  const ivec2 size(frame.width, frame.height), pixel = glm::min(ivec2(at * vec2(size)), size - 1);
  return std::size_t(pixel.y) * std::size_t(size.x) + std::size_t(pixel.x);
}

PixelSeen seen(const Frame& frame, const Development& how, std::size_t index) {
  const vec3 t = frame.transmittance[index];
  return {visible_radiance(frame, how, index), 1.0f - (t.x + t.y + t.z) / 3.0f, frame.depth[index]};
}

// No sign where nothing is left after rounding.
float rounded(float value, float step) {
  const float whole = std::round(value / step) * step;
  return whole == 0.0f ? 0.0f : whole;
}

// The numbers of the layer that is seen, and what there is to say beside them; without RGB where they are not
// what is seen.
struct Words {
  std::string value, more;
};

std::string depth_text(float depth) {
  return std::isfinite(depth) ? fmt::format("z {:.4g} m", depth) : "";
}

Words words_of(const PixelSeen& seen, const PixelReadout& readout, bool aligned) {
  const std::string depth = depth_text(seen.depth), more = depth.empty() ? "" : "   " + depth;
  switch (readout.value) {
    case PixelValue::map_error:
      return {
          fmt::format("|dT| {:.4f}   a {:.3f}", readout.map_error.value_or(0.0f), seen.alpha.value_or(1.0f)),
          more};
    case PixelValue::alpha:
      return {fmt::format("{:{}.4f}", seen.alpha.value_or(1.0f), aligned ? 7 : 0), more};
    case PixelValue::depth:
      return {std::isfinite(seen.depth) ? fmt::format("{:.4g} m", seen.depth) : "none", ""};
    default:
      break;
  }
  const vec3 v = seen.radiance;
  if (!aligned)
    return {fmt::format("{:.4f} {:.4f} {:.4f}   a {:.3f}", v.x, v.y, v.z, seen.alpha.value_or(1.0f)), more};
  return {fmt::format("{:7.4f} {:7.4f} {:7.4f}{}", v.x, v.y, v.z,
                      seen.alpha ? fmt::format("  a {:6.3f}", *seen.alpha) : std::string(10, ' ')),
          more};
}

// By how much a is above b.
std::string difference_of(const PixelSeen& a, const PixelSeen& b, PixelValue value) {
  if (value == PixelValue::alpha)
    return fmt::format("{:+7.4f}", rounded(a.alpha.value_or(1.0f) - b.alpha.value_or(1.0f), 1e-4f));
  if (value == PixelValue::depth)
    return std::isfinite(a.depth) && std::isfinite(b.depth) ? fmt::format("{:+.4g} m", a.depth - b.depth)
                                                            : "";
  const vec3 apart = a.radiance - b.radiance;
  std::string text = fmt::format("{:+7.4f} {:+7.4f} {:+7.4f}", rounded(apart.x, 1e-4f),
                                 rounded(apart.y, 1e-4f), rounded(apart.z, 1e-4f));
  if (a.alpha && b.alpha) text += fmt::format("  a {:+6.3f}", rounded(*a.alpha - *b.alpha, 1e-3f));
  return text;
}

}  // namespace

std::optional<PixelReadout> read_pixel(const Developed& shown, const Development& how, vec2 at,
                                       std::optional<vec2> other_at, const std::string& other_name) {
  const ViewPicture& picture = *shown.picture;
  const auto index = index_of(picture.frame, at);
  if (!index) return std::nullopt;
  PixelReadout readout;
  // A quick picture has fewer pixels: the place is told in those of the one at rest.
  readout.pixel = ivec2(at * vec2(picture.scene.width, picture.scene.height));
  if (shown.map_error) readout.map_error = shown.map_error->pixels[*index];
  const bool alone = !how.solo.empty() || how.solo_ambient;
  if (!alone && how.layer != "beauty") readout.layer = how.layer;
  if (shown.map_error)
    readout.value = PixelValue::map_error;
  else if (readout.layer == "alpha")
    readout.value = PixelValue::alpha;
  else if (readout.layer == "depth")
    readout.value = PixelValue::depth;
  readout.picture = seen(picture.frame, how, *index);
  if (!how.against || !other_at || shown.map_error || !lacking_layer(how).empty()) return readout;
  const Frame& other = (shown.other ? shown.other : how.against)->frame;
  const auto other_index = index_of(other, *other_at);
  if (!other_index) return readout;
  readout.other = seen(other, how, *other_index);
  readout.other_name = other_name;
  if (shown.figures) readout.matched = shown.figures->matched;
  if (how.against_file && !how.against_file->picture.has_alpha) readout.other->alpha.reset();
  if (how.against_file && how.matching != Matching{} && !shown.other) readout.matched = "not matched";
  return readout;
}

std::vector<std::string> readout_lines(const PixelReadout& readout, std::size_t columns) {
  const std::string place = fmt::format("{:4} {:4}", readout.pixel.x, readout.pixel.y);
  const PixelSeen& picture = readout.picture;
  const auto with = [&](std::string line, const std::string& more) {
    return line.size() + more.size() <= columns ? line + more : line;
  };
  const bool is_named = !readout.layer.empty() && readout.value != PixelValue::map_error;
  const std::string layer = is_named ? readout.layer + " " : "";
  if (!readout.other) {
    const Words words = words_of(picture, readout, false);
    return {with(place + "   " + layer + words.value, words.more)};
  }
  constexpr std::size_t longest = 18;  // a name that is left whole
  std::string name = readout.other_name;
  if (name.size() > longest) name = name.substr(0, longest - 3) + "...";
  const std::string difference = "difference";
  const std::size_t wide = std::max(name.size(), difference.size());
  const PixelSeen& other = *readout.other;
  const auto line = [&](const std::string& what, const PixelSeen& seen) {
    const Words words = words_of(seen, readout, true);
    return with(fmt::format("{:<{}} {}{}", what, wide, layer, words.value), words.more);
  };
  return {line(place, picture),
          with(line(name, other), readout.matched.empty() ? "" : "   " + readout.matched),
          fmt::format("{:<{}} {}{}", difference, wide, layer, difference_of(picture, other, readout.value))};
}

}  // namespace plinian::window
