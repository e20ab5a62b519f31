// What is open over the panels: menus, lists that drop down, dialogs, questions.
//
// Dear ImGui closes menus and lists by Escape only where it navigates by keys, which this window does not.
#pragma once

namespace plinian::window {

/// Whether there is any. Until it is gone, keys are its own. Between two pictures, too.
bool is_popup_open();

/// Closes the innermost one where it is a menu or a list; a dialog answers Escape itself.
void close_menu();

}  // namespace plinian::window
