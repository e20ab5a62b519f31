// Chooses the pixel and plots what is found there.
#include "host/window/panels/probe_panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/window/panels/bottom_tabs.h"
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
    inspector.is_behind = false;
    way_ = places.way_to_picture(mouse);
  }
  if (held_) {
    const vec2 share = (mouse + way_ - shown.begin) / shown.size;
    inspector.place = glm::clamp(share, vec2(0.0f), vec2(1.0f));
    inspector.t.reset();
  }
  inspector.update(studio.renderer.picture());
  shown_ = shown;
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
  const double threshold = inspection.threshold;
  plot.thresholds = {threshold, 1.0 - threshold};
  show_plot("##light ray", plot, size);
  help(
      "Transmittance from the light by distance along its ray [m]: as the reference has it, and as it is "
      "rebuilt from the map's coefficients. Dotted: the threshold at which light counts as dead.");
}

// left: [points] where it begins in the window.
void ProbePanel::show_header(Studio& studio, const Inspection& found, float left) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("pixel %d %d", found.pixel.x, found.pixel.y);
  const float whole = ImGui::GetWindowContentRegionMax().x, mark = scaled(16);
  if (studio.inspector.spot) {
    ImGui::SameLine(whole - mark);
    if (show_changed_dot(mark, "Dragged; click to have the card lie where it hides least.")) {
      studio.inspector.spot.reset();
      index_.reset();
    }
    note_item(studio.trace, "probe card reset");
  }
  if (!found.light) return;
  const float light = left + scaled(122);
  ImGui::SameLine(light);
  ImGui::SetNextItemWidth(std::max(scaled(40), std::min(scaled(140), whole - light - mark)));
  if (ImGui::BeginCombo("##light", found.light->light.c_str())) {
    for (const std::string& name : found.lights)
      if (ImGui::Selectable(name.c_str(), name == found.light->light)) studio.inspector.light = name;
    ImGui::EndCombo();
  }
}

void ProbePanel::show_curves(Studio& studio, const Inspection& found) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float text = ImGui::GetTextLineHeightWithSpacing(), gap = scaled(10);
  const bool both = found.light.has_value(), aside = card_.wide && both;
  const float width = aside ? (room.x - gap) * 0.5f : room.x;
  const float plots = room.y - (both && !aside ? 2.0f : 1.0f) * text - scaled(aside ? 0 : 4);
  ImGui::BeginGroup();
  key(density_colour, "extinction [1/m]");
  if (width > scaled(300)) {
    ImGui::SameLine(0.0f, gap);
    ImGui::TextDisabled("what gets through");
  }
  show_view_ray(studio, found, {width, (both && !aside ? 0.42f : 1.0f) * plots});
  note_item(studio.trace, "probe ray");
  ImGui::EndGroup();
  if (!both) return;
  if (aside) ImGui::SameLine(0.0f, gap);
  ImGui::BeginGroup();
  const double exact = mean(found.light->exact), map = mean(found.light->map);
  key(exact_colour, fmt::format("exact {:.4f}", exact).c_str());
  ImGui::SameLine(0.0f, gap);
  key(map_colour, fmt::format("map {:.4f}", map).c_str());
  if (width > scaled(220)) {
    ImGui::SameLine(0.0f, gap);
    ImGui::TextDisabled("%+.4f", map - exact);
  }
  show_light_ray(found, {width, (aside ? 1.0f : 0.58f) * plots});
  ImGui::EndGroup();
}

// Where it hides least, unless it was dragged somewhere. Looked for anew with another pixel or pane alone, so
// that it does not jump while a picture moves.
void ProbePanel::settle_card(const Studio& studio, const PaneRect& room, const PaneRect& taken,
                             const Frame* frame) {
  const vec2 pixel = shown_.begin + studio.inspector.place.value_or(vec2(0.0f)) * shown_.size;
  const std::vector<ProbeCard> cards = probe_cards(room, scaled(1));
  const Asked asked{studio.inspector.place, room.begin, room.size, taken.begin, shown_.begin, shown_.size};
  const float reach = scaled(26);  // of the mark, and a little of what is around it
  if (index_ && *index_ < cards.size() && (asked == asked_ || held_) &&
      leaves_free(cards[*index_].place, pixel, reach)) {
    card_ = cards[*index_];
    return;
  }
  asked_ = asked;
  const auto smoke = [&](vec2 at) {
    constexpr float as_dear = 5.0f;  // as smoke, where another panel is
    if (holds(taken, at)) return as_dear;
    const vec2 share = (at - shown_.begin) / shown_.size;
    if (!frame || share.x < 0.0f || share.y < 0.0f || share.x >= 1.0f || share.y >= 1.0f) return 0.0f;
    const ivec2 size(frame->width, frame->height), p = glm::min(ivec2(share * vec2(size)), size - 1);
    const vec3 t = frame->transmittance[std::size_t(p.y) * std::size_t(size.x) + std::size_t(p.x)];
    return 1.0f - (t.x + t.y + t.z) / 3.0f;
  };
  index_ = least_hiding(cards, pixel, reach, smoke, index_ && *index_ < cards.size() ? index_ : std::nullopt);
  card_ = cards[*index_];
}

// By what of it is nothing else. Kept in shares of the window's room, so that it stays at an edge.
void ProbePanel::drag_card(Studio& studio) {
  std::optional<ProbeSpot>& spot = studio.inspector.spot;
  const ImGuiIO& io = ImGui::GetIO();
  const vec2 mouse(io.MousePos.x, io.MousePos.y);
  const bool free = ImGui::IsWindowHovered() && !ImGui::IsAnyItemHovered();
  const ImVec2 begin = ImGui::GetWindowPos();
  if (free && ImGui::IsMouseClicked(0)) grabbed_ = mouse - vec2(begin.x, begin.y);
  if (!ImGui::IsMouseDown(0)) grabbed_.reset();
  if (free || grabbed_) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  if (!grabbed_ || (!spot && io.MouseDelta.x == 0.0f && io.MouseDelta.y == 0.0f)) return;
  const ImVec2 window = ImGui::GetMainViewport()->Size;
  const vec2 room = glm::max(vec2(window.x, window.y) - card_.place.size, vec2(1.0f));
  spot = {glm::clamp((mouse - *grabbed_) / room, vec2(0.0f), vec2(1.0f)), card_.place.size / scaled(1)};
}

// From where the cursor is. header: [points] where that is in the window.
void ProbePanel::show_found(Studio& studio, float header) {
  const Inspector& inspector = studio.inspector;
  const InspectionPtr found = inspector.place ? inspector.inspection() : nullptr;
  const bool has_curves = found && found->error.empty() && !found->view.samples.empty();
  ImGui::AlignTextToFramePadding();
  if (!found) {
    ImGui::TextDisabled("Click in the picture to probe a pixel.");
  } else if (!has_curves) {
    ImGui::TextWrapped("%s",
                       found->error.empty() ? "The pixel's ray meets no medium." : found->error.c_str());
  } else {
    show_header(studio, *found, header);
    show_curves(studio, *found);
    if (found->light && found != told_.lock())
      studio.trace.note(fmt::format("probe {} {} at {:.6g} {} exact {:.5f} map {:.5f}", found->pixel.x,
                                    found->pixel.y, found->t, found->light->light, mean(found->light->exact),
                                    mean(found->light->map)));
    told_ = found;
  }
}

void ProbePanel::show_beneath(Studio& studio, const PaneRect& pane) {
  begin_pane("##probe beneath", pane, false);
  show_bottom_tabs(studio);
  card_ = {pane, pane.size.x > 1.5f * pane.size.y};
  studio.trace.item("probe", pane.begin, pane.size);
  show_found(studio, ImGui::GetCursorPosX());
  end_pane();
}

void ProbePanel::show(Studio& studio, const PaneRect& room, const PaneRect& taken, const Frame* frame) {
  Inspector& inspector = studio.inspector;
  if (!inspector.on || inspector.is_docked) return;
  const InspectionPtr found = inspector.place ? inspector.inspection() : nullptr;
  const bool has_curves = found && found->error.empty() && !found->view.samples.empty();
  if (room.size.x < scaled(160) || room.size.y < scaled(80)) return;
  settle_card(studio, room, taken, frame);
  if (const auto& spot = inspector.spot) {
    const ImVec2 window = ImGui::GetMainViewport()->Size;
    card_.place.size = glm::min(spot->size * scaled(1), vec2(window.x, window.y));
    card_.wide = card_.place.size.x > 1.5f * card_.place.size.y;
    card_.place.begin = spot->share * (vec2(window.x, window.y) - card_.place.size);
  }
  PaneRect card = card_.place;
  if (!has_curves) {  // a line of text
    card.size.y = std::min(card.size.y, ImGui::GetFrameHeight() + scaled(14));
    if (!inspector.spot && card_.place.begin.y > room.begin.y)
      card.begin.y += card_.place.size.y - card.size.y;
  }
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.1f, 0.1f, 0.105f, 0.93f));
  ImGui::SetNextWindowPos(to_im(card.begin));
  ImGui::SetNextWindowSize(to_im(card.size));
  ImGui::Begin("##probe", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleColor();
  studio.trace.item("probe", card.begin, card.size);
  show_found(studio, ImGui::GetCursorPosX());
  drag_card(studio);
  ImGui::End();
}

}  // namespace plinian::window
