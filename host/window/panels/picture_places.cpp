// Halves, and a magnifying glass over each.
#include "host/window/panels/picture_places.h"

#include <algorithm>
#include <cmath>

namespace plinian::window {

PicturePlaces picture_places(const PaneRect& pane, vec2 size, int pixels, bool side_by_side, float gap,
                             const PictureZoom& zoom, float pixel_ratio) {
  PicturePlaces places;
  places.is_magnified = zoom.is_on();
  places.room = pane;
  const float half = (pane.size.x - gap) * 0.5f;
  if (side_by_side) {
    size *= std::min(1.0f, half / size.x);
    places.room.size.x = half;
  }
  places.whole = {pane.begin + glm::floor((places.room.size - size) * 0.5f), size};
  places.picture = zoom.magnified(places.whole);
  places.pixel_side = places.picture.size.x * pixel_ratio / float(std::max(1, pixels));
  constexpr float square = 3.9f;  // 4, but for rounding; smaller ones come out uneven
  places.shows_squares = places.is_magnified && places.pixel_side >= square;
  if (zoom.is_on()) places.picture.begin = glm::round(places.picture.begin * pixel_ratio) / pixel_ratio;
  const vec2 aside(side_by_side ? std::ceil(half + gap) : 0.0f, 0.0f);
  places.other = {places.picture.begin + aside, places.picture.size};
  places.other_room = {places.room.begin + aside, places.room.size};
  return places;
}

}  // namespace plinian::window
