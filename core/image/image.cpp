#include "core/image/image.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <set>

namespace plinian {
namespace {

// Letters, digits, `_` and `-` only: a dot would start a layer of a layer, and readers trip over spaces.
std::string safe_layer_name(const std::string& name) {
  std::string safe;
  for (const unsigned char c : name) safe += std::isalnum(c) || c == '-' ? char(c) : '_';
  return safe.empty() ? "light" : safe;
}

std::string unique_name(const std::string& wanted, std::set<std::string>& taken) {
  std::string name = wanted;
  for (int number = 2; !taken.insert(name).second; ++number) name = wanted + "_" + std::to_string(number);
  return name;
}

void add_layer(Image& image, const std::string& layer, const std::vector<vec3>& plane) {
  if (plane.size() != image.pixel_count())
    throw ImageError("frame: the plane " + (layer.empty() ? "beauty" : layer) + " has " +
                     std::to_string(plane.size()) + " pixels, expected " +
                     std::to_string(image.pixel_count()));
  const char* const names[3] = {"R", "G", "B"};
  for (int c = 0; c < 3; ++c) {
    std::vector<float>& values = image.add(layer.empty() ? names[c] : layer + "." + names[c]).values;
    for (std::size_t i = 0; i < plane.size(); ++i) values[i] = plane[i][c];
  }
}

}  // namespace

const Channel* Image::find(std::string_view name) const {
  const auto found =
      std::find_if(channels.begin(), channels.end(), [&](const Channel& c) { return c.name == name; });
  return found == channels.end() ? nullptr : &*found;
}

Channel* Image::find(std::string_view name) {
  return const_cast<Channel*>(static_cast<const Image*>(this)->find(name));
}

Channel& Image::add(std::string name, float value) {
  if (find(name)) throw ImageError("picture: there already is a channel " + name);
  channels.push_back({std::move(name), std::vector<float>(pixel_count(), value)});
  return channels.back();
}

Colour colour_of(const Image& image) {
  const auto layer = [&](const std::string& prefix) -> Colour {
    const Channel *r = image.find(prefix + "R"), *g = image.find(prefix + "G"), *b = image.find(prefix + "B");
    if (!r || !g || !b) return {nullptr, nullptr, nullptr};
    return {r->values.data(), g->values.data(), b->values.data()};
  };
  if (const Colour c = layer(""); c.r) return c;
  std::vector<std::string> prefixes;
  for (const Channel& channel : image.channels)
    if (channel.name.size() > 2 && channel.name.ends_with(".R"))
      prefixes.push_back(channel.name.substr(0, channel.name.size() - 1));
  std::stable_partition(prefixes.begin(), prefixes.end(), [](const std::string& p) {
    return p.ends_with("Combined.") || p.ends_with("beauty.");
  });
  for (const std::string& prefix : prefixes)
    if (const Colour c = layer(prefix); c.r) return c;
  const Channel* grey = image.find("Y");
  if (!grey && image.channels.size() == 1) grey = &image.channels.front();
  if (grey) return {grey->values.data(), grey->values.data(), grey->values.data()};
  std::string names;
  for (const Channel& channel : image.channels) names += (names.empty() ? "" : ", ") + channel.name;
  throw ImageError("picture: no colour among its channels (" + names + "): R, G and B are needed");
}

Image make_image(int width, int height, vec3 colour) {
  if (width < 1 || height < 1)
    throw ImageError("picture: a size of " + std::to_string(width) + "x" + std::to_string(height) +
                     " holds no pixel");
  Image image;
  image.width = width;
  image.height = height;
  image.add("R", colour.r);
  image.add("G", colour.g);
  image.add("B", colour.b);
  return image;
}

Image frame_to_image(const Frame& frame) {
  Image image;
  image.width = frame.width;
  image.height = frame.height;
  add_layer(image, "", frame.beauty);
  if (frame.transmittance.size() != image.pixel_count() || frame.depth.size() != image.pixel_count())
    throw ImageError("frame: transmittance and depth need " + std::to_string(image.pixel_count()) +
                     " pixels");
  std::vector<float>& alpha = image.add("A").values;
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    const vec3 t = frame.transmittance[i];
    alpha[i] = 1.0f - (t.r + t.g + t.b) / 3.0f;
  }
  image.add("Z").values = frame.depth;
  add_layer(image, "transmittance", frame.transmittance);
  add_layer(image, "ambient", frame.ambient);
  add_layer(image, "emission", frame.emission);
  add_layer(image, "background", frame.background);
  std::set<std::string> taken{"transmittance", "ambient", "emission", "background"};
  for (const LightLayer& light : frame.lights)
    add_layer(image, unique_name(safe_layer_name(light.name), taken), light.radiance);
  return image;
}

void add_camera_metadata(Image& image, const Camera& camera) {
  const dmat4 camera_from_world = glm::inverse(camera.world_from_camera);
  const CameraRays rays = camera_rays(camera, image.width, image.height);
  // A point seen at (x, y) on [-1, 1] lies at origin + z (forward + x right + y up), so the inverse of that
  // basis yields (x z, y z, z), which is a clip position with w = z. Its depth, (z - 1) / z, needs no near
  // plane.
  dmat4 world_from_xyz(1.0);
  world_from_xyz[0] = dvec4(dvec3(rays.right), 0.0);
  world_from_xyz[1] = dvec4(dvec3(rays.up), 0.0);
  world_from_xyz[2] = dvec4(dvec3(rays.forward), 0.0);
  world_from_xyz[3] = dvec4(dvec3(rays.origin), 1.0);
  dmat4 clip_from_xyz(1.0);
  clip_from_xyz[2] = dvec4(0.0, 0.0, 1.0, 1.0);  // clip z = clip w = z of the ray
  clip_from_xyz[3] = dvec4(0.0, 0.0, -1.0, 0.0);
  image.metadata[attribute::world_to_camera] = mat4(camera_from_world);
  image.metadata[attribute::world_to_ndc] = mat4(clip_from_xyz * glm::inverse(world_from_xyz));
  image.metadata["plinian:focal_length_mm"] = camera.focal_length;
  image.metadata["plinian:film_back_width_mm"] = camera.film_back.x;
  image.metadata["plinian:film_back_height_mm"] = camera.film_back.y;
  image.metadata["PixelAspectRatio"] = camera.pixel_aspect;
}

Image box_downsample(const Image& image, int factor) {
  assert(factor >= 1);
  Image small;
  small.width = (image.width + factor - 1) / factor;
  small.height = (image.height + factor - 1) / factor;
  small.metadata = image.metadata;
  small.display_referred = image.display_referred;
  for (const Channel& channel : image.channels) {
    std::vector<float>& values = small.add(channel.name).values;
    for (int y = 0; y < small.height; ++y)
      for (int x = 0; x < small.width; ++x) {
        const int x1 = std::min((x + 1) * factor, image.width), y1 = std::min((y + 1) * factor, image.height);
        double sum = 0.0;
        for (int v = y * factor; v < y1; ++v)
          for (int u = x * factor; u < x1; ++u) sum += channel.values[std::size_t(v) * image.width + u];
        values[std::size_t(y) * small.width + x] =
            float(sum / (double(x1 - x * factor) * double(y1 - y * factor)));
      }
  }
  return small;
}

}  // namespace plinian
