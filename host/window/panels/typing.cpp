// Empties the steps of undo of Dear ImGui's field of text, of which it has one for all.
#include "host/window/panels/typing.h"

#include <imgui_internal.h>

namespace plinian::window {

void forget_left_typing() {
  if (ImGui::GetActiveID() != ImGui::GetCurrentContext()->InputTextState.ID) forget_typing();
}

bool is_typing() {
  const ImGuiID active = ImGui::GetActiveID();
  return active != 0 && active == ImGui::GetCurrentContext()->InputTextState.ID;
}

namespace {
int expected_at = -2;  // picture
}

void expect_typing() {
  expected_at = ImGui::GetFrameCount();
}

bool is_typing_expected() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.NavMoveSubmitted || ImGui::GetFrameCount() == expected_at;
}

void forget_typing() {
  ImStb::StbUndoState& undo = ImGui::GetCurrentContext()->InputTextState.Stb.undostate;
  undo.undo_point = 0;
  undo.undo_char_point = 0;
  undo.redo_point = STB_TEXTEDIT_UNDOSTATECOUNT;
  undo.redo_char_point = STB_TEXTEDIT_UNDOCHARCOUNT;
}

}  // namespace plinian::window
