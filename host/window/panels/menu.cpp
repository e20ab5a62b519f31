// Every entry is an action of the hotkeys or a command, those of plug-ins too.
#include "host/window/panels/menu.h"

#include <fmt/format.h>
#include <imgui.h>

#include <set>

#include "host/scene/looks.h"
#include "host/window/hotkeys/actions.h"
#include "host/window/panels/look_gallery.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

void item(Studio& studio, const char* label, Action action, bool enabled = true, bool on = false) {
  const std::string keys = text_of(studio.hotkeys.chord(action));
  if (ImGui::MenuItem(label, keys == "none" ? "" : keys.c_str(), on, enabled)) act(studio, action);
}

void command(Studio& studio, const char* label, const std::string& line) {
  if (ImGui::MenuItem(label)) studio.run(line);
}

std::string with_name(const char* what, const std::vector<std::string>& names, bool last) {
  if (names.empty()) return what;
  std::string name = last ? names.back() : names.front();
  if (name.size() > 40) name = name.substr(0, 37) + "...";
  return std::string(what) + "  " + name;
}

// What plug-ins add behind `begin` of a path, "Create/": an entry, or a menu of them.
void of_plugins(Studio& studio, const std::string& begin) {
  std::set<std::string> menus;
  for (const sdk::MenuItem& item : studio.workspace.plugins().menu()) {
    if (!item.path.starts_with(begin)) continue;
    const std::string rest = item.path.substr(begin.size()), name = rest.substr(0, rest.find('/'));
    if (name == rest) {
      if (ImGui::MenuItem(name.c_str())) studio.commands.run(item.command, "", true);
      note_item(studio.trace, "menu " + item.path);
      if (!item.help.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", item.help.c_str());
    } else if (menus.insert(name).second && ImGui::BeginMenu(name.c_str())) {
      of_plugins(studio, begin + name + "/");
      ImGui::EndMenu();
    }
  }
}

// Menus that only plug-ins have.
void menus_of_plugins(Studio& studio) {
  std::set<std::string> menus = {"Scene", "Edit", "Tools", "Create", "Looks", "View", "Compare"};
  for (const sdk::MenuItem& item : studio.workspace.plugins().menu()) {
    const std::string name = item.path.substr(0, item.path.find('/'));
    if (name == item.path || !menus.insert(name).second || !ImGui::BeginMenu(name.c_str())) continue;
    of_plugins(studio, name + "/");
    ImGui::EndMenu();
  }
}

void create_menu(Studio& studio) {
  command(studio, "Directional light", "createNode directionalLight");
  command(studio, "Spot light", "createNode spotLight");
  command(studio, "Point light", "createNode pointLight");
  command(studio, "Ambient light", "createNode ambientLight");
  ImGui::Separator();
  command(studio, "Camera", "createNode camera");
  command(studio, "Transform", "createNode transform");
  command(studio, "Medium", "createNode medium");
  ImGui::Separator();
  if (ImGui::BeginMenu("Any node")) {
    for (const std::string& type : studio.session().types().names())
      if (ImGui::MenuItem(type.c_str())) studio.run("createNode " + type);
    ImGui::EndMenu();
  }
}

void looks_menu(Studio& studio) {
  ImGui::MenuItem("Gallery", "", &studio.show_looks);
  note_item(studio.trace, "looks gallery");
  ImGui::Separator();
  const graph::Node* medium = scene::medium_for_looks(studio.session().graph());
  ImGui::TextDisabled("%s", medium ? ("put on " + medium->name).c_str() : "the scene has no medium");
  if (!medium) return;
  for (const std::string& look : scene::look_names())
    if (ImGui::MenuItem(look.c_str())) put_on(studio, look);
}

void recent_menu(Studio& studio) {
  const std::vector<std::string> paths = studio.files.recent.all();
  if (paths.empty()) ImGui::TextDisabled("nothing yet");
  for (const std::string& path : paths)
    if (ImGui::MenuItem(path.c_str())) studio.files.open(path);
  if (paths.empty()) return;
  ImGui::Separator();
  if (ImGui::MenuItem("Forget them")) studio.files.recent.clear();
}

void compare_menu(Studio& studio) {
  Comparison& comparison = studio.comparison;
  item(studio, "Keep a snapshot", Action::snapshot_picture);
  item(studio, "Render the reference", Action::reference);
  if (ImGui::MenuItem("Stop the reference", "", false, comparison.reference_share().has_value()))
    comparison.stop_reference();
  item(studio, "Load a reference...", Action::load_reference);
  if (ImGui::MenuItem("Load a plate...")) studio.ask_plate = true;
  const auto wanted = comparison.wanted_size();
  const std::string gate =
      wanted ? fmt::format("Set the gate to {}x{}", wanted->x, wanted->y) : "Set the gate to the reference's";
  if (ImGui::MenuItem(gate.c_str(), "", false, wanted.has_value())) studio.set_gate(*wanted);
  ImGui::Separator();
  const bool there = comparison.has_other();
  const auto way = [&](const char* label, Action action, CompareMode mode) {
    item(studio, label, action, there, comparison.mode() == mode);
  };
  way("Wipe", Action::wipe, CompareMode::wipe);
  way("Side by side", Action::side_by_side, CompareMode::side_by_side);
  way("Flicker", Action::flicker, CompareMode::flicker);
  way("Flicker by hand", Action::flicker_turn, CompareMode::flicker);
  way("Difference", Action::difference, CompareMode::difference);
  way("FLIP", Action::flip, CompareMode::flip);
  const FilePicturePtr& compared = studio.development.against_file;
  Matching& matching = studio.development.matching;
  ImGui::MenuItem("Match exposure", "", &matching.exposure, compared != nullptr);
  note_item(studio.trace, "match exposure");
  help(
      "Gives the picture from a file the exposure at which it is least apart, and says which. Hides how far "
      "the light is off.");
  ImGui::MenuItem("Match background", "", &matching.background, compared && compared->picture.has_alpha);
  help("Puts this picture's background behind a file that has an alpha.");
  ImGui::Separator();
  item(studio, "Probe a pixel", Action::probe, true, studio.inspector.on);
  ImGui::MenuItem("Snapshots", "", &studio.show_snapshots);
  if (const FilePicturePtr& file = comparison.images.reference.picture()) {
    const bool is_it = comparison.kind == OtherKind::file;
    if (ImGui::MenuItem(("Compare with " + file->name).c_str(), "", is_it)) comparison.want_file();
    note_item(studio.trace, "compare with file");
  }
  if (ImGui::MenuItem("Compare with nothing", "", false, comparison.other != nullptr))
    comparison.keep(nullptr, "", OtherKind::none);
}

}  // namespace

void show_menu(Studio& studio) {
  if (!ImGui::BeginMainMenuBar()) return;
  graph::History& history = studio.session().history();
  if (ImGui::BeginMenu("Scene")) {
    item(studio, "New", Action::new_scene);
    item(studio, "Open...", Action::open_scene);
    if (ImGui::BeginMenu("Open recent")) {
      recent_menu(studio);
      ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("Begin with")) {
      for (const char* kind : {"ash", "cloud", "sandstorm", "explosion"})
        if (ImGui::MenuItem(kind)) studio.files.begin_anew(kind);
      ImGui::EndMenu();
    }
    if (ImGui::MenuItem("Import a volume...")) studio.ask_import = true;
    ImGui::Separator();
    item(studio, "Save", Action::save_scene);
    item(studio, "Save as...", Action::save_scene_as);
    ImGui::Separator();
    item(studio, "Playblast...", Action::playblast, !studio.playblast.is_running());
    if (ImGui::MenuItem("Stop the playblast", "", false, studio.playblast.is_running()))
      studio.playblast.cancel();
    ImGui::Separator();
    if (ImGui::MenuItem("Quit")) studio.wants_quit = true;
    of_plugins(studio, "Scene/");
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Edit")) {
    const auto undo = history.undo_names(), redo = history.redo_names();
    item(studio, with_name("Undo", undo, true).c_str(), Action::undo, !undo.empty());
    item(studio, with_name("Redo", redo, false).c_str(), Action::redo, !redo.empty());
    ImGui::Separator();
    item(studio, "Duplicate", Action::duplicate_nodes);
    item(studio, "Delete", Action::delete_nodes);
    ImGui::Separator();
    item(studio, "Find...", Action::palette);
    of_plugins(studio, "Edit/");
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Tools")) {
    const Tool tool = studio.tools.tool;
    item(studio, "Select", Action::tool_select, true, tool == Tool::select);
    item(studio, "Translate", Action::tool_translate, true, tool == Tool::translate);
    item(studio, "Rotate", Action::tool_rotate, true, tool == Tool::rotate);
    item(studio, "Scale", Action::tool_scale, true, tool == Tool::scale);
    ImGui::Separator();
    item(studio, "Its own axes", Action::axis_space, tool == Tool::translate || tool == Tool::rotate,
         studio.tools.space() == AxisSpace::local);
    of_plugins(studio, "Tools/");
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Create")) {
    create_menu(studio);
    of_plugins(studio, "Create/");
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Looks")) {
    looks_menu(studio);
    of_plugins(studio, "Looks/");
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("View")) {
    item(studio, "Frame selection", Action::frame_selection);
    item(studio, "Frame all", Action::frame_all);
    item(studio, "View before", Action::camera_back);
    item(studio, "View after", Action::camera_forth);
    item(studio, "Zoom in", Action::zoom_in);
    item(studio, "Zoom out", Action::zoom_out);
    item(studio, "Whole picture", Action::zoom_whole, studio.viewpoint.zoom.is_on());
    item(studio, "Scene camera", Action::scene_camera, true, !studio.viewpoint.look.free);
    ImGui::Separator();
    item(studio, "Fast", Action::quality_fast, true, studio.workspace.view().quality == "fast");
    item(studio, "High", Action::quality_high, true, studio.workspace.view().quality == "high");
    item(studio, "Full-range maps", Action::original_maps, true, studio.original_maps);
    ImGui::Separator();
    item(studio, "Figures", Action::toggle_display, true, studio.show_display);
    item(studio, "Panels", Action::toggle_panels, true, studio.show_panels);
    item(studio, "Node editor", Action::node_editor, true, studio.show_nodes && studio.show_panels);
    item(studio, "Hotkeys", Action::hotkey_list);
    of_plugins(studio, "View/");
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Compare")) {
    compare_menu(studio);
    of_plugins(studio, "Compare/");
    ImGui::EndMenu();
  }
  menus_of_plugins(studio);
  ImGui::EndMainMenuBar();
}

}  // namespace plinian::window
