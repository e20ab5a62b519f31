// What there is to say now on the left, the picture on the right.
#include "host/window/panels/status_line.h"

#include <fmt/format.h>
#include <imgui.h>

#include "host/window/drawing/shortened.h"
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

// One line; what has no room is read under the pointer, and in the console.
void show_news(const ConsoleLine& news, float room) {
  const std::string line = shortened(news.text.substr(0, news.text.find('\n')), room,
                                     [](const std::string& s) { return ImGui::CalcTextSize(s.c_str()).x; });
  ImGui::PushStyleColor(ImGuiCol_Text, news.kind == LineKind::error     ? colour::error
                                       : news.kind == LineKind::warning ? colour::warning
                                                                        : colour::text);
  ImGui::TextUnformatted(line.c_str());
  ImGui::PopStyleColor();
  if (line != news.text) help(news.text);
}

// As many as there is whole room for; where the others are listed comes first of all.
void show_hints(const Studio& studio, float room) {
  const auto key = [&](Action action) { return text_of(studio.hotkeys.chord(action)); };
  const std::string hints[] = {key(Action::hotkey_list) + " hotkeys",
                               "Alt+left tumbles, middle tracks, right or wheel dollies",
                               key(Action::frame_selection) + " frame   " + key(Action::frame_all) + " all",
                               key(Action::tool_translate) + " " + key(Action::tool_rotate) + " " +
                                   key(Action::tool_scale) + " move, turn, scale",
                               key(Action::light_hand) + "+drag turns the key light",
                               key(Action::zoom_hand) + "+wheel magnifies",
                               key(Action::quality_fast) + " fast   " + key(Action::quality_high) + " high",
                               "Ctrl+Alt where the desktop keeps Alt"};
  std::string line;
  for (const std::string& hint : hints) {
    const std::string longer = line.empty() ? hint : line + "     " + hint;
    if (ImGui::CalcTextSize(longer.c_str()).x > room) break;
    line = longer;
  }
  ImGui::TextDisabled("%s", line.c_str());
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
  const auto now = std::chrono::steady_clock::now();
  const bool is_new = studio.news.update(studio.console, now);
  const ConsoleLine* news = studio.news.line(now);
  if (is_new && news) studio.trace.note("says " + news->text);
  const float room = right - pane.begin.x - scaled(10);
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
  } else if (news) {
    show_news(*news, room);
  } else {
    show_hints(studio, room);
  }
  ImGui::PopClipRect();
  end_pane();
}

}  // namespace plinian::window
