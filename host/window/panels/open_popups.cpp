#include "host/window/panels/open_popups.h"

#include <imgui_internal.h>

namespace plinian::window {

bool is_popup_open() {
  return ImGui::GetCurrentContext()->OpenPopupStack.Size > 0;
}

void close_menu() {
  const ImVector<ImGuiPopupData>& open = ImGui::GetCurrentContext()->OpenPopupStack;
  if (open.empty()) return;
  const ImGuiWindow* window = open.back().Window;  // null where it was opened and not yet drawn
  if (window && window->Flags & ImGuiWindowFlags_Modal) return;
  ImGui::ClosePopupToLevel(open.Size - 1, true);
}

}  // namespace plinian::window
