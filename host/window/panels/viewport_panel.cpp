// Takes the picture, shows it, and lets others write over it.
#include "host/window/panels/viewport_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "host/window/panels/fitted.h"
#include "host/window/panels/overlay_text.h"
#include "host/window/panels/viewport_notes.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

// What is measured against a picture of the gate's size has that size, however large it is shown.
std::optional<ivec2> measured_gate(const Studio& studio) {
  if (studio.viewpoint.look.free || !studio.feed.snapshot()) return std::nullopt;
  const SceneSnapshot& scene = studio.feed.snapshot()->snapshot;
  const auto wanted = studio.comparison.wanted_size();
  return wanted == ivec2(scene.width, scene.height) ? wanted : std::nullopt;
}

}  // namespace

// Through a camera of the scene one sees what it takes in, no more; one's own fills the pane.
void ViewportPanel::settle_size(Studio& studio, const PaneRect& pane, double pixel_ratio) {
  vec2 size = pane.size;
  if (!studio.viewpoint.look.free && studio.feed.snapshot()) {
    const SceneSnapshot& scene = studio.feed.snapshot()->snapshot;
    const float wanted = float(scene.width) / float(std::max(1, scene.height));
    if (size.x > size.y * wanted)
      size.x = size.y * wanted;
    else
      size.y = size.x / wanted;
  }
  ivec2 pixels(std::max(16, int(std::lround(size.x * pixel_ratio))),
               std::max(16, int(std::lround(size.y * pixel_ratio))));
  size = vec2(pixels) / float(pixel_ratio);
  picture_ = {pane.begin + glm::floor((pane.size - size) * 0.5f), size};
  if (const auto gate = measured_gate(studio)) pixels = *gate;
  studio.picture_size = pixels;
  if (studio.comparison.mode() != CompareMode::side_by_side) return;
  const float gap = scaled(4), half = (pane.size.x - gap) * 0.5f;
  size *= std::min(1.0f, half / size.x);
  const float top = std::floor(pane.begin.y + (pane.size.y - size.y) * 0.5f);
  picture_ = {{std::floor(pane.begin.x + (half - size.x) * 0.5f), top}, size};
  other_ = {picture_.begin + vec2(std::ceil(half + gap), 0.0f), size};
}

void ViewportPanel::take_picture(Studio& studio) {
  const ViewPicturePtr picture = studio.picture();
  const std::string how = words_of(studio.development);
  if (picture && (picture != asked_picture_ || how != asked_development_)) {
    studio.developer.ask(picture, studio.development);
    asked_picture_ = picture;
    asked_development_ = how;
  }
  const DevelopedPtr before = texture_.shown();
  texture_.show(studio.developer.developed());
  const DevelopedPtr& shown = texture_.shown();
  comparison_.take_picture(studio, shown);
  if (!shown || shown == before || !studio.trace.is_on()) return;
  const ViewPicture& p = *shown->picture;
  studio.trace.note(fmt::format("picture {} {}x{} passes {} {} {:.0f} ms maps {:.0f} view {:.0f}{}", p.number,
                                shown->width, shown->height, p.passes,
                                p.is_played ? "played"
                                : p.quick   ? "quick"
                                : p.at_rest ? "rest"
                                            : "refining",
                                p.render_ms, p.stats.map_ms, p.stats.view_ms,
                                shown->psnr ? fmt::format(" psnr {:.1f}", *shown->psnr) : ""));
}

namespace {

// Around a picture that does not fill the pane; under it the colour would not be seen, and take its time.
void fill_around(const PaneRect& pane, const PaneRect& picture) {
  constexpr unsigned dark = 0xff0f0e0e;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const vec2 end = pane.begin + pane.size, picture_end = picture.begin + picture.size;
  const auto fill = [&](float left, float top, float right, float bottom) {
    if (left < right && top < bottom) list->AddRectFilled({left, top}, {right, bottom}, dark);
  };
  fill(pane.begin.x, pane.begin.y, end.x, picture.begin.y);
  fill(pane.begin.x, picture_end.y, end.x, end.y);
  fill(pane.begin.x, picture.begin.y, picture.begin.x, picture_end.y);
  fill(picture_end.x, picture.begin.y, end.x, picture_end.y);
}

}  // namespace

// With what plug-ins draw over it, where they do.
void ViewportPanel::show_image(Drawings& drawings, vec2 begin, vec2 size, float pixel_ratio) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto add = [&](unsigned texture, ImVec2 first, ImVec2 last) {
    list->AddImage(ImTextureID(std::intptr_t(texture)), to_im(begin), to_im(begin + size), first, last);
  };
  if (Canvas* canvas = drawings.over(texture_.shown(), size.x)) {
    canvas->filter(size * pixel_ratio);
    return add(canvas->texture(), {0.0f, 1.0f}, {1.0f, 0.0f});
  }
  texture_.filter(size * pixel_ratio);
  add(texture_.name(), {0.0f, 0.0f}, {1.0f, 1.0f});
}

void ViewportPanel::show(Studio& studio, Drawings& drawings, const PaneRect& pane, double pixel_ratio) {
  settle_size(studio, pane, pixel_ratio);
  take_picture(studio);
  ImGui::SetNextWindowPos(to_im(pane.begin));
  ImGui::SetNextWindowSize(to_im(pane.size));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::Begin("##picture", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  PaneRect shown = picture_;  // where the picture lies
  if (texture_.name() != 0) {
    // A picture of another shape than the pane's keeps its own until the next one is there.
    const SceneSnapshot& scene = texture_.shown()->picture->scene;
    shown = fitted(picture_, vec2(scene.width, scene.height));
    fill_around(pane, shown);
    show_image(drawings, shown.begin, shown.size, float(pixel_ratio));
  } else {
    fill_around(pane, {pane.begin, vec2(0.0f)});
  }
  ImGui::SetCursorScreenPos(to_im(pane.begin));
  ImGui::InvisibleButton("##hand", to_im(pane.size),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                             ImGuiButtonFlags_MouseButtonRight);
  const bool hovered = ImGui::IsItemHovered();
  studio.trace.item("picture", picture_.begin, picture_.size);
  comparison_.show(studio, pane, picture_, other_, texture_.shown(), pixel_ratio, hovered);
  if (texture_.name() != 0) {
    const ViewPicture& picture = *texture_.shown()->picture;
    overlay_.show(studio, picture, shown.begin, shown.size);
    handles_.show(studio, picture, shown.begin, shown.size, hovered && !comparison_.is_held());
    overlay_.select(studio, drawings, picture, shown.begin, shown.size,
                    hovered && !comparison_.is_held() && !handles_.is_taken());
  }
  probe_.choose(studio, picture_, hovered && !comparison_.is_held());
  hand_.move(studio, picture_, hovered && !comparison_.is_held());
  show_notes(studio, pane, texture_.shown());
  show_map_error(studio, texture_.shown(), pane);
  if (hovered) show_pixel(texture_.shown(), picture_, pane);
  ImGui::End();
  probe_.show(studio, pane);
  snapshots_.show(studio, pane);
  looks_.show(studio, pane);
}

}  // namespace plinian::window
