// From the last that is drawn to the first.
#include "host/window/nodes/diagram_hit.h"

namespace plinian::window {

DiagramHit hit(const Diagram& diagram, vec2 point, float reach) {
  for (std::size_t b = diagram.boxes.size(); b-- > 0;) {
    const NodeBox& box = diagram.boxes[b];
    for (std::size_t r = 0; r < box.rows.size(); ++r)
      for (const bool gives : {false, true})
        if ((gives ? box.rows[r].gives : box.rows[r].takes) &&
            glm::distance(plug_place(box, r, gives), point) <= reach)
          return {gives ? DiagramPart::giving_plug : DiagramPart::taking_plug, b, r};
  }
  for (std::size_t b = diagram.boxes.size(); b-- > 0;) {
    const NodeBox& box = diagram.boxes[b];
    const vec2 inside = point - box.place, size = size_of(box);
    if (inside.x < 0.0f || inside.y < 0.0f || inside.x > size.x || inside.y > size.y) continue;
    const bool opener = inside.y < header_height && inside.x > size.x - header_height;
    return {opener && (box.open || box.has_more) ? DiagramPart::opener : DiagramPart::box, b, 0};
  }
  return {};
}

std::vector<std::size_t> boxes_within(const Diagram& diagram, vec2 corner, vec2 opposite) {
  const vec2 begin = glm::min(corner, opposite), end = glm::max(corner, opposite);
  std::vector<std::size_t> found;
  for (std::size_t b = 0; b < diagram.boxes.size(); ++b) {
    const vec2 first = diagram.boxes[b].place, last = first + size_of(diagram.boxes[b]);
    if (first.x <= end.x && last.x >= begin.x && first.y <= end.y && last.y >= begin.y) found.push_back(b);
  }
  return found;
}

}  // namespace plinian::window
