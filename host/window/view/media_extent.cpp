#include "host/window/view/media_extent.h"

#include <algorithm>

namespace plinian::window {

MediaExtent::Ptr MediaExtent::of(const std::vector<Medium>& media, const Ptr& before) {
  if (before && before->tells_of(media)) return before;
  auto extent = std::make_shared<MediaExtent>();
  extent->media_ = media;
  extent->all_ = scene_bounds(media);
  for (const Medium& medium : media) extent->each_.push_back(scene_bounds({medium}));
  return extent;
}

const SceneBounds* MediaExtent::medium(std::size_t i) const {
  const Medium& medium = media_[i];
  const bool is_empty = medium.shape == MediumShape::voxels && (!medium.volume || medium.volume->empty());
  return is_empty ? nullptr : &each_[i];
}

bool MediaExtent::tells_of(const std::vector<Medium>& media) const {
  return std::equal(
      media.begin(), media.end(), media_.begin(), media_.end(), [](const Medium& a, const Medium& b) {
        return a.shape == b.shape && a.volume == b.volume && a.world_from_medium == b.world_from_medium;
      });
}

}  // namespace plinian::window
