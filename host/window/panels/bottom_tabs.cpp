// Buttons of which one is on.
#include "host/window/panels/bottom_tabs.h"

#include <imgui.h>

#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

void show_bottom_tabs(Studio& studio) {
  const auto tab = [&](const char* label, const char* name, bool nodes, Action action, const char* what) {
    const std::string text = std::string(what) + " (" + text_of(studio.hotkeys.chord(action)) + ").";
    const bool is_on = studio.show_nodes == nodes && !studio.inspector.is_beneath();
    if (toggle(label, is_on, text.c_str())) {
      studio.show_nodes = nodes;
      studio.inspector.is_behind = true;
    }
    note_item(studio.trace, name);
  };
  tab("Console", "tab console", false, Action::console_line,
      "What was done, as commands, and a line for more");
  ImGui::SameLine(0.0f, scaled(2));
  tab("Nodes", "tab nodes", true, Action::node_editor, "The nodes of the scene and what connects them");
  if (studio.inspector.on && studio.inspector.is_docked) {
    ImGui::SameLine(0.0f, scaled(2));
    const std::string text =
        "What the probe found in the picture (" + text_of(studio.hotkeys.chord(Action::probe)) + ").";
    if (toggle("Probe", studio.inspector.is_beneath(), text.c_str())) studio.inspector.is_behind = false;
    note_item(studio.trace, "tab probe");
  }
  ImGui::SameLine(0.0f, scaled(14));
}

}  // namespace plinian::window
