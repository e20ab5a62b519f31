// Subtractions.
#include "host/window/panels/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace plinian::window {

namespace {

constexpr float gap = 3.0f;                 // [points] between panes: where they are dragged
constexpr float smallest_picture = 200.0f;  // [points]

}  // namespace

Panes lay_out(const PaneSizes& sizes, vec2 room, float menu_height, float timeline_height,
              float status_height, float scale, bool panels) {
  Panes panes;
  panes.menu = {{0.0f, 0.0f}, {room.x, menu_height}};
  panes.status = {{0.0f, room.y - status_height}, {room.x, status_height}};
  const float top = menu_height, under = room.y - status_height;
  if (!panels) {
    panes.picture = {{0.0f, top}, {room.x, std::max(1.0f, under - top)}};
    return panes;
  }
  const float space = std::round(gap * scale);
  float left = sizes.left * scale, right = sizes.right * scale;
  const float over = left + right + 2 * space + smallest_picture - room.x;
  if (over > 0.0f) {
    const float narrowing = std::max(0.0f, 1.0f - over / (left + right));
    left *= narrowing;
    right *= narrowing;
  }
  left = std::round(left);
  right = std::round(right);
  const float fixed = timeline_height + 2 * space;
  const float bottom = std::round(
      std::clamp(sizes.bottom * scale, 0.0f, std::max(0.0f, under - top - fixed - smallest_picture)));
  const float bottom_top = under - bottom, timeline_top = bottom_top - space - timeline_height;
  const float picture_bottom = timeline_top - space;
  const float middle = std::max(1.0f, room.x - left - right - 2 * space);
  panes.picture = {{left + space, top}, {middle, std::max(1.0f, picture_bottom - top)}};
  panes.timeline = {{left + space, timeline_top}, {middle, timeline_height}};
  panes.bottom = {{left + space, bottom_top}, {middle, bottom}};
  const float column = under - top;
  const float outliner = std::round(std::clamp(sizes.outliner, 0.15f, 0.85f) * (column - space));
  panes.outliner = {{0.0f, top}, {left, outliner}};
  panes.lights = {{0.0f, top + outliner + space}, {left, column - outliner - space}};
  panes.attributes = {{room.x - right, top}, {right, column}};
  return panes;
}

std::string text_of(const PaneSizes& sizes) {
  std::string text = fmt::format("left {}\nright {}\nbottom {}\noutliner {}\nshows_nodes {}\n", sizes.left,
                                 sizes.right, sizes.bottom, sizes.outliner, int(sizes.shows_nodes));
  if (const auto& probe = sizes.probe)
    text += fmt::format("probe_x {}\nprobe_y {}\nprobe_width {}\nprobe_height {}\n", probe->share.x,
                        probe->share.y, probe->size.x, probe->size.y);
  return text;
}

PaneSizes read_pane_sizes(const std::string& text) {
  PaneSizes sizes;
  std::istringstream lines(text);
  std::string name;
  float value = 0.0f;
  while (lines >> name >> value) {
    if (!std::isfinite(value)) continue;
    if (name == "left") sizes.left = std::clamp(value, 120.0f, 900.0f);
    if (name == "right") sizes.right = std::clamp(value, 200.0f, 1200.0f);
    if (name == "bottom") sizes.bottom = std::clamp(value, 40.0f, 900.0f);
    if (name == "shows_nodes") sizes.shows_nodes = value != 0.0f;
    if (name.starts_with("probe_") && !sizes.probe) sizes.probe.emplace();
    if (name == "probe_x") sizes.probe->share.x = std::clamp(value, 0.0f, 1.0f);
    if (name == "probe_y") sizes.probe->share.y = std::clamp(value, 0.0f, 1.0f);
    if (name == "probe_width") sizes.probe->size.x = std::clamp(value, 160.0f, 900.0f);
    if (name == "probe_height") sizes.probe->size.y = std::clamp(value, 80.0f, 900.0f);
    if (name == "outliner") sizes.outliner = std::clamp(value, 0.15f, 0.85f);
  }
  return sizes;
}

}  // namespace plinian::window
