// A picture in memory: named float channels, and what is known about how it was made.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/scene/camera.h"
#include "core/scene/frame.h"
#include "core/shared/glue.h"

namespace plinian {

/// A picture, a file or a view that cannot be used: one line that names it, the reason and what to do.
struct ImageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A fact that travels with a picture. A mat4 is stored in files so that its memory, read row by row, is the
/// matrix of row vectors that OpenEXR expects.
using Attribute = std::variant<int, float, std::string, mat4>;

/// Names under which Plinian's own facts are stored, so that writers and readers agree.
namespace attribute {
inline constexpr const char* command = "plinian:command";        // string: the command line that made it
inline constexpr const char* version = "plinian:version";        // string
inline constexpr const char* renderer = "plinian:renderer";      // string: gl, cpu, reference
inline constexpr const char* preset = "plinian:preset";          // string
inline constexpr const char* scene_hash = "plinian:scene_hash";  // string
inline constexpr const char* job_hash = "plinian:job_hash";      // string: all that a frame depends on
inline constexpr const char* frame = "plinian:frame";            // int: of a sequence
inline constexpr const char* seed = "plinian:seed";              // int
inline constexpr const char* passes = "plinian:passes";          // int
inline constexpr const char* time_prefix = "plinian:time_ms:";  // float [ms], followed by the part: map, view
inline constexpr const char* world_to_camera = "worldToCamera";  // mat4, as other programs name it
inline constexpr const char* world_to_ndc = "worldToNDC";        // mat4, onto [-1, 1], y up
}  // namespace attribute

struct Channel {
  std::string name;           // layer.channel, as in OpenEXR: R, Z, key.R
  std::vector<float> values;  // width * height, top row first
};

struct Image {
  int width = 0, height = 0;                  // [pixels]
  std::vector<Channel> channels;              // linear Rec.709 radiance where they are colours
  std::map<std::string, Attribute> metadata;  // any order
  bool display_referred = false;  // read from a file whose values had been through a view or clipped

  std::size_t pixel_count() const { return std::size_t(width) * std::size_t(height); }
  /// The channel of that exact name, or null.
  const Channel* find(std::string_view name) const;
  Channel* find(std::string_view name);
  /// Appends a channel of one value. Throws ImageError where the name is taken.
  Channel& add(std::string name, float value = 0.0f);
};

/// The three planes that are a picture's colour; valid as long as the picture.
struct Colour {
  const float *r, *g, *b;  // width * height values each
  vec3 operator[](std::size_t pixel) const { return {r[pixel], g[pixel], b[pixel]}; }
};

/// R, G and B; else those of the first layer that has them, one called `Combined` or `beauty` first; else Y,
/// or the only channel, three times. Throws ImageError, listing the channels, where there is no colour.
Colour colour_of(const Image& image);

/// An empty picture with channels R, G, B set to one colour. Throws ImageError unless 1 <= width, height.
Image make_image(int width, int height, vec3 colour = vec3(0.0f));

/// Every layer of a rendered frame as channels: R G B A, Z, transmittance.RGB, ambient.RGB, emission.RGB,
/// background.RGB and <light>.RGB. A = 1 - mean transmittance. A light's name is made safe (letters, digits,
/// `_`,
/// `-`) and unique by a number. Throws ImageError where a plane has not width * height pixels.
Image frame_to_image(const Frame& frame);

/// Adds the camera to a picture's metadata, under the names that other programs read: worldToCamera (the
/// camera looks along -z), worldToNDC (x, y on [-1, 1], y up; the third is 1 - 1/z), focal length and film
/// back [mm].
void add_camera_metadata(Image& image, const Camera& camera);

/// Averages factor x factor blocks of every channel; a rest at the right and bottom is averaged over what
/// there is. factor >= 1.
Image box_downsample(const Image& image, int factor);

}  // namespace plinian
