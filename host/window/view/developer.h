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
#include "host/window/view/view_renderer.h"

namespace plinian::window {

/// How a picture is looked at. No part of the scene.
struct Development {
  ViewSettings view;
  std::set<std::string> solo;  // lights that are seen alone; empty: all, with everything else
  bool solo_ambient = false;   // ... and the sky's
  ViewPicturePtr against;      // measured against this one, where it has the same size
  bool difference = false;     // ... and the signed difference is what is seen
  std::string layer;           // beauty (or empty), alpha, depth, emission, ambient
};

struct Developed {
  int width = 0, height = 0;        // [pixels]
  std::vector<std::uint8_t> bytes;  // r g b, top row first
  ViewPicturePtr picture;           // that it was made of
  std::optional<double> psnr;       // [dB] of linear radiance against the other picture, see metrics.h
  std::optional<double> ssim;       // [-] likewise
  std::string error;                // why the view could not be used; then it is sRGB
};
using DevelopedPtr = std::shared_ptr<const Developed>;

/// What one sees of a frame, as a picture with R, G and B. [radiance, or a share for alpha and depth]
Image visible_layers(const Frame& frame, const Development& how);

class Developer {
 public:
  explicit Developer(std::function<void()> wake);
  ~Developer();
  Developer(const Developer&) = delete;
  Developer& operator=(const Developer&) = delete;

  void ask(ViewPicturePtr picture, const Development& how);
  /// The newest, or null before the first.
  DevelopedPtr developed() const;

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
