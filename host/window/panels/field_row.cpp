// Two columns.
#include "host/window/panels/field_row.h"

#include <imgui.h>

#include <cmath>

#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

float field_label(const std::string& label, bool strong, const std::string& text) {
  const float whole = ImGui::GetContentRegionAvail().x, column = std::round(whole * 0.41f);
  const ImVec2 begin = ImGui::GetCursorScreenPos();
  ImGui::AlignTextToFramePadding();
  ImGui::PushClipRect(begin, {begin.x + column - scaled(4), begin.y + ImGui::GetFrameHeight()}, true);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + scaled(14));
  if (strong)
    ImGui::TextUnformatted(label.c_str());
  else
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(0xffb4b0ae), "%s", label.c_str());
  ImGui::PopClipRect();
  help(text);
  ImGui::SameLine();
  ImGui::SetCursorScreenPos({begin.x + column, begin.y});
  return whole - column - field_mark_width();
}

float field_mark_width() {
  return scaled(16);
}

}  // namespace plinian::window
