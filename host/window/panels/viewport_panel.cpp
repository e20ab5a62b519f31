// Takes the picture, shows it, and lets others write over it.
#include "host/window/panels/viewport_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "host/window/panels/overlay_text.h"
#include "host/window/panels/viewport_notes.h"

namespace plinian::window {

namespace {

std::string words_of(const Development& how) {
  std::string words =
      fmt::format("{} {} {} {} {} {} {}", how.solo_ambient, int(how.view.view), how.view.exposure,
                  how.view.ocio_config, how.view.ocio_display, how.view.ocio_view, how.layer);
  words += fmt::format(" {} {}", static_cast<const void*>(how.against.get()), how.difference);
  for (const std::string& light : how.solo) words += " " + light;
  return words;
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
  const ivec2 pixels(std::max(16, int(std::lround(size.x * pixel_ratio))),
                     std::max(16, int(std::lround(size.y * pixel_ratio))));
  studio.picture_size = pixels;
  size = vec2(pixels) / float(pixel_ratio);
  picture_ = {pane.begin + glm::floor((pane.size - size) * 0.5f), size};
}

void ViewportPanel::take_picture(Studio& studio) {
  const ViewPicturePtr picture = studio.renderer.picture();
  const std::string how = words_of(studio.development);
  if (picture && (picture != asked_picture_ || how != asked_development_)) {
    studio.developer.ask(picture, studio.development);
    asked_picture_ = picture;
    asked_development_ = how;
  }
  comparison_.take_picture(studio, how);
  const DevelopedPtr before = texture_.shown();
  texture_.show(studio.developer.developed());
  const DevelopedPtr& shown = texture_.shown();
  if (!shown || shown == before || !studio.trace.is_on()) return;
  const ViewPicture& p = *shown->picture;
  studio.trace.note(fmt::format("picture {} {}x{} passes {} {} {:.0f} ms maps {:.0f} view {:.0f}{}", p.number,
                                shown->width, shown->height, p.passes,
                                p.quick     ? "quick"
                                : p.at_rest ? "rest"
                                            : "refining",
                                p.render_ms, p.stats.map_ms, p.stats.view_ms,
                                shown->psnr ? fmt::format(" psnr {:.1f}", *shown->psnr) : ""));
}

void ViewportPanel::show(Studio& studio, const PaneRect& pane, double pixel_ratio) {
  settle_size(studio, pane, pixel_ratio);
  take_picture(studio);
  ImGui::SetNextWindowPos(to_im(pane.begin));
  ImGui::SetNextWindowSize(to_im(pane.size));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.055f, 0.055f, 0.057f, 1.0f));
  ImGui::Begin("##picture", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  if (texture_.name() != 0) {
    // A picture of another shape than the pane's keeps its own until the next one is there.
    const Frame& frame = texture_.shown()->picture->frame;
    const SceneSnapshot& scene = texture_.shown()->picture->scene;
    vec2 begin = picture_.begin, size = picture_.size;
    if (scene.width != studio.picture_size.x || scene.height != studio.picture_size.y) {
      const float scale = std::min(size.x / float(frame.width), size.y / float(frame.height));
      size = vec2(frame.width, frame.height) * scale;
      begin = picture_.begin + (picture_.size - size) * 0.5f;
    }
    ImGui::GetWindowDrawList()->AddImage(ImTextureID(std::intptr_t(texture_.name())), to_im(begin),
                                         to_im(begin + size));
  }
  ImGui::SetCursorScreenPos(to_im(pane.begin));
  ImGui::InvisibleButton("##hand", to_im(pane.size),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                             ImGuiButtonFlags_MouseButtonRight);
  const bool hovered = ImGui::IsItemHovered();
  studio.trace.item("picture", picture_.begin, picture_.size);
  comparison_.show(studio, pane, picture_, texture_.shown());
  probe_.choose(studio, picture_, hovered && !comparison_.is_held());
  hand_.move(studio, picture_, hovered && !comparison_.is_held());
  show_notes(studio, pane, texture_.shown());
  if (hovered) show_pixel(texture_.shown(), picture_, pane);
  ImGui::End();
  probe_.show(studio, pane);
}

}  // namespace plinian::window
