// A list in the order of use: there are some hundred at most.
#include "host/window/view/played_frames.h"

#include <algorithm>
#include <memory>

#include "host/window/view/same_picture.h"

namespace plinian::window {

namespace {

// The volumes that it shows stay, too: it is told by them.
std::size_t bytes_of(const ViewPicture& picture) {
  const Frame& frame = picture.frame;
  std::size_t volumes = 0;
  for (const Medium& medium : picture.scene.media)
    if (medium.volume) volumes += medium.volume->bytes();
  return volumes + (frame.beauty.size() + frame.transmittance.size()) * sizeof(vec3) +
         frame.depth.size() * sizeof(float);
}

bool is_better(const ViewPicture& a, const ViewPicture& b) {
  if (a.frame.width != b.frame.width) return a.frame.width > b.frame.width;
  return a.passes > b.passes;
}

ViewPicturePtr without_layers(const ViewPicture& picture) {
  auto kept = std::make_shared<ViewPicture>();
  kept->frame.width = picture.frame.width;
  kept->frame.height = picture.frame.height;
  kept->frame.beauty = picture.frame.beauty;
  kept->frame.transmittance = picture.frame.transmittance;
  kept->frame.depth = picture.frame.depth;
  kept->scene = picture.scene;
  kept->number = picture.number;
  kept->time = picture.time;
  kept->quick = picture.quick;
  kept->at_rest = picture.at_rest;
  kept->passes = picture.passes;
  kept->stats = picture.stats;
  kept->is_played = true;
  return kept;
}

}  // namespace

bool operator==(const Take& a, const Take& b) {
  return a.generation == b.generation && a.quality == b.quality && a.original_maps == b.original_maps &&
         a.size == b.size && a.free.has_value() == b.free.has_value() &&
         (!a.free || same_camera(*a.free, *b.free));
}

bool PlayedFrames::begin(const Take& take) {
  if (take == take_) return false;
  take_ = take;
  played_.clear();
  bytes_ = 0;
  return true;
}

void PlayedFrames::keep(const ViewPicture& picture) {
  const auto same = std::find_if(played_.begin(), played_.end(), [&](const Played& played) {
    return same_picture(played.picture->scene, picture.scene);
  });
  if (same != played_.end()) {
    if (!is_better(picture, *same->picture)) return;
    bytes_ -= same->bytes;
    played_.erase(same);
  }
  played_.push_front({without_layers(picture), bytes_of(picture)});
  bytes_ += played_.front().bytes;
  while (bytes_ > budget_ && played_.size() > 1) {
    bytes_ -= played_.back().bytes;
    played_.pop_back();
  }
}

ViewPicturePtr PlayedFrames::find(const SceneSnapshot& scene) {
  const auto found = std::find_if(played_.begin(), played_.end(), [&](const Played& played) {
    return same_picture(played.picture->scene, scene);
  });
  if (found == played_.end()) return nullptr;
  played_.splice(played_.begin(), played_, found);
  return found->picture;
}

std::vector<double> PlayedFrames::frames() const {
  std::vector<double> frames;
  for (const Played& played : played_)
    if (!played.picture->quick) frames.push_back(played.picture->time);
  return frames;
}

}  // namespace plinian::window
