// Lines in their colours, and the command line.
#include "host/window/panels/console_panel.h"

#include <imgui.h>

#include <cstdio>
#include <utility>

#include "host/window/console/completion.h"
#include "host/window/panels/bottom_tabs.h"
#include "host/window/panels/typing.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

unsigned colour_of(LineKind kind) {
  switch (kind) {
    case LineKind::command:
      return 0xffcfcac6;
    case LineKind::answer:
      return 0xffb9c8a8;
    case LineKind::warning:
      return colour::warning;
    case LineKind::error:
      return colour::error;
    case LineKind::note:
      break;
  }
  return colour::faint_text;
}

struct Both {
  ConsolePanel* panel;
  Studio* studio;
};

}  // namespace

int ConsolePanel::edit(Studio& studio, ImGuiInputTextCallbackData& data) {
  if (data.EventFlag == ImGuiInputTextFlags_CallbackAlways) {
    seen_ = data.Buf;
    if (!std::exchange(to_end_, false)) return 0;
    data.CursorPos = data.BufTextLen;
    data.ClearSelection();
    return 0;
  }
  if (data.EventFlag == ImGuiInputTextFlags_CallbackCompletion) {
    const std::string line(data.Buf, std::size_t(data.CursorPos));
    const Completion found = complete(studio.session(), line);
    if (found.words.empty()) return 0;
    std::string text = found.common;
    if (found.words.size() == 1 && !text.ends_with('.')) text += ' ';
    if (found.common == line.substr(found.begin) && found.words.size() > 1) {
      std::string listed;
      for (std::size_t i = 0; i < found.words.size() && i < 40; ++i) listed += found.words[i] + "  ";
      studio.console.add(LineKind::answer, listed);
    }
    data.DeleteChars(int(found.begin), data.CursorPos - int(found.begin));
    data.InsertChars(int(found.begin), text.c_str());
  } else if (data.EventFlag == ImGuiInputTextFlags_CallbackHistory) {
    if (data.EventKey == ImGuiKey_UpArrow && recalled_ > 0) --recalled_;
    if (data.EventKey == ImGuiKey_DownArrow && recalled_ < typed_.size()) ++recalled_;
    data.DeleteChars(0, data.BufTextLen);
    if (recalled_ < typed_.size()) data.InsertChars(0, typed_[recalled_].c_str());
  }
  if (data.BufDirty) forget_typing();
  return 0;
}

void ConsolePanel::show(Studio& studio, const PaneRect& pane) {
  begin_pane("##console", pane, false);
  show_bottom_tabs(studio);
  ImGui::NewLine();
  ImGui::PushFont(fonts().fixed);
  const float line = ImGui::GetFrameHeightWithSpacing();
  ImGui::BeginChild("##lines", {0.0f, -line}, false, ImGuiWindowFlags_NoBackground);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, scaled(2)));
  const bool at_end = ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 2.0f;
  ImGuiListClipper clipper;
  const auto& lines = studio.console.lines();
  const int columns = int(ImGui::GetContentRegionAvail().x / ImGui::CalcTextSize("M").x);
  if (columns != columns_ || studio.console.changes() != wrapped_) {
    rows_ = wrapped_rows(lines, columns);
    columns_ = columns;
    wrapped_ = studio.console.changes();
  }
  clipper.Begin(int(rows_.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const WrappedRow& row = rows_[std::size_t(i)];
      ImGui::PushStyleColor(ImGuiCol_Text, colour_of(row.kind));
      ImGui::TextUnformatted(row.text.c_str());
      ImGui::PopStyleColor();
      if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0))
        ImGui::SetClipboardText(lines[row.line].text.c_str());
    }
  ImGui::Dummy({0.0f, scaled(1)});  // for what hangs under the last line
  if (studio.console.changes() != shown_ && (at_end || shown_ == 0)) ImGui::SetScrollHereY(1.0f);
  shown_ = studio.console.changes();
  ImGui::PopStyleVar();
  ImGui::EndChild();

  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled(">");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1.0f);
  // What asks a question keeps the keys.
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) studio.focus_console = false;
  if (!studio.typed_ahead.empty() && studio.focus_console) {
    std::snprintf(line_, sizeof line_, "%s", std::exchange(studio.typed_ahead, "").c_str());
    to_end_ = true;
  }
  if (std::exchange(studio.focus_console, false)) ImGui::SetKeyboardFocusHere();
  Both both{this, &studio};
  const bool entered = ImGui::InputTextWithHint(
      "##line", "a command; Tab completes, 'help' lists them", line_, sizeof line_,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackCompletion |
          ImGuiInputTextFlags_CallbackHistory | ImGuiInputTextFlags_CallbackAlways,
      [](ImGuiInputTextCallbackData* data) {
        const Both& b = *static_cast<Both*>(data->UserData);
        return b.panel->edit(*b.studio, *data);
      },
      &both);
  studio.trace.item("command line", vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                    vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
  // Escape leaves the line and what was typed into it; Dear ImGui would bring back what stood there before.
  if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
    std::snprintf(line_, sizeof line_, "%s", seen_.c_str());
  if (entered && line_[0] != 0) {
    if (typed_.empty() || typed_.back() != line_) typed_.push_back(line_);
    recalled_ = typed_.size();
    if (const std::string& job = studio.commands.job.what; !job.empty()) {
      studio.console.add(LineKind::note, std::string(line_) + "  waits for: " + job);
      studio.trace.note("waits " + std::string(line_));
    }
    studio.commands.run(line_, "", true);
    line_[0] = 0;
    studio.focus_console = true;
    expect_typing();
  }
  ImGui::PopFont();
  end_pane();
}

}  // namespace plinian::window
