// The wipe and the figures.
#include "host/window/panels/comparison_overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/window/panels/overlay_text.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

void ComparisonOverlay::take_picture(Studio& studio, const std::string& how) {
  Comparison& comparison = studio.comparison;
  if (!comparison.other) return;
  if (comparison.other != asked_ || how != asked_how_) {
    Development plain = studio.development;
    plain.against = nullptr;
    plain.difference = false;
    comparison.developer.ask(comparison.other, plain);
    asked_ = comparison.other;
    asked_how_ = how;
  }
  texture_.show(comparison.developer.developed());
}

// The other picture left of a line that can be dragged.
void ComparisonOverlay::show_wipe(Studio& studio, const PaneRect& picture) {
  const vec2 begin = picture.begin, end = picture.begin + picture.size;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const float x = std::round(begin.x + picture.size.x * studio.comparison.wipe);
  list->PushClipRect(to_im(begin), {x, end.y}, true);
  list->AddImage(ImTextureID(std::intptr_t(texture_.name())), to_im(begin), to_im(end));
  list->PopClipRect();
  const bool near = std::abs(mouse.x - x) < scaled(6) && mouse.y > begin.y && mouse.y < end.y;
  if (near && ImGui::IsMouseClicked(0) && !ImGui::GetIO().KeyAlt && ImGui::IsWindowHovered()) wiping_ = true;
  if (!ImGui::IsMouseDown(0)) wiping_ = false;
  if (wiping_)
    studio.comparison.wipe = std::clamp((mouse.x - begin.x) / std::max(1.0f, picture.size.x), 0.0f, 1.0f);
  if (near || wiping_) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  list->AddLine({x, begin.y}, {x, end.y}, near || wiping_ ? colour::accent : 0xb0ffffff);
  draw_text({begin.x + scaled(10), begin.y + scaled(8)}, colour::text,
            studio.comparison.name + (studio.is_other_old() ? ", of another scene or view" : ""));
}

void ComparisonOverlay::show(Studio& studio, const PaneRect& pane, const PaneRect& picture,
                             const DevelopedPtr& shown) {
  if (studio.comparison.wipes && texture_.name() != 0) show_wipe(studio, picture);
  std::string text;
  if (studio.comparison.other && shown && shown->psnr)
    text = fmt::format("{}against {}: {:.1f} dB   SSIM {:.4f}",
                       studio.development.difference ? "4 x difference, " : "", studio.comparison.name,
                       *shown->psnr, *shown->ssim);
  else if (studio.comparison.other && (studio.comparison.wipes || studio.development.difference) &&
           studio.is_other_old())
    text = "the picture compared with is of another scene or view: Shift+R renders the reference anew";
  if (const auto share = studio.comparison.reference_share())
    text += fmt::format("{}reference {:.0f} %", text.empty() ? "" : "   ", 100.0 * *share);
  if (text.empty()) return;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  draw_text({pane.begin.x + pane.size.x - size.x - scaled(10), pane.begin.y + scaled(8)}, colour::text, text);
}

}  // namespace plinian::window
