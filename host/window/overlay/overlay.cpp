// Ground, axes, scale, bounds, icons and gate.
#include "host/window/overlay/overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "host/graph/graph_error.h"
#include "host/scene/placed.h"
#include "host/window/drawing/drawings.h"
#include "host/window/overlay/ground_grid.h"
#include "host/window/overlay/icons.h"
#include "host/window/overlay/pick.h"
#include "host/window/panels/overlay_text.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

constexpr unsigned quiet = 0x00b8b4b0;  // a grey that is read on black as on ash; without its alpha
constexpr unsigned red = 0xe05a5ad2, green = 0xe06ebe78, blue = 0xe0d2965a;

unsigned with_alpha(unsigned colour, float alpha) {
  return (colour & 0x00ffffffu) | (unsigned(std::lround(255.0f * alpha)) << 24);
}

void draw_line(const Projection& projection, const dvec3& from, const dvec3& to, unsigned colour,
               float width) {
  if (const auto line = projection.line(from, to))
    ImGui::GetWindowDrawList()->AddLine(to_im(line->first), to_im(line->second), colour, scaled(width));
}

// The parts of a line that no medium hides: where alpha has passed 0.5 in front of them they are left out.
void draw_line_behind(const Frame& frame, const Projection& projection, const dvec3& from, const dvec3& to,
                      unsigned colour, float width) {
  const auto whole = projection.line(from, to);
  if (!whole) return;
  const int pieces = std::clamp(int(glm::length(whole->second - whole->first) / scaled(6)), 1, 128);
  for (int i = 0; i < pieces; ++i) {
    const dvec3 a = glm::mix(from, to, double(i) / pieces), b = glm::mix(from, to, double(i + 1) / pieces);
    const dvec3 middle = 0.5 * (a + b);
    if (const auto seen = projection.point(middle)) {
      const vec2 share = (seen->at - projection.begin()) / projection.size();
      const ivec2 pixel(share * vec2(frame.width, frame.height));
      if (share.x >= 0.0f && share.y >= 0.0f && pixel.x < frame.width && pixel.y < frame.height &&
          frame.depth[std::size_t(pixel.y) * std::size_t(frame.width) + std::size_t(pixel.x)] <
              glm::length(middle - projection.eye()))
        continue;
    }
    draw_line(projection, a, b, colour, width);
  }
}

void draw_grid(const Frame& frame, const Projection& projection, const SceneBounds& bounds) {
  const double away = std::max(glm::length(bounds.centre() - projection.eye()), 1e-3);
  for (const GridLine& line : ground_grid(bounds.centre(), round_length(away * 0.12)))
    draw_line_behind(frame, projection, line.from, line.to,
                     with_alpha(quiet, (line.is_axis ? 0.42f : 0.2f) * line.strength), 1.0f);
}

void draw_axes(const Camera& camera, vec2 middle) {
  const dmat3 camera_from_world = glm::transpose(dmat3(camera.world_from_camera));
  struct Axis {
    dvec3 seen;
    unsigned colour;
    const char* name;
  } axes[] = {{camera_from_world[0], red, "x"},
              {camera_from_world[1], green, "y"},
              {camera_from_world[2], blue, "z"}};
  std::sort(std::begin(axes), std::end(axes),
            [](const Axis& a, const Axis& b) { return a.seen.z < b.seen.z; });
  for (const Axis& axis : axes) {
    const vec2 way(float(axis.seen.x), float(-axis.seen.y));
    ImGui::GetWindowDrawList()->AddLine(to_im(middle), to_im(middle + way * scaled(22)), axis.colour,
                                        scaled(1.5f));
    const ImVec2 size = ImGui::CalcTextSize(axis.name);
    draw_text(middle + way * scaled(30) - vec2(size.x, size.y) * 0.5f, axis.colour, axis.name);
  }
}

// As long as it is at the depth of the media's middle.
void draw_scale_bar(const Projection& projection, const SceneBounds& bounds, vec2 begin) {
  const auto middle = projection.point(bounds.centre());
  if (!middle) return;
  const double point = projection.length_of_point(middle->depth), length = round_length(point * scaled(130));
  const float width = float(length / point);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const unsigned colour = with_alpha(quiet, 0.85f);
  for (const auto& [shift, c] : {std::pair(1.0f, 0xa0000000u), std::pair(0.0f, colour)}) {
    const vec2 a = begin + vec2(shift), b = a + vec2(width, 0.0f), tick(0.0f, scaled(4));
    list->AddLine(to_im(a), to_im(b), c, scaled(1));
    list->AddLine(to_im(a - tick), to_im(a), c, scaled(1));
    list->AddLine(to_im(b - tick), to_im(b), c, scaled(1));
  }
  draw_text(begin + vec2(scaled(6), -ImGui::GetTextLineHeight() - scaled(4)), colour,
            fmt::format("{:g} m", length));
}

void draw_gate(const SceneSnapshot& scene, vec2 begin, vec2 size) {
  ImGui::GetWindowDrawList()->AddRect(to_im(begin), to_im(begin + size), with_alpha(quiet, 0.5f));
  const std::string text = fmt::format("{} x {}", scene.width, scene.height);
  const ImVec2 room = ImGui::CalcTextSize(text.c_str());
  // Over the line that reads out the pixel.
  draw_text(begin + vec2(size.x - room.x - scaled(10), size.y - 2.0f * room.y - scaled(14)),
            with_alpha(quiet, 0.8f), text);
}

// Whether the node, or one that it is under, is selected.
bool is_selected(Studio& studio, const std::string& name) {
  const graph::Graph& graph = studio.session().graph();
  const auto& selection = graph.selection();
  for (const graph::Node* node = graph.find(name); node;
       node = node->parent ? graph.find(node->parent) : nullptr)
    if (std::find(selection.begin(), selection.end(), node->id) != selection.end()) return true;
  return false;
}

}  // namespace

std::string select_command(const std::string& node, bool add, bool toggle, bool is_selected,
                           bool anything_selected) {
  if (node.empty()) return anything_selected && !add && !toggle ? "select -clear" : "";
  if (toggle) return "select " + node + (is_selected ? " -remove" : " -add");
  return "select " + node + (add ? " -add" : "");
}

void Overlay::draw_icon(Studio& studio, const std::vector<WorldLine>& lines, const dvec3& at,
                        const std::string& node, const Projection& projection) {
  const auto middle = projection.point(at);
  if (!middle) return;
  icons_.push_back({node, middle->at});
  studio.trace.item("icon " + node, middle->at - vec2(scaled(6)), vec2(scaled(12)));
  const unsigned colour = is_selected(studio, node) ? colour::accent : with_alpha(quiet, 0.85f);
  for (const WorldLine& line : lines) draw_line(projection, line.from, line.to, 0x60000000u, 2.6f);
  for (const WorldLine& line : lines) draw_line(projection, line.from, line.to, colour, 1.2f);
}

void Overlay::show_bounds(Studio& studio, const ViewPicture& picture, const Projection& projection) {
  const std::vector<Medium>& media = picture.scene.media;
  for (std::size_t m = 0; m < media.size(); ++m) {
    const SceneBounds* box = picture.extent->medium(m);
    if (!box || !is_selected(studio, media[m].name)) continue;
    const auto corner = [&](int i) {
      return dvec3(i & 1 ? box->maximum.x : box->minimum.x, i & 2 ? box->maximum.y : box->minimum.y,
                   i & 4 ? box->maximum.z : box->minimum.z);
    };
    for (int i = 0; i < 8; ++i)
      for (const int bit : {1, 2, 4})
        if (!(i & bit))
          draw_line_behind(picture.frame, projection, corner(i), corner(i | bit),
                           with_alpha(colour::accent, 0.6f), 1.0f);
  }
}

// A directional light has no place: its sun stands where it shines from, beside the media.
void Overlay::show_lights(Studio& studio, const ViewPicture& picture, const Projection& projection) {
  const SceneSnapshot& scene = picture.scene;
  const SceneBounds& bounds = picture.extent->all();
  const dmat3 facing(scene.camera.world_from_camera);
  for (const Light& light : scene.lights) {
    if (!studio.session().graph().find(light.name)) continue;
    const dvec3 at = light.type == LightType::directional
                         ? bounds.centre() + dvec3(light.toward) * (bounds.radius() * 1.1)
                         : dvec3(light.position);
    const auto seen = projection.point(at);
    if (!seen) continue;
    const double size = projection.length_of_point(seen->depth) * scaled(13);
    draw_icon(studio, light_icon(light, at, facing, size), at, light.name, projection);
  }
}

void Overlay::show_cameras(Studio& studio, const Projection& projection) {
  const scene::Placed placed(studio.session().graph(), studio.session().evaluator());
  for (const graph::Node* node : studio.session().graph().nodes()) {
    if (node->type->name() != "camera") continue;
    try {
      Camera camera;
      camera.world_from_camera = placed.world_matrix(node->id);
      for (int i = 0; i < 3; ++i)
        camera.world_from_camera[i] /= glm::length(dvec3(camera.world_from_camera[i]));
      camera.focal_length = float(placed.number(placed.plug(*node, "focal_length")));
      const dvec3 at(camera.world_from_camera[3]);
      const auto seen = projection.point(at);
      // The one that is looked through stands in the eye.
      if (!seen || glm::length(at - projection.eye()) < 1e-6 * (1.0 + glm::length(at))) continue;
      const double size = projection.length_of_point(seen->depth) * scaled(16);
      draw_icon(studio, camera_icon(camera, size), at, node->name, projection);
    } catch (const graph::GraphError&) {
      // What has no place has no icon; the outliner says why.
    }
  }
}

void Overlay::show(Studio& studio, const ViewPicture& picture, const PaneRect& place, const PaneRect& seen,
                   float bottom) {
  icons_.clear();
  const SceneSnapshot& scene = picture.scene;
  const Projection projection(scene.camera, scene.width, scene.height, place.begin, place.size);
  const OverlayChoice& choice = studio.overlay;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(to_im(seen.begin), to_im(seen.begin + seen.size), true);
  const SceneBounds& bounds = picture.extent->all();
  if (choice.grid) draw_grid(picture.frame, projection, bounds);
  if (choice.bounds) show_bounds(studio, picture, projection);
  if (choice.icons) {
    show_lights(studio, picture, projection);
    show_cameras(studio, projection);
  }
  const vec2 corner(seen.begin.x + scaled(44), std::min(seen.begin.y + seen.size.y, bottom) - scaled(70));
  if (choice.axes) draw_axes(scene.camera, corner);
  if (choice.scale_bar) draw_scale_bar(projection, bounds, corner + vec2(scaled(52), scaled(22)));
  if (choice.gate && !studio.viewpoint.look.free && studio.feed.snapshot())
    draw_gate(studio.feed.snapshot()->snapshot, place.begin, place.size);
  list->PopClipRect();
}

void Overlay::select(Studio& studio, Drawings& drawings, const ViewPicture& picture, const PaneRect& place,
                     bool free) {
  const ImGuiIO& io = ImGui::GetIO();
  const vec2 mouse(io.MousePos.x, io.MousePos.y);
  if (free && ImGui::IsMouseClicked(0)) {
    pressed_ = !io.KeyAlt && !studio.light_key_held && !studio.inspector.on;
    pressed_at_ = mouse;
  }
  if (!pressed_ || !ImGui::IsMouseReleased(0)) return;
  pressed_ = false;
  if (glm::length(mouse - pressed_at_) > scaled(4)) return;
  std::string node;
  float nearest = scaled(14);
  for (const Icon& icon : icons_)
    if (const float away = glm::length(icon.at - mouse); away < nearest) {
      nearest = away;
      node = icon.node;
    }
  // Icons lie over everything, but are not as exact as what is drawn in the scene.
  if (const auto drawn = drawings.hit((mouse - place.begin) / place.size); drawn && nearest > scaled(6))
    node = drawn->node;
  const SceneSnapshot& scene = picture.scene;
  if (node.empty()) {
    const Projection projection(scene.camera, scene.width, scene.height, place.begin, place.size);
    if (const auto medium = medium_seen(scene, picture.frame, (mouse - place.begin) / place.size,
                                        projection.eye(), projection.direction(mouse)))
      node = scene.media[*medium].name;
  }
  const graph::Graph& graph = studio.session().graph();
  if (!node.empty() && !graph.find(node)) return;
  const auto& selection = graph.selection();
  const bool selected =
      !node.empty() && std::find(selection.begin(), selection.end(), graph.find(node)->id) != selection.end();
  const std::string line = select_command(node, io.KeyShift, io.KeyCtrl, selected, !selection.empty());
  if (!line.empty()) studio.run(line);
}

}  // namespace plinian::window
