// Shows, moves, tells.
#include "host/window/panels/viewport_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "host/graph/model/conversion.h"
#include "host/window/navigation/key_light.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

ImVec2 to_im(vec2 v) {
  return {v.x, v.y};
}

std::string words_of(const Development& how) {
  std::string words =
      fmt::format("{} {} {} {} {} {} {}", how.solo_ambient, int(how.view.view), how.view.exposure,
                  how.view.ocio_config, how.view.ocio_display, how.view.ocio_view, how.layer);
  words += fmt::format(" {} {}", static_cast<const void*>(how.against.get()), how.difference);
  for (const std::string& light : how.solo) words += " " + light;
  return words;
}

dvec3 rotation_of(Studio& studio, graph::NodeId light) {
  const graph::Node& node = *studio.session().graph().find(light);
  dvec3 rotation(0.0);
  for (int i = 0; i < 3; ++i)
    rotation[i] = graph::number_of(node.value(node.schema->find(std::string("rotate.") + "xyz"[i])));
  return rotation;
}

// Text on the picture, readable on white as on black.
void draw_text(ImDrawList* list, vec2 at, unsigned colour, const std::string& text) {
  list->AddText({at.x + 1.0f, at.y + 1.0f}, 0xc0000000, text.c_str());
  list->AddText(to_im(at), colour, text.c_str());
}

}  // namespace

// Through a camera of the scene one sees what it takes in, no more; one's own fills the pane.
void ViewportPanel::settle_size(Studio& studio, const PaneRect& pane, double pixel_ratio) {
  vec2 size = pane.size;
  if (!studio.look.free && studio.feed.snapshot()) {
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
  begin_ = pane.begin + glm::floor((pane.size - size) * 0.5f);
  end_ = begin_ + size;
}

void ViewportPanel::take_picture(Studio& studio) {
  const ViewPicturePtr picture = studio.renderer.picture();
  const std::string how = words_of(studio.development);
  if (picture && (picture != asked_picture_ || how != asked_development_)) {
    studio.developer.ask(picture, studio.development);
    asked_picture_ = picture;
    asked_development_ = how;
  }
  if (studio.kept && (studio.kept != asked_kept_ || how != asked_kept_development_)) {
    Development plain = studio.development;
    plain.against = nullptr;
    plain.difference = false;
    studio.kept_developer.ask(studio.kept, plain);
    asked_kept_ = studio.kept;
    asked_kept_development_ = how;
  }
  if (studio.kept) kept_texture_.show(studio.kept_developer.developed());
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

void ViewportPanel::navigate(Studio& studio, bool hovered) {
  if (!studio.feed.snapshot()) return;
  const ImGuiIO& io = ImGui::GetIO();
  const dvec2 mouse(io.MousePos.x, io.MousePos.y);
  const ivec2 pane(std::max(1.0f, end_.x - begin_.x), std::max(1.0f, end_.y - begin_.y));
  // Alt, and Ctrl+Alt where the desktop keeps Alt to itself.
  if (hovered && hand_ == Hand::none && io.KeyAlt) {
    if (ImGui::IsMouseClicked(0)) hand_ = Hand::tumble;
    if (ImGui::IsMouseClicked(2)) hand_ = Hand::track;
    if (ImGui::IsMouseClicked(1)) hand_ = Hand::dolly;
    moved_ = false;
    last_ = mouse;
  }
  if (hovered && hand_ == Hand::none && studio.light_key_held && ImGui::IsMouseClicked(0)) {
    light_ = light_to_turn(studio.session().graph());
    if (light_) {
      hand_ = Hand::light;
      moved_ = false;
      last_ = pressed_ = mouse;
      light_start_ = rotation_of(studio, light_);
      merge_key_ = studio.new_merge_key("light");
    }
  }
  if (hand_ == Hand::light) {
    turn_light(studio, mouse);
  } else if (hand_ != Hand::none) {
    const int button = hand_ == Hand::tumble ? 0 : hand_ == Hand::track ? 2 : 1;
    const dvec2 delta = mouse - last_;
    if (delta != dvec2(0.0)) {
      const FreeCamera camera = studio.free_camera();
      studio.move_camera(hand_ == Hand::tumble  ? tumble(camera, delta)
                         : hand_ == Hand::track ? track(camera, delta, pane)
                                                : dolly(camera, delta.x - delta.y),
                         !moved_);
      moved_ = true;
      last_ = mouse;
    }
    if (moved_) studio.keep_hand_on();
    if (!ImGui::IsMouseDown(button)) hand_ = Hand::none;
  } else if (hovered && io.MouseWheel != 0.0f) {
    constexpr double points_per_notch = 100.0 / 7.0;
    studio.move_camera(dolly(studio.free_camera(), io.MouseWheel * points_per_notch), !studio.is_hand_on());
    studio.keep_hand_on();
  }
}

// The whole drag is one edit: from where the light stood to where the mouse is.
void ViewportPanel::turn_light(Studio& studio, dvec2 mouse) {
  const graph::Node* node = studio.session().graph().find(light_);
  if (!node || !ImGui::IsMouseDown(0)) {
    if (moved_) studio.end_drag();
    hand_ = Hand::none;
    return;
  }
  if (moved_) studio.keep_hand_on();
  if (mouse == last_) return;
  const dvec3 rotation = turned_light(light_start_, mouse - pressed_);
  studio.run(light_command(node->name, rotation), merge_key_);
  studio.keep_hand_on();
  moved_ = true;
  last_ = mouse;
}

// What there is to say about the picture, in its corners.
void ViewportPanel::show_notes(Studio& studio, const PaneRect& pane) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float line = ImGui::GetTextLineHeight() + scaled(3);
  vec2 at = pane.begin + vec2(scaled(10), scaled(8));
  const std::vector<std::string>& problems = studio.feed.problems();
  const std::string render_error = studio.renderer.status().error;
  for (const std::string& problem : problems) {
    draw_text(list, at, colour::error, problem);
    at.y += line;
  }
  if (!render_error.empty()) {
    draw_text(list, at, colour::error, render_error);
    at.y += line;
  }
  const bool stale = studio.feed.is_stale() && studio.feed.snapshot();
  if (stale) draw_text(list, at, colour::warning, problems.empty() ? "updating" : "the last good picture");
  if (texture_.shown() && !texture_.shown()->error.empty())
    draw_text(list, at, colour::error, texture_.shown()->error);
  if (studio.feed.snapshot() && studio.feed.snapshot()->snapshot.media.empty() && studio.job.what.empty()) {
    const std::string hint = "Nothing to see yet: drop a .vdb here, or take Scene > Begin with.";
    const ImVec2 size = ImGui::CalcTextSize(hint.c_str());
    draw_text(list, pane.begin + (pane.size - vec2(size.x, size.y)) * 0.5f, colour::faint_text, hint);
  }
  if (studio.show_display) show_figures(studio, pane);
  // While a picture refines, a thin line runs along its lower edge.
  const ViewRenderer::Status status = studio.renderer.status();
  if (status.is_busy && !studio.is_hand_on()) {
    const float y = pane.begin.y + pane.size.y - scaled(2);
    list->AddRectFilled({pane.begin.x, y}, {pane.begin.x + pane.size.x * float(status.share), y + scaled(2)},
                        (colour::accent & 0x00ffffff) | 0x90000000);
  }
}

// The other picture left of a line that can be dragged, and how far they are apart.
void ViewportPanel::show_comparison(Studio& studio, const PaneRect& pane) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (studio.wipes && kept_texture_.name() != 0) {
    const float x = std::round(begin_.x + (end_.x - begin_.x) * studio.wipe);
    list->PushClipRect(to_im(begin_), {x, end_.y}, true);
    list->AddImage(ImTextureID(std::intptr_t(kept_texture_.name())), to_im(begin_), to_im(end_));
    list->PopClipRect();
    const bool near = std::abs(mouse.x - x) < scaled(6) && mouse.y > begin_.y && mouse.y < end_.y;
    if (near && ImGui::IsMouseClicked(0) && !ImGui::GetIO().KeyAlt && ImGui::IsWindowHovered())
      wiping_ = true;
    if (!ImGui::IsMouseDown(0)) wiping_ = false;
    if (wiping_)
      studio.wipe = std::clamp((mouse.x - begin_.x) / std::max(1.0f, end_.x - begin_.x), 0.0f, 1.0f);
    if (near || wiping_) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    list->AddLine({x, begin_.y}, {x, end_.y}, near || wiping_ ? colour::accent : 0xb0ffffff);
    draw_text(list, {begin_.x + scaled(10), begin_.y + scaled(8)}, colour::text,
              studio.kept_name + (studio.is_kept_old() ? ", of another scene or view" : ""));
  }
  std::string text;
  const DevelopedPtr& shown = texture_.shown();
  if (studio.kept && shown && shown->psnr)
    text = fmt::format("{}against {}: {:.1f} dB   SSIM {:.4f}",
                       studio.development.difference ? "4 x difference, " : "", studio.kept_name,
                       *shown->psnr, *shown->ssim);
  else if (studio.kept && (studio.wipes || studio.development.difference) && studio.is_kept_old())
    text = "the picture compared with is of another scene or view: Shift+R renders the reference anew";
  if (const auto share = studio.reference_share())
    text += fmt::format("{}reference {:.0f} %", text.empty() ? "" : "   ", 100.0 * *share);
  if (text.empty()) return;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  draw_text(list, {pane.begin.x + pane.size.x - size.x - scaled(10), pane.begin.y + scaled(8)}, colour::text,
            text);
}

// What the picture that is up cost.
void ViewportPanel::show_figures(Studio& studio, const PaneRect& pane) {
  const ViewPicturePtr picture = studio.renderer.picture();
  if (!picture) return;
  const RenderStats& stats = picture->stats;
  constexpr double mebibyte = 1024.0 * 1024.0;
  std::uint64_t voxels = 0;
  for (const Medium& medium : picture->scene.media)
    if (medium.volume) voxels += medium.volume->active_voxels;
  const std::vector<std::string> lines = {
      fmt::format("view     {:7.1f} ms", stats.view_ms),
      fmt::format("maps     {:7.1f} ms", stats.map_ms),
      fmt::format("upload   {:7.1f} ms", stats.upload_ms),
      fmt::format("picture  {:7.1f} ms", picture->render_ms),
      fmt::format("passes   {:7}", picture->passes),
      fmt::format("size     {:4}x{}", picture->frame.width, picture->frame.height),
      fmt::format("maps made{:7}", stats.map_builds),
      fmt::format("voxels   {:7.2f} M", double(voxels) / 1e6),
      fmt::format("on GPU   {:7.1f} MiB", double(stats.volume_bytes + stats.map_bytes) / mebibyte),
      fmt::format("asked    {:7}", studio.renderer.status().begun),
      fmt::format("overtaken{:7}", studio.renderer.status().dropped)};
  ImGui::PushFont(fonts().fixed);
  const float width = ImGui::CalcTextSize("maps made0000000 MiB  ").x,
              line = ImGui::GetTextLineHeight() + scaled(2);
  vec2 at(pane.begin.x + pane.size.x - width - scaled(10), pane.begin.y + scaled(36));
  ImGui::GetWindowDrawList()->AddRectFilled({at.x - scaled(8), at.y - scaled(6)},
                                            {at.x + width, at.y + line * float(lines.size()) + scaled(6)},
                                            0xa0101010, scaled(4));
  for (const std::string& text : lines) {
    draw_text(ImGui::GetWindowDrawList(), at, 0xffc8c4c2, text);
    at.y += line;
  }
  ImGui::PopFont();
}

void ViewportPanel::show_pixel(const PaneRect& pane) {
  const DevelopedPtr& shown = texture_.shown();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (!shown || mouse.x < begin_.x || mouse.y < begin_.y || mouse.x >= end_.x || mouse.y >= end_.y) return;
  const vec2 share = (vec2(mouse.x, mouse.y) - begin_) / (end_ - begin_);
  const Frame& frame = shown->picture->frame;
  const int x = std::clamp(int(share.x * frame.width), 0, frame.width - 1);
  const int y = std::clamp(int(share.y * frame.height), 0, frame.height - 1);
  const std::size_t pixel = std::size_t(y) * frame.width + x;
  const vec3 c = frame.beauty[pixel], t = frame.transmittance[pixel];
  const float depth = frame.depth[pixel];
  const std::string text = fmt::format("{:4} {:4}   {:.4f} {:.4f} {:.4f}   a {:.3f}{}", x, y, c.x, c.y, c.z,
                                       1.0f - (t.x + t.y + t.z) / 3.0f,
                                       std::isfinite(depth) ? fmt::format("   z {:.4g} m", depth) : "");
  ImGui::PushFont(fonts().fixed);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  draw_text(ImGui::GetWindowDrawList(), pane.begin + vec2(scaled(10), pane.size.y - size.y - scaled(8)),
            colour::faint_text, text);
  ImGui::PopFont();
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
    vec2 begin = begin_, end = end_;
    if (scene.width != studio.picture_size.x || scene.height != studio.picture_size.y) {
      const float scale =
          std::min((end_.x - begin_.x) / float(frame.width), (end_.y - begin_.y) / float(frame.height));
      const vec2 size = vec2(frame.width, frame.height) * scale;
      begin = begin_ + (end_ - begin_ - size) * 0.5f;
      end = begin + size;
    }
    ImGui::GetWindowDrawList()->AddImage(ImTextureID(std::intptr_t(texture_.name())), to_im(begin),
                                         to_im(end));
  }
  ImGui::SetCursorScreenPos(to_im(pane.begin));
  ImGui::InvisibleButton("##hand", to_im(pane.size),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                             ImGuiButtonFlags_MouseButtonRight);
  const bool hovered = ImGui::IsItemHovered();
  studio.trace.item("picture", begin_, end_ - begin_);
  show_comparison(studio, pane);
  navigate(studio, hovered && !wiping_);
  show_notes(studio, pane);
  if (hovered) show_pixel(pane);
  ImGui::End();
}

}  // namespace plinian::window
