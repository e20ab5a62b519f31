// What there is to say now on the left, the picture on the right.
#include "host/window/panels/status_line.h"

#include <fmt/format.h>
#include <imgui.h>

#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

// What has to be there before the next picture comes.
std::string awaited(Studio& studio) {
  if (!studio.commands.job.what.empty()) return studio.commands.job.what;
  if (studio.feed.is_computing()) return "computing " + studio.feed.progress().what;
  const bool failed = !studio.feed.problems().empty() || !studio.renderer.status().error.empty();
  return failed || studio.is_picture_there() ? "" : "rendering";
}

}  // namespace

std::string state_of(const ViewPicture& picture, const std::string& awaits) {
  if (picture.quick) return "quick";
  if (!picture.at_rest)
    return fmt::format("pass {} of {} at most", picture.passes, picture.scene.quality.view.passes);
  if (picture.passes > 0) return fmt::format("at rest, {} passes", picture.passes);
  // Of an empty scene; "at rest" would be taken for the end of what is only about to be seen.
  return awaits.empty() ? "nothing to see" : awaits;
}

void show_status(Studio& studio, const PaneRect& pane) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(10), scaled(2)));
  begin_pane("##status", pane, false);
  ImGui::PopStyleVar();
  ImGui::GetWindowDrawList()->AddRectFilled({pane.begin.x, pane.begin.y},
                                            {pane.begin.x + pane.size.x, pane.begin.y + pane.size.y},
                                            ImGui::GetColorU32(ImGuiCol_MenuBarBg));
  ImGui::AlignTextToFramePadding();
  float right = pane.begin.x + pane.size.x;
  const ViewPicturePtr picture = studio.picture();
  if (picture) {
    const std::string text =
        fmt::format("{}   {} x {}   {}", picture->scene.quality.name, picture->frame.width,
                    picture->frame.height, state_of(*picture, awaited(studio)));
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    right -= width + scaled(30);
    ImGui::SetCursorPosX(pane.size.x - width - scaled(10));
    ImGui::TextDisabled("%s", text.c_str());
    ImGui::SameLine(scaled(10));
  }
  // What there is to say on the left gives way to what the picture is.
  ImGui::PushClipRect({pane.begin.x, pane.begin.y}, {right, pane.begin.y + pane.size.y}, true);
  const auto& lines = studio.console.lines();
  if (!studio.commands.job.what.empty()) {
    ImGui::Text("%s  %.0f %%", studio.commands.job.what.c_str(), 100.0 * studio.commands.job.share);
    ImGui::SameLine();
    ImGui::TextDisabled("Esc cancels");
  } else if (studio.playblast.is_running()) {
    ImGui::Text("playblast  %d of %d", studio.playblast.frames_done(), studio.playblast.frames());
    ImGui::SameLine();
    ImGui::TextDisabled("Esc stops it");
  } else if (studio.feed.is_computing()) {
    const auto progress = studio.feed.progress();
    ImGui::Text("computing %s  %.0f %%", progress.what.c_str(), 100.0 * progress.fraction);
  } else if (!lines.empty() &&
             (lines.back().kind == LineKind::error || lines.back().kind == LineKind::warning)) {
    const bool error = lines.back().kind == LineKind::error;
    ImGui::PushStyleColor(ImGuiCol_Text, error ? colour::error : colour::warning);
    ImGui::TextUnformatted(lines.back().text.c_str());
    ImGui::PopStyleColor();
  } else {
    ImGui::TextDisabled(
        "Alt+mouse (or Ctrl+Alt): left tumbles, middle tracks, right or wheel dollies    W E R move, turn, "
        "scale   F frame   A all   Z+wheel magnifies   1 fast   2 high   L+drag turns the key light   F1 "
        "hotkeys");
  }
  ImGui::PopClipRect();
  end_pane();
}

}  // namespace plinian::window
