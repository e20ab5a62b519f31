// Takes the picture, shows it, and lets others write over it.
#include "host/window/panels/viewport_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "host/window/panels/fitted.h"
#include "host/window/panels/overlay_text.h"
#include "host/window/panels/picture_image.h"
#include "host/window/panels/viewport_notes.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

// What is measured against another picture has its size, however large it is shown: that of a file is the
// gate's; of one that was made here, any that has the shape in which the picture is shown.
ivec2 measured_size(const Studio& studio, ivec2 pixels) {
  const Comparison& comparison = studio.comparison;
  const bool is_made_here = comparison.kind == OtherKind::snapshot || comparison.kind == OtherKind::rendered;
  if (is_made_here && comparison.mode() != CompareMode::off) {
    const ivec2 other(comparison.other->frame.width, comparison.other->frame.height);
    const double height = double(other.y) * pixels.x / std::max(1, other.x);
    return std::abs(height - pixels.y) < 1.0 ? other : pixels;
  }
  if (studio.viewpoint.look.free || !studio.feed.snapshot()) return pixels;
  const SceneSnapshot& scene = studio.feed.snapshot()->snapshot;
  const auto wanted = comparison.wanted_size();
  return wanted == ivec2(scene.width, scene.height) ? *wanted : pixels;
}

}  // namespace

// Through a camera of the scene one sees what it takes in, no more; one's own fills the pane. [points]
vec2 ViewportPanel::settle_size(Studio& studio, const PaneRect& pane, double pixel_ratio) const {
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
  studio.picture_size = measured_size(studio, pixels);
  return size;
}

void ViewportPanel::take_picture(Studio& studio) {
  const ViewPicturePtr picture = studio.picture();
  const std::string how = words_of(studio.development);
  if (picture && (picture != asked_picture_.lock() || how != asked_development_)) {
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
  studio.trace.note(fmt::format(
      "picture {} {}x{} passes {} {} {:.0f} ms maps {:.0f} view {:.0f}{}", p.number, shown->width,
      shown->height, p.passes,
      p.is_played ? "played"
      : p.quick   ? "quick"
      : p.at_rest ? "rest"
                  : "refining",
      p.render_ms, p.stats.map_ms, p.stats.view_ms,
      shown->figures && !shown->is_rough ? fmt::format(" psnr {:.1f}", shown->figures->psnr) : ""));
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

// With what plug-ins draw over it, where they do. That is magnified with it: it is of the same pixels.
void ViewportPanel::show_image(Drawings& drawings, const PicturePlaces& places, const PaneRect& shown,
                               float pixel_ratio) {
  if (Canvas* canvas = drawings.over(texture_.shown(), fitted(places.whole, shown.size).size.x)) {
    canvas->filter(shown.size * pixel_ratio, places.shows_squares);
    return add_image(canvas->texture(), shown, places.room, true);
  }
  texture_.filter(shown.size * pixel_ratio, places.shows_squares);
  add_image(texture_.name(), shown, places.room);
}

void ViewportPanel::show(Studio& studio, Drawings& drawings, const PaneRect& pane, double pixel_ratio) {
  const vec2 size = settle_size(studio, pane, pixel_ratio);
  const auto place = [&] {
    return picture_places(pane, size, studio.picture_size.x,
                          studio.comparison.mode() == CompareMode::side_by_side, scaled(4),
                          studio.viewpoint.zoom, float(pixel_ratio));
  };
  take_picture(studio);
  ImGui::SetNextWindowPos(to_im(pane.begin));
  ImGui::SetNextWindowSize(to_im(pane.size));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::Begin("##picture", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  ImGui::SetCursorScreenPos(to_im(pane.begin));
  ImGui::InvisibleButton("##hand", to_im(pane.size),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                             ImGuiButtonFlags_MouseButtonRight);
  const bool hovered = ImGui::IsItemHovered();
  zoom_.move(studio, place(), hovered);
  const PicturePlaces places = place();
  PaneRect above = pane;  // the lines that read out the pixel
  above.size.y -= PixelLines::more_height(studio);
  PaneRect shown = places.picture;  // where the picture lies
  if (texture_.name() != 0) {
    // A picture of another shape than the pane's keeps its own until the next one is there.
    const SceneSnapshot& scene = texture_.shown()->picture->scene;
    shown = fitted(places.picture, vec2(scene.width, scene.height));
    fill_around(pane, common(shown, places.room));
    show_image(drawings, places, shown, float(pixel_ratio));
  } else {
    fill_around(pane, {pane.begin, vec2(0.0f)});
  }
  studio.trace.item("picture", places.picture.begin, places.picture.size);
  studio.trace.item("other picture", places.other.begin, places.other.size);
  const bool free_before = hovered && !zoom_.is_taken(studio);
  comparison_.show(studio, places, pixel_ratio, free_before);
  const bool free = free_before && !comparison_.is_held();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(to_im(places.room.begin), to_im(places.room.begin + places.room.size), true);
  if (texture_.name() != 0) {
    const ViewPicture& picture = *texture_.shown()->picture;
    const ImGuiIO& io = ImGui::GetIO();
    const bool over = free && holds(places.room, vec2(io.MousePos.x, io.MousePos.y));
    overlay_.show(studio, picture, shown, common(shown, places.room), above.begin.y + above.size.y);
    handles_.show(studio, picture, shown.begin, shown.size, over);
    overlay_.select(studio, drawings, picture, shown, over && !handles_.is_taken());
  }
  list->PopClipRect();
  probe_.choose(studio, places, shown, free);
  hand_.move(studio, places.picture, free);
  comparison_.show_lines(studio, pane, places, texture_.shown());
  show_notes(studio, places, pane, texture_.shown());
  show_map_error(studio, texture_.shown(), pane);
  pixel_.show(studio, texture_.shown(), places, shown, pane, hovered);
  ImGui::End();
  show_zoom_badge(studio, places, pane);
  snapshots_.show(studio, above);
  // Between what is written along the edges.
  const float top = std::max(pane.begin.y + scaled(34), comparison_.bottom() + scaled(6));
  const vec2 corner(pane.begin.x + scaled(10), top);
  const vec2 end = above.begin + above.size - vec2(scaled(10), scaled(34));
  probe_.show(studio, {corner, end - corner}, snapshots_.place(),
              texture_.shown() ? &texture_.shown()->picture->frame : nullptr);
  looks_.show(studio, pane);
}

}  // namespace plinian::window
