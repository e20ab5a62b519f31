// Chooses the pixel and plots what is found there.
#include "host/window/panels/probe_panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/window/panels/curve_plot.h"
#include "host/window/panels/overlay_text.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

constexpr unsigned density_colour = 0xff8ac28a, exact_colour = 0xff4ab0e8, map_colour = 0xffefb05f,
                   point_colour = 0xffe8e8e8;

double mean(const dvec3& v) {
  return (v.x + v.y + v.z) / 3.0;
}

void key(unsigned colour, const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
}

void draw_mark(vec2 at, float gap, const PaneRect& room) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(to_im(room.begin), to_im(room.begin + room.size), true);
  for (const auto& [colour, width] : {std::pair(0xa0000000u, 3.0f), std::pair(point_colour, 1.0f)})
    for (const vec2 axis : {vec2(1, 0), vec2(0, 1)})
      for (const float side : {-1.0f, 1.0f})
        list->AddLine(to_im(at + axis * (side * gap)), to_im(at + axis * (side * (gap + scaled(7)))), colour,
                      scaled(width));
  list->PopClipRect();
}

}  // namespace

void ProbePanel::choose(Studio& studio, const PicturePlaces& places, const PaneRect& shown, bool free) {
  Inspector& inspector = studio.inspector;
  const ImGuiIO& io = ImGui::GetIO();
  const vec2 mouse(io.MousePos.x, io.MousePos.y);
  if (!ImGui::IsMouseDown(0) || !inspector.on) held_ = false;
  if (inspector.on && free && ImGui::IsMouseClicked(0) && !io.KeyAlt && !studio.light_key_held) {
    held_ = true;
    way_ = places.way_to_picture(mouse);
  }
  if (held_) {
    const vec2 share = (mouse + way_ - shown.begin) / shown.size;
    inspector.place = glm::clamp(share, vec2(0.0f), vec2(1.0f));
    inspector.t.reset();
  }
  inspector.update(studio.renderer.picture());
  if (!inspector.on || !inspector.place) return;
  const ViewPicturePtr picture = studio.picture();
  if (!picture) return;
  // Around the pixel, however large that is.
  const vec2 pixels(picture->scene.width, picture->scene.height);
  const vec2 middle = (glm::min(glm::floor(*inspector.place * pixels), pixels - 1.0f) + 0.5f) / pixels;
  const float gap = std::max(scaled(4), 0.5f * shown.size.x / pixels.x + scaled(3));
  draw_mark(shown.begin + middle * shown.size, gap, places.room);
  if (places.other.begin != places.picture.begin)
    draw_mark(shown.begin + places.other.begin - places.picture.begin + middle * shown.size, gap,
              places.other_room);
}

void ProbePanel::show_view_ray(Studio& studio, const Inspection& inspection, vec2 size) {
  const auto& samples = inspection.view.samples;
  Plot plot;
  plot.x_low = samples.front().t;
  plot.x_high = std::max(samples.back().t, plot.x_low + 1e-9);
  double densest = 1e-30;
  Curve curve{{}, density_colour};
  for (const ViewRayProbe::Sample& sample : samples) {
    densest = std::max(densest, mean(sample.sigma_t));
    curve.points.emplace_back(sample.t, mean(sample.sigma_t));
  }
  plot.y_high = 1.05 * densest;
  Curve transmittance{{}, colour::faint_text};
  for (const ViewRayProbe::Sample& sample : samples)
    transmittance.points.emplace_back(sample.t, plot.y_high * mean(sample.transmittance));
  plot.curves = {std::move(transmittance), std::move(curve)};
  plot.marks = {{inspection.t, point_colour, fmt::format("{:.4g} m", inspection.t)}};
  if (const auto chosen = show_plot("##view ray", plot, size)) studio.inspector.t = *chosen;
  help(
      "Extinction along the pixel's ray [1/m] by distance from the camera [m]; grey: what gets through to "
      "the "
      "camera. Drag to probe the light elsewhere on the ray.");
}

void ProbePanel::show_light_ray(const Inspection& inspection, vec2 size) {
  const LightRayProbe& light = *inspection.light;
  Plot plot;
  plot.x_low = light.samples.front().k;
  plot.x_high = std::max(light.samples.back().k, plot.x_low + 1e-9);
  Curve exact{{}, exact_colour}, map{{}, map_colour};
  for (const LightRayProbe::Sample& sample : light.samples) {
    exact.points.emplace_back(sample.k, mean(sample.exact));
    map.points.emplace_back(sample.k, mean(sample.map));
  }
  plot.curves = {std::move(exact), std::move(map)};
  for (const LightRayProbe::Bounds& bounds : light.bounds) {
    if (bounds.missed) continue;
    plot.marks.push_back({bounds.k_min, colour::faint_text, "kmin"});
    plot.marks.push_back({bounds.k_max, colour::faint_text, bounds.dense ? "kmax" : "kmax, thin"});
  }
  plot.marks.push_back({light.k, point_colour, "here"});
  const double threshold = inspection.question.picture->scene.quality.map.threshold;
  plot.thresholds = {threshold, 1.0 - threshold};
  show_plot("##light ray", plot, size);
  help(
      "Transmittance from the light by distance along its ray [m]: as the reference has it, and as it is "
      "rebuilt from the map's coefficients. Dotted: the threshold at which light counts as dead.");
}

void ProbePanel::show(Studio& studio, const PaneRect& pane) {
  Inspector& inspector = studio.inspector;
  if (!inspector.on) return;
  const InspectionPtr found = inspector.place ? inspector.inspection() : nullptr;
  const float line = ImGui::GetFrameHeight();
  const vec2 margin(scaled(10), scaled(34));
  const vec2 size =
      glm::min(vec2(scaled(340), found ? scaled(312) : line + scaled(14)), pane.size - 2.0f * margin);
  if (size.x < scaled(160) || size.y < line) return;
  // On the side where the pixel is not.
  const bool at_right = found && inspector.place->x < 0.5f;
  const PaneRect card{{at_right ? pane.begin.x + pane.size.x - size.x - margin.x : pane.begin.x + margin.x,
                       pane.begin.y + pane.size.y - margin.y - size.y},
                      size};
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.1f, 0.1f, 0.105f, 0.93f));
  ImGui::SetNextWindowPos(to_im(card.begin));
  ImGui::SetNextWindowSize(to_im(card.size));
  ImGui::Begin("##probe", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleColor();
  studio.trace.item("probe", card.begin, card.size);
  if (!found) {
    ImGui::TextDisabled("Click in the picture to probe a pixel.");
  } else if (!found->error.empty() || found->view.samples.empty()) {
    ImGui::TextWrapped("%s",
                       found->error.empty() ? "The pixel's ray meets no medium." : found->error.c_str());
  } else {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("pixel %d %d", found->question.pixel.x, found->question.pixel.y);
    if (found->light) {
      ImGui::SameLine(scaled(130));
      ImGui::SetNextItemWidth(scaled(140));
      if (ImGui::BeginCombo("##light", found->light->light.c_str())) {
        for (const std::string& name : found->lights)
          if (ImGui::Selectable(name.c_str(), name == found->light->light)) inspector.light = name;
        ImGui::EndCombo();
      }
    }
    const float room = ImGui::GetContentRegionAvail().x, text = ImGui::GetTextLineHeightWithSpacing();
    const float plots = size.y - line - (found->light ? 2.0f : 1.0f) * text - scaled(34);
    key(density_colour, "extinction [1/m]");
    ImGui::SameLine(scaled(130));
    ImGui::TextDisabled("what gets through to the camera");
    show_view_ray(studio, *found, {room, (found->light ? 0.42f : 1.0f) * plots});
    studio.trace.item("probe ray", vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                      vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
    if (found->light) {
      const double exact = mean(found->light->exact), map = mean(found->light->map);
      key(exact_colour, fmt::format("exact {:.4f}", exact).c_str());
      ImGui::SameLine(scaled(130));
      key(map_colour, fmt::format("map {:.4f}", map).c_str());
      ImGui::SameLine(scaled(230));
      ImGui::TextDisabled("%+.4f", map - exact);
      show_light_ray(*found, {room, 0.58f * plots});
      if (found != told_)
        studio.trace.note(fmt::format("probe {} {} at {:.6g} {} exact {:.5f} map {:.5f}",
                                      found->question.pixel.x, found->question.pixel.y, found->t,
                                      found->light->light, exact, map));
      told_ = found;
    }
  }
  ImGui::End();
}

}  // namespace plinian::window
