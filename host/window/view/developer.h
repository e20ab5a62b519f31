// Develops pictures: from linear layers to the bytes that a display shows, on a thread of its own, so that
// exposure and view answer at once whatever is being rendered.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "core/image/view_transform.h"
#include "host/window/compare/reference_images.h"
#include "host/window/view/view_renderer.h"

namespace plinian::window {

/// What is seen of a picture that is compared.
enum class Seen { picture, difference, flip };

/// How a picture is looked at. No part of the scene.
struct Development {
  ViewSettings view;
  std::set<std::string> solo;   // lights that are seen alone; empty: all, with everything else
  bool solo_ambient = false;    // ... and the sky's
  ViewPicturePtr against;       // measured against this one, where it has the same size
  FilePicturePtr against_file;  // ... which is this one, from a file
  Matching matching;            // of a file's, first
  Seen seen = Seen::picture;
  FilePicturePtr plate;  // behind what has an alpha, of which it takes the shape
  std::string layer;     // beauty (or empty), alpha, depth, emission, ambient, map error
  bool sees_map_error() const { return layer == "map error"; }
};

/// Words that differ where developments do.
std::string words_of(const Development& how);

/// How far the maps of lights are from the exact transmittance, where media are seen.
struct MapError {
  std::vector<float> pixels;       // [-] |T exact - T map| of the worst light, mean over what is seen; else 0
  double mean = 0.0, worst = 0.0;  // [-] of the pixels that see a medium
  // What the brightest colour stands for [-], always the same: pictures of several qualities are compared by
  // eye.
  static constexpr float full_scale = 0.1f;
};

/// How far a picture is from another one.
struct Figures {
  double psnr = 0.0;            // [dB] of linear radiance, see metrics.h
  double ssim = 0.0;            // [-] likewise
  std::optional<double> flip;   // [-] mean, where it is what is seen
  std::optional<vec3> balance;  // [-] how bright each channel is, as a share of the other picture's as it
                                // came, not as it was matched
  std::string matched;          // what was done to the other first; empty: nothing
};

struct Developed {
  int width = 0, height = 0;          // [pixels]
  std::vector<std::uint8_t> bytes;    // r g b, top row first
  ViewPicturePtr picture;             // that it was made of
  ViewPicturePtr against;             // that it was asked to be held against, as that came
  ViewPicturePtr other;               // as it was matched; null: it cannot be held against it
  std::optional<Figures> figures;     // against that
  bool is_rough = false;              // of a quick picture, against the other as small as that is
  std::optional<MapError> map_error;  // where it is what is seen
  std::string lacks;                  // the layer that is seen and that the other does not have: not measured
  std::string error;                  // why the view could not be used; then it is sRGB
};
using DevelopedPtr = std::shared_ptr<const Developed>;

/// What was measured last that was not quick, and how it was looked at.
struct Measured {
  Development how;
  ViewPicturePtr other;  // as it was matched
  std::string matched;   // see Figures
};

/// What one sees of a frame, as a picture with R, G and B, without a plate. [radiance, or a share for alpha
/// and depth]
Image visible_layers(const Frame& frame, const Development& how);

/// What of that is light in a pixel: alpha and depth are seen as shares. [radiance]
vec3 visible_radiance(const Frame& frame, const Development& how, std::size_t pixel);
/// The layer that is seen and that the picture from a file it is held against does not have; else empty.
std::string lacking_layer(const Development& how);

/// The picture, looked at so; null where it is light and an error is asked for, or the other way round.
/// last: a quick one is measured against the other as that was matched then. Without one that was matched
/// alike it is against the other as it came, and without figures where that has to be matched.
DevelopedPtr develop(const ViewPicturePtr& picture, const Development& how, const Measured* last = nullptr);

class Developer {
 public:
  explicit Developer(std::function<void()> wake);
  ~Developer();
  Developer(const Developer&) = delete;
  Developer& operator=(const Developer&) = delete;

  void ask(ViewPicturePtr picture, const Development& how);
  /// The newest, or null before the first.
  DevelopedPtr developed() const;
  /// Lets go of what was asked for last and of its picture.
  void forget();

 private:
  void run();

  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable news_;
  ViewPicturePtr waiting_;
  Development how_;
  DevelopedPtr developed_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace plinian::window
