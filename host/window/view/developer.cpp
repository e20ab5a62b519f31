// Layers to radiance to bytes.
#include "host/window/view/developer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/image/flip.h"
#include "core/image/heat_map.h"
#include "core/image/metrics.h"

namespace plinian::window {

namespace {

void add(std::vector<vec3>& sum, const std::vector<vec3>& layer) {
  if (layer.size() != sum.size()) return;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += layer[i];
}

float alpha_of(vec3 transmittance) {
  return 1.0f - (transmittance.x + transmittance.y + transmittance.z) / 3.0f;
}

bool sees_lights_alone(const Development& how) {
  return !how.solo.empty() || how.solo_ambient;
}

// The layers whose sum is the light that is seen.
std::vector<const std::vector<vec3>*> layers_of_light(const Frame& frame, const Development& how) {
  if (!sees_lights_alone(how)) {
    if (how.layer == "ambient") return {&frame.ambient};
    return {how.layer == "emission" ? &frame.emission : &frame.beauty};
  }
  std::vector<const std::vector<vec3>*> layers;
  if (how.solo_ambient) layers.push_back(&frame.ambient);
  for (const LightLayer& light : frame.lights)
    if (how.solo.contains(light.name)) layers.push_back(&light.radiance);
  return layers;
}

std::vector<vec3> layer_of(const Frame& frame, const Development& how) {
  const std::size_t pixels = frame.beauty.size();
  const auto layers = layers_of_light(frame, how);
  if (sees_lights_alone(how)) {
    std::vector<vec3> sum(pixels, vec3(0.0f));
    for (const std::vector<vec3>* layer : layers) add(sum, *layer);
    return sum;
  }
  if (how.layer == "alpha") {
    std::vector<vec3> alpha(pixels);
    for (std::size_t i = 0; i < pixels; ++i) alpha[i] = vec3(alpha_of(frame.transmittance[i]));
    return alpha;
  }
  if (how.layer == "depth") {
    // Near is white; the range is that of the picture.
    float nearest = INFINITY, farthest = 0.0f;
    for (const float d : frame.depth)
      if (std::isfinite(d)) {
        nearest = std::min(nearest, d);
        farthest = std::max(farthest, d);
      }
    std::vector<vec3> depth(pixels, vec3(0.0f));
    for (std::size_t i = 0; i < pixels; ++i)
      if (std::isfinite(frame.depth[i]))
        depth[i] = vec3(1.0f - 0.9f * (frame.depth[i] - nearest) / std::max(farthest - nearest, 1e-6f));
    return depth;
  }
  return *layers.front();
}

// By how much brighter or darker each channel is [radiance], four times, around a middle grey: what is grey
// agrees.
std::vector<std::uint8_t> difference_bytes(const Image& a, const Image& b) {
  constexpr float gain = 4.0f;
  std::vector<std::uint8_t> bytes(a.pixel_count() * 3);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < a.pixel_count(); ++i) {
      const float d = gain * (a.channels[c].values[i] - b.channels[c].values[i]);
      bytes[3 * i + c] = std::uint8_t(std::lround(255.0f * std::clamp(0.5f + 0.5f * d, 0.0f, 1.0f)));
    }
  return bytes;
}

// The mean of the pixels that each of fewer pixels covers.
Image shrunk(const Image& image, int width, int height) {
  Image small = make_image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int x0 = x * image.width / width, x1 = std::max(x0 + 1, (x + 1) * image.width / width);
      const int y0 = y * image.height / height, y1 = std::max(y0 + 1, (y + 1) * image.height / height);
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0.0;
        for (int v = y0; v < y1; ++v)
          for (int u = x0; u < x1; ++u)
            sum += image.channels[c].values[std::size_t(v) * std::size_t(image.width) + std::size_t(u)];
        small.channels[c].values[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
            float(sum / double((x1 - x0) * (y1 - y0)));
      }
    }
  return small;
}

// A picture at a place [-] of its sides, between the four pixels around it.
vec3 sampled(const Frame& frame, float x, float y) {
  const float u = std::clamp(x * float(frame.width) - 0.5f, 0.0f, float(frame.width - 1));
  const float v = std::clamp(y * float(frame.height) - 0.5f, 0.0f, float(frame.height - 1));
  const int x0 = int(u), y0 = int(v), x1 = std::min(x0 + 1, frame.width - 1),
            y1 = std::min(y0 + 1, frame.height - 1);
  const auto at = [&](int i, int j) { return frame.beauty[std::size_t(j) * frame.width + std::size_t(i)]; };
  return glm::mix(glm::mix(at(x0, y0), at(x1, y0), u - float(x0)),
                  glm::mix(at(x0, y1), at(x1, y1), u - float(x0)), v - float(y0));
}

// The plate in place of the background.
void put_behind(Image& image, const Frame& frame, const Frame& plate) {
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const std::size_t i = std::size_t(y) * frame.width + std::size_t(x);
      const vec3 t = frame.transmittance[i];
      if (t == vec3(0.0f)) continue;
      const vec3 change = t * sampled(plate, (float(x) + 0.5f) / float(frame.width),
                                      (float(y) + 0.5f) / float(frame.height)) -
                          frame.background[i];
      for (int c = 0; c < 3; ++c) image.channels[std::size_t(c)].values[i] += change[c];
    }
}

bool sees_beauty(const Development& how) {
  return !sees_lights_alone(how) && how.layer.empty();
}

// A picture from a file, as it is measured.
ViewPicturePtr matched_picture(const ViewPicture& picture, const Development& how, std::string& said) {
  if (how.matching == Matching{} || !sees_beauty(how)) return how.against;
  const Match matched =
      match(picture.frame, picture.scene.background, how.against_file->picture, how.matching);
  said = matched.text();
  auto other = std::make_shared<ViewPicture>(*how.against);
  other->frame = matched.frame;
  return other;
}

// Without what is seen through the media: the sky is as bright as it is. None of what was played, where that
// is in no layer of its own.
std::optional<Image> light_of_media(const Frame& frame, const Development& how) {
  Image image = visible_layers(frame, how);
  if (!sees_beauty(how)) return image;
  if (frame.background.size() != frame.beauty.size()) return std::nullopt;
  for (int c = 0; c < 3; ++c) {
    std::vector<float>& values = image.channels[std::size_t(c)].values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= frame.background[i][c];
  }
  return image;
}

// How bright the one is, as a share of the other, where the picture has a medium.
std::optional<vec3> balance_of(const Image& image, const Image& other, const Frame& picture) {
  constexpr float least_alpha = 0.01f;
  const PicturePair pair = pair_pictures(image, other);
  dvec3 sum(0.0), reference(0.0);
  for (std::size_t i = 0; i < pair.a.size(); ++i)
    if (pair.valid[i] && alpha_of(picture.transmittance[i]) > least_alpha) {
      sum += dvec3(pair.a[i]);
      reference += dvec3(pair.reference[i]);
    }
  if (!(reference.x > 0.0 && reference.y > 0.0 && reference.z > 0.0)) return std::nullopt;
  return vec3(sum / reference);
}

// image: what is seen of the picture. other: likewise of what it is measured against; of its size, as it was
// matched. as_it_came: its media's light before that, which matching would hide.
void measure_pair(Developed& developed, const Image& image, const Image& other,
                  const std::optional<Image>& as_it_came, const Development& how) {
  Figures& figures = *developed.figures;
  const PicturePair pair = pair_pictures(image, other);
  const PixelMetrics metrics = pixel_metrics(pair);
  figures.psnr = metrics.psnr;
  figures.ssim = ssim(pair, metrics.peak);
  const Frame& frame = developed.picture->frame;
  const std::optional<Image> light = light_of_media(frame, how);
  if (light && as_it_came) figures.balance = balance_of(*light, *as_it_came, frame);
  if (how.seen == Seen::difference) developed.bytes = difference_bytes(image, other);
  if (how.seen == Seen::flip) {
    const FlipResult seen =
        flip(pair.a, pair.reference, pair.width, pair.height, {.exposure = how.view.exposure});
    figures.flip = seen.mean;
    developed.bytes = heat_bytes(seen.map, 1.0f);
  }
}

void measure(Developed& developed, const Image& image, const Development& how) {
  Figures& figures = developed.figures.emplace();
  developed.other =
      how.against_file ? matched_picture(*developed.picture, how, figures.matched) : how.against;
  measure_pair(developed, image, visible_layers(developed.other->frame, how),
               light_of_media(how.against->frame, how), how);
}

// Whether the other picture is matched alike for both.
bool measures_alike(const Development& a, const Development& b) {
  return a.against == b.against && a.against_file == b.against_file && a.matching == b.matching &&
         a.layer == b.layer && a.solo == b.solo && a.solo_ambient == b.solo_ambient;
}

// Of a quick picture, which has fewer pixels: what follows a hand says which way to go.
void measure_roughly(Developed& developed, const Image& image, const Development& how, const Measured* last) {
  const bool alike = last && measures_alike(last->how, how);
  developed.other = alike ? last->other : how.against;
  developed.is_rough = true;
  // How it would be matched is not known yet.
  if (!alike && how.against_file && how.matching != Matching{} && sees_beauty(how)) return;
  developed.figures.emplace().matched = alike ? last->matched : "";
  const auto small = [&](const Image& whole) { return shrunk(whole, developed.width, developed.height); };
  std::optional<Image> as_it_came = light_of_media(how.against->frame, how);
  if (as_it_came) as_it_came = small(*as_it_came);
  measure_pair(developed, image, small(visible_layers(developed.other->frame, how)), as_it_came, how);
}

// Of each pixel the mean error along its ray, weighted by what is seen there, of its worst light.
void develop_map_error(Developed& developed, const Frame& frame, const Development& how) {
  constexpr float least_alpha = 0.01f;
  MapError error;
  error.pixels.assign(frame.beauty.size(), 0.0f);
  double count = 0.0;
  for (std::size_t i = 0; i < error.pixels.size(); ++i) {
    const float alpha = alpha_of(frame.transmittance[i]);
    if (!(alpha > least_alpha)) continue;
    for (const LightLayer& light : frame.lights) {
      if (!how.solo.empty() && !how.solo.contains(light.name)) continue;
      const vec3 e = light.radiance[i];
      error.pixels[i] = std::max(error.pixels[i], (e.x + e.y + e.z) / (3.0f * alpha));
    }
    error.mean += error.pixels[i];
    error.worst = std::max(error.worst, double(error.pixels[i]));
    count += 1.0;
  }
  error.mean /= std::max(count, 1.0);
  developed.bytes = heat_bytes(error.pixels, MapError::full_scale);
  developed.map_error = std::move(error);
}

}  // namespace

std::string lacking_layer(const Development& how) {
  if (!how.against_file) return "";
  const ReadPicture& file = how.against_file->picture;
  for (const std::string& light : how.solo)
    if (std::ranges::find(file.frame.lights, light, &LightLayer::name) == file.frame.lights.end())
      return light;
  if (!file.has_ambient && (how.solo_ambient || how.layer == "ambient")) return "ambient";
  if (!file.has_emission && how.layer == "emission") return "emission";
  if (!file.has_alpha && how.layer == "alpha") return "alpha";
  return how.layer == "depth" ? "depth" : "";
}

vec3 visible_radiance(const Frame& frame, const Development& how, std::size_t pixel) {
  vec3 sum(0.0f);
  for (const std::vector<vec3>* layer : layers_of_light(frame, how))
    if (layer->size() == frame.beauty.size()) sum += (*layer)[pixel];
  return sum;
}

std::string words_of(const Development& how) {
  std::string words =
      fmt::format("{} {} {} {} {} {} {} {}", how.solo_ambient, int(how.view.view), how.view.exposure,
                  how.view.gamma, how.view.ocio_config, how.view.ocio_display, how.view.ocio_view, how.layer);
  words += fmt::format(" {} {} {} {} {} {}", static_cast<const void*>(how.against.get()),
                       static_cast<const void*>(how.against_file.get()), how.matching.exposure,
                       how.matching.background, int(how.seen), static_cast<const void*>(how.plate.get()));
  for (const std::string& light : how.solo) words += " " + light;
  return words;
}

Image visible_layers(const Frame& frame, const Development& how) {
  const std::vector<vec3> seen = layer_of(frame, how);
  Image image = make_image(frame.width, frame.height);
  for (int c = 0; c < 3; ++c) {
    std::vector<float>& values = image.channels[std::size_t(c)].values;
    for (std::size_t i = 0; i < seen.size() && i < values.size(); ++i) values[i] = seen[i][c];
  }
  return image;
}

DevelopedPtr develop(const ViewPicturePtr& picture, const Development& how, const Measured* last) {
  auto developed = std::make_shared<Developed>();
  developed->against = how.against;
  developed->picture = picture;
  developed->width = picture->frame.width;
  developed->height = picture->frame.height;
  // A picture that was asked for before the view changed is still one of light, and the other way round.
  const bool is_error = picture->scene.quality.view.light == LightLookup::error;
  if (is_error != how.sees_map_error()) return nullptr;
  if (is_error) {
    develop_map_error(*developed, picture->frame, how);
    return developed;
  }
  const Image image = visible_layers(picture->frame, how);
  Image seen = image;
  if (how.plate && sees_beauty(how)) put_behind(seen, picture->frame, how.plate->picture.frame);
  try {
    developed->bytes = to_display_bytes(seen, ViewTransform(how.view));
  } catch (const ImageError& error) {
    developed->error = error.what();
    developed->bytes = to_display_bytes(
        seen, ViewTransform({.view = View::srgb, .exposure = how.view.exposure, .gamma = how.view.gamma}));
  }
  if (!how.against) return developed;
  const ivec2 size = picture->quick ? ivec2(picture->scene.width, picture->scene.height)
                                    : ivec2(developed->width, developed->height);
  if (size != ivec2(how.against->frame.width, how.against->frame.height)) return developed;
  developed->lacks = lacking_layer(how);
  if (!developed->lacks.empty()) return developed;
  if (picture->quick)
    measure_roughly(*developed, image, how, last);
  else
    measure(*developed, image, how);
  return developed;
}

Developer::Developer(std::function<void()> wake) : wake_(std::move(wake)), thread_([this] { run(); }) {}

Developer::~Developer() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  news_.notify_all();
  thread_.join();
}

void Developer::ask(ViewPicturePtr picture, const Development& how) {
  {
    const std::lock_guard lock(mutex_);
    waiting_ = std::move(picture);
    how_ = how;
  }
  news_.notify_all();
}

DevelopedPtr Developer::developed() const {
  const std::lock_guard lock(mutex_);
  return developed_;
}

void Developer::forget() {
  const std::lock_guard lock(mutex_);
  waiting_ = nullptr;
  how_ = {};
  developed_ = nullptr;
}

void Developer::run() {
  std::optional<Measured> last;
  for (;;) {
    ViewPicturePtr picture;
    Development how;
    {
      std::unique_lock lock(mutex_);
      news_.wait(lock, [&] { return stopping_ || waiting_; });
      if (stopping_) return;
      picture = std::move(waiting_);
      how = how_;
    }
    DevelopedPtr developed = develop(picture, how, last ? &*last : nullptr);
    if (!developed) continue;
    if (developed->figures && !developed->is_rough)
      last = {how, developed->other, developed->figures->matched};
    else if (!how.against)
      last.reset();
    {
      const std::lock_guard lock(mutex_);
      developed_ = std::move(developed);
    }
    wake_();
  }
}

}  // namespace plinian::window
