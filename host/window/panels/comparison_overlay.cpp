// The wipe, the other picture, and the figures.
#include "host/window/panels/comparison_overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/window/panels/fitted.h"
#include "host/window/panels/overlay_text.h"
#include "host/window/panels/picture_image.h"
#include "host/window/panels/zoom_hand.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

std::string size_text(ivec2 size) {
  return fmt::format("{}x{}", size.x, size.y);
}

// Not that of another one, which was compared before.
bool is_held_against(const DevelopedPtr& shown, const Comparison& comparison) {
  return shown && shown->against == comparison.other;
}

}  // namespace

void ComparisonOverlay::take_picture(Studio& studio, const DevelopedPtr& shown) {
  Comparison& comparison = studio.comparison;
  if (!comparison.other) {
    asked_.reset();
    asked_how_.clear();
    texture_.forget();
    return;
  }
  // As it was matched, where it was.
  const bool matched = is_held_against(shown, comparison) && shown->other &&
                       comparison.kind == OtherKind::file && comparison.mode() != CompareMode::off;
  const ViewPicturePtr other = matched ? shown->other : comparison.other;
  Development plain = studio.development;
  plain.against = nullptr;
  plain.against_file = nullptr;
  plain.seen = Seen::picture;
  const std::string how = words_of(plain);
  if (other != asked_.lock() || how != asked_how_) {
    comparison.developer.ask(other, plain);
    asked_ = other;
    asked_how_ = how;
  }
  texture_.show(comparison.developer.developed());
}

// The other picture on one side of a line that is dragged, and turned by its grips.
void ComparisonOverlay::show_wipe(Studio& studio, const PicturePlaces& places, bool free) {
  Wipe& wipe = studio.comparison.wipe;
  const vec2 begin = places.picture.begin, size = places.picture.size;
  const PaneRect seen = common(places.picture, places.room);
  if (const vec2 margin(scaled(12)); studio.viewpoint.zoom.is_on())
    wipe.keep_within(seen.begin + margin, glm::max(seen.size - 2.0f * margin, vec2(1.0f)), begin, size);
  ImDrawList* list = ImGui::GetWindowDrawList();
  // In its own shape, where the pane has another: seen through the free camera.
  const DevelopedPtr& other = texture_.shown();
  const PaneRect place = other ? fitted(places.picture, vec2(other->width, other->height)) : places.picture;
  const PaneRect part = common(place, seen);
  add_image(texture_.name(), place, clipped(wipe.other_side(begin, size), part.begin, part.size));
  const vec2 mouse(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
  const vec2 middle = begin + wipe.at * size;
  const float reach = std::min(seen.size.x, seen.size.y) * 0.3f;
  const vec2 forward = middle + wipe.along() * reach, backward = middle - wipe.along() * reach;
  const bool inside = free && holds(seen, mouse);
  const auto near_to = [&](vec2 point) { return glm::length(mouse - point) < scaled(9); };
  Hold under = Hold::nothing;
  if (inside && std::abs(wipe.distance(mouse, begin, size)) < scaled(6)) under = Hold::line;
  if (inside && near_to(forward)) under = Hold::forward_grip;
  if (inside && near_to(backward)) under = Hold::backward_grip;
  if (under != Hold::nothing && ImGui::IsMouseClicked(0) && !ImGui::GetIO().KeyAlt) {
    hold_ = under;
    grabbed_ = mouse - middle;
  }
  if (!ImGui::IsMouseDown(0)) hold_ = Hold::nothing;
  if (hold_ == Hold::line) wipe.move_to(mouse - grabbed_, begin, size);
  if (hold_ == Hold::forward_grip) wipe.turn_to(mouse, begin, size, true);
  if (hold_ == Hold::backward_grip) wipe.turn_to(mouse, begin, size, false);
  const Hold active = hold_ != Hold::nothing ? hold_ : under;
  if (active == Hold::line)
    ImGui::SetMouseCursor(std::abs(wipe.normal().x) > 0.7f ? ImGuiMouseCursor_ResizeEW
                                                           : ImGuiMouseCursor_ResizeNS);
  else if (active != Hold::nothing)
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const unsigned line_colour = active != Hold::nothing ? colour::accent : 0xb0ffffff;
  list->PushClipRect(to_im(seen.begin), to_im(seen.begin + seen.size), true);
  const float far = seen.size.x + seen.size.y;
  list->AddLine(to_im(middle - wipe.along() * far), to_im(middle + wipe.along() * far), line_colour);
  for (const vec2& grip : {forward, backward}) {
    list->AddCircleFilled(to_im(grip), scaled(4), 0xff202020);
    list->AddCircle(to_im(grip), scaled(4), line_colour, 0, scaled(1.5f));
  }
  list->PopClipRect();
  studio.trace.item("wipe grip", forward - vec2(4.0f), vec2(8.0f));
  studio.trace.item("wipe line", middle - vec2(4.0f), vec2(8.0f));
}

// In its own shape, within the place.
void ComparisonOverlay::draw_whole(const PaneRect& place, const PaneRect& room) const {
  const DevelopedPtr& shown = texture_.shown();
  if (!shown) return;
  const PaneRect picture = fitted(place, vec2(shown->width, shown->height)), part = common(place, room);
  ImGui::GetWindowDrawList()->AddRectFilled(to_im(part.begin), to_im(part.begin + part.size), 0xff0e0e0e);
  add_image(texture_.name(), picture, room);
}

std::vector<ComparisonLine> comparison_lines(const Studio& studio, const DevelopedPtr& shown) {
  const Comparison& comparison = studio.comparison;
  std::vector<ComparisonLine> lines;
  const auto say = [&](std::string text, bool is_rough = false) {
    lines.push_back({std::move(text), is_rough});
  };
  for (const ReferenceImage* image : {&comparison.images.reference, &comparison.images.plate})
    if (!image->problem().empty()) say(image->problem());
  if (const auto share = comparison.reference_share())
    say(fmt::format("rendering the reference: {:.0f} %", 100.0 * *share));
  if (!comparison.other) return lines;
  const bool is_held = is_held_against(shown, comparison);
  const bool is_on = comparison.mode() != CompareMode::off;
  if (const auto wanted = comparison.wanted_size(); wanted && studio.feed.snapshot()) {
    const SceneSnapshot& scene = studio.feed.snapshot()->snapshot;
    const ivec2 gate(scene.width, scene.height);
    if (gate != *wanted)
      say(fmt::format("{} is {}, the gate {}: set the gate to {} to measure", comparison.name,
                      size_text(*wanted), size_text(gate), size_text(*wanted)));
    else if (studio.viewpoint.look.free && is_on)
      say("C looks through the scene's camera, to measure against " + comparison.name);
  } else if (is_on && comparison.kind == OtherKind::rendered && studio.is_other_old()) {
    say("the reference is of another scene or view: Shift+R renders it anew");
  } else if (is_on && is_held && !shown->figures && !shown->picture->quick) {
    const ivec2 size(comparison.other->frame.width, comparison.other->frame.height);
    say(fmt::format("{} is {}, the picture {}x{}: give the pane its old size to measure", comparison.name,
                    size_text(size), shown->width, shown->height));
  }
  if (is_on && is_held && !shown->lacks.empty())
    say(fmt::format("{} has no layer '{}' to be measured against", comparison.name, shown->lacks));
  if (!is_held || !shown->figures) return lines;
  const Figures& figures = *shown->figures;
  // What is not at rest yet comes nearer by itself.
  const bool rough = shown->is_rough;
  const char* about = shown->picture->at_rest && !rough ? "" : "~ ";
  std::string text = std::isfinite(figures.psnr) ? fmt::format("{}{:.1f} dB", about, figures.psnr)
                                                 : fmt::format("{}identical", about);
  text = fmt::format("against {}: {}   {}SSIM {:.4f}", comparison.name, text, about, figures.ssim);
  if (figures.flip) text += fmt::format("   {}FLIP {:.4f}", about, *figures.flip);
  if (comparison.mode() == CompareMode::difference) text = "4 x difference   " + text;
  say(text, rough);
  // What to turn when a picture is to be met: light where all are off, colours where one is.
  if (const auto& b = figures.balance)
    say(fmt::format("{}brightness, this / {}:   R {:.2f}   G {:.2f}   B {:.2f}   ({:+.2f} EV)", about,
                    comparison.name, b->x, b->y, b->z,
                    std::log2(std::max((b->x + b->y + b->z) / 3.0f, 1e-6f))),
        rough);
  if (!figures.matched.empty()) say(comparison.name + " is " + figures.matched + " (Compare > Match)", rough);
  return lines;
}

CompareMode ComparisonOverlay::shown_mode(const Comparison& comparison) const {
  return comparison.other && texture_.name() != 0 ? comparison.mode() : CompareMode::off;
}

void ComparisonOverlay::show(Studio& studio, const PicturePlaces& places, double pixel_ratio, bool free) {
  const Comparison& comparison = studio.comparison;
  texture_.filter(places.picture.size * float(pixel_ratio), places.shows_squares);
  const CompareMode mode = shown_mode(comparison);
  if (mode == CompareMode::wipe)
    show_wipe(studio, places, free);
  else
    hold_ = Hold::nothing;
  const bool others_turn = comparison.is_others_turn();
  if (mode == CompareMode::side_by_side || (mode == CompareMode::flicker && others_turn))
    draw_whole(places.other, places.other_room);
}

void ComparisonOverlay::show_lines(const Studio& studio, const PaneRect& pane, const PicturePlaces& places,
                                   const DevelopedPtr& shown) {
  const Comparison& comparison = studio.comparison;
  const CompareMode mode = shown_mode(comparison);
  const vec2 corner(scaled(10), scaled(8));
  const bool is_now = mode == CompareMode::flicker && !comparison.is_others_turn();
  const bool is_named =
      mode == CompareMode::wipe || mode == CompareMode::side_by_side || mode == CompareMode::flicker;
  std::string label = !is_named ? "" : is_now ? "now" : comparison.name;
  // What is looked at is not what is in the file.
  if (is_named && !is_now && is_held_against(shown, comparison) && shown->figures)
    if (const std::string& matched = shown->figures->matched; !matched.empty()) label += ", " + matched;
  vec2 label_at = common(places.other, places.other_room).begin + corner;
  const float badge = zoom_badge_width(places), badge_end = pane.begin.x + corner.x + badge;
  if (badge > 0.0f) label_at.x = std::max(label_at.x, badge_end);
  if (is_named) draw_text(label_at, is_now ? colour::faint_text : colour::text, label);
  const float label_end = is_named ? label_at.x + ImGui::CalcTextSize(label.c_str()).x + corner.x : badge_end;
  const float row = ImGui::GetTextLineHeight() + scaled(3);
  vec2 at(pane.begin.x + pane.size.x - corner.x, pane.begin.y + corner.y);
  for (const auto& [line, is_rough] : comparison_lines(studio, shown)) {
    const float width = ImGui::CalcTextSize(line.c_str()).x;
    // In a narrow pane the lines come below the label and the badge.
    if ((is_named || badge > 0.0f) && at.x - width < label_end && std::abs(at.y - label_at.y) < row)
      at.y = label_at.y + row;
    const vec2 text_at(std::max(pane.begin.x + corner.x, at.x - width), at.y);
    // Readable on the grey of a difference and across the picture's edge.
    constexpr unsigned veil = 0xa0000000;
    const vec2 margin(scaled(4), scaled(1));
    ImGui::GetWindowDrawList()->AddRectFilled(
        to_im(text_at - margin), to_im(text_at + vec2(width, ImGui::GetTextLineHeight()) + margin), veil,
        scaled(3));
    draw_text(text_at, is_rough ? colour::faint_text : colour::text, line);
    at.y += row;
  }
  bottom_ = at.y;
}

}  // namespace plinian::window
