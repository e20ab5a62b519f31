// Two buttons of which one is on.
#include "host/window/panels/bottom_tabs.h"

#include <imgui.h>

#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

void show_bottom_tabs(Studio& studio) {
  const auto tab = [&](const char* label, const char* name, bool nodes, Action action, const char* what) {
    const std::string text = std::string(what) + " (" + text_of(studio.hotkeys.chord(action)) + ").";
    if (toggle(label, studio.show_nodes == nodes, text.c_str())) studio.show_nodes = nodes;
    note_item(studio.trace, name);
  };
  tab("Console", "tab console", false, Action::console_line,
      "What was done, as commands, and a line for more");
  ImGui::SameLine(0.0f, scaled(2));
  tab("Nodes", "tab nodes", true, Action::node_editor, "The nodes of the scene and what connects them");
  ImGui::SameLine(0.0f, scaled(14));
}

}  // namespace plinian::window
