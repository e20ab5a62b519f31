// Every entry is an action of the hotkeys or a command.
#include "host/window/panels/menu.h"

#include <fmt/format.h>
#include <imgui.h>

#include "host/scene/looks.h"
#include "host/window/fields/arithmetic.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

void item(Studio& studio, const char* label, Action action, bool enabled = true, bool on = false) {
  const std::string keys = text_of(studio.hotkeys.chord(action));
  if (ImGui::MenuItem(label, keys == "none" ? "" : keys.c_str(), on, enabled)) studio.act(action);
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
  const graph::Graph& graph = studio.session().graph();
  const graph::Node* medium = nullptr;
  for (const graph::NodeId id : graph.selection())
    if (graph.find(id)->type->name() == "medium") medium = graph.find(id);
  if (!medium) medium = scene::first_of_type(graph, "medium");
  if (!medium) {
    ImGui::TextDisabled("the scene has no medium");
    return;
  }
  ImGui::TextDisabled("put on %s", medium->name.c_str());
  for (const std::string& look : scene::look_names())
    if (ImGui::MenuItem(look.c_str())) studio.run("preset apply " + graph::quote(look) + " " + medium->name);
}

}  // namespace

void show_menu(Studio& studio) {
  if (!ImGui::BeginMainMenuBar()) return;
  graph::History& history = studio.session().history();
  if (ImGui::BeginMenu("Scene")) {
    item(studio, "New", Action::new_scene);
    item(studio, "Open...", Action::open_scene);
    if (ImGui::BeginMenu("Begin with")) {
      for (const char* kind : {"ash", "cloud", "sandstorm", "explosion"})
        if (ImGui::MenuItem(kind))
          studio.unless_unsaved([&studio, kind] {
            studio.session().execute("newScene -force");
            studio.look = {};
            studio.begin_with(kind);
          });
      ImGui::EndMenu();
    }
    ImGui::Separator();
    item(studio, "Save", Action::save_scene);
    item(studio, "Save as...", Action::save_scene_as);
    ImGui::Separator();
    if (ImGui::MenuItem("Quit")) studio.wants_quit = true;
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Edit")) {
    const auto undo = history.undo_names(), redo = history.redo_names();
    item(studio, with_name("Undo", undo, true).c_str(), Action::undo, !undo.empty());
    item(studio, with_name("Redo", redo, false).c_str(), Action::redo, !redo.empty());
    ImGui::Separator();
    item(studio, "Duplicate", Action::duplicate_nodes);
    item(studio, "Delete", Action::delete_nodes);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Create")) {
    create_menu(studio);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Looks")) {
    looks_menu(studio);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("View")) {
    item(studio, "Frame selection", Action::frame_selection);
    item(studio, "Frame all", Action::frame_all);
    item(studio, "View before", Action::camera_back);
    item(studio, "View after", Action::camera_forth);
    item(studio, "Scene camera", Action::scene_camera, true, !studio.look.free);
    ImGui::Separator();
    item(studio, "Fast", Action::quality_fast, true, studio.workspace.view().quality == "fast");
    item(studio, "High", Action::quality_high, true, studio.workspace.view().quality == "high");
    item(studio, "Full-range maps", Action::original_maps, true, studio.original_maps);
    ImGui::Separator();
    item(studio, "Figures", Action::toggle_display, true, studio.show_display);
    item(studio, "Panels", Action::toggle_panels, true, studio.show_panels);
    item(studio, "Hotkeys", Action::hotkey_list);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Compare")) {
    item(studio, "Keep this picture", Action::snapshot_picture);
    item(studio, "Render the reference", Action::reference);
    if (ImGui::MenuItem("Stop the reference", "", false, studio.reference_share().has_value()))
      studio.stop_reference();
    ImGui::Separator();
    item(studio, "Wipe", Action::wipe, studio.kept != nullptr, studio.wipes);
    item(studio, "Difference", Action::difference, studio.kept != nullptr, studio.development.difference);
    if (ImGui::MenuItem("Forget it", "", false, studio.kept != nullptr)) studio.keep_picture(nullptr, "");
    ImGui::EndMenu();
  }
  ImGui::EndMainMenuBar();
}

void show_view_strip(Studio& studio, const PaneRect& pane) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(8), scaled(4)));
  begin_pane("##strip", pane, false);
  ImGui::PopStyleVar();
  const std::string& quality = studio.workspace.view().quality;
  const auto trace = [&](const char* name) {
    studio.trace.item(name, vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                      vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
  };
  if (toggle("fast", quality == "fast", "The quality set fast (1).")) studio.act(Action::quality_fast);
  trace("fast");
  ImGui::SameLine(0.0f, scaled(2));
  if (toggle("high", quality == "high", "The quality set high (2).")) studio.act(Action::quality_high);
  trace("high");
  ImGui::SameLine(0.0f, scaled(14));

  Development& how = studio.development;
  FieldLook look;
  look.width = scaled(104);
  look.prefix = "exp";
  look.unit = "stops";
  look.changed = how.view.exposure != 0.0f;
  NumberRange stops;
  stops.soft_minimum = -8.0;
  stops.soft_maximum = 8.0;
  const FieldEdit edit = number_field("##exposure", how.view.exposure, stops, look);
  trace("exposure");
  help("Exposure of the display. No part of the scene.");
  if (edit.dragged) how.view.exposure = float(*edit.dragged);
  if (edit.typed)
    if (const auto typed = typed_number(*edit.typed, how.view.exposure)) how.view.exposure = float(*typed);
  if (look.changed) {
    ImGui::SameLine(0.0f, scaled(2));
    ImGui::PushStyleColor(ImGuiCol_Text, colour::changed);
    if (ImGui::Button("0")) how.view.exposure = 0.0f;
    ImGui::PopStyleColor();
    help("The exposure is off its default; click to put it back.");
  }
  ImGui::SameLine(0.0f, scaled(6));
  static const char* const views[] = {"sRGB", "filmic", "OCIO"};
  ImGui::SetNextItemWidth(scaled(84));
  if (ImGui::BeginCombo("##view", views[int(how.view.view)])) {
    for (int i = 0; i < 3; ++i)
      if (ImGui::Selectable(views[i], int(how.view.view) == i)) how.view.view = View(i);
    ImGui::EndCombo();
  }
  help("How linear radiance is turned into what the display shows.");
  ImGui::SameLine(0.0f, scaled(6));
  ImGui::SetNextItemWidth(scaled(92));
  if (ImGui::BeginCombo("##layer", how.layer.empty() ? "beauty" : how.layer.c_str())) {
    for (const char* layer : {"beauty", "alpha", "depth", "ambient", "emission"}) {
      const bool beauty = std::string(layer) == "beauty";
      if (ImGui::Selectable(layer, beauty ? how.layer.empty() : how.layer == layer))
        how.layer = beauty ? "" : layer;
    }
    ImGui::EndCombo();
  }
  help("The layer that is seen.");
  ImGui::SameLine(0.0f, scaled(14));
  if (toggle(studio.look.free ? "free camera" : "scene camera", !studio.look.free,
             "Look through the scene's camera (C). Moving the view leaves to a free one."))
    studio.look_through_scene_camera();
  if (studio.kept) {
    ImGui::SameLine(0.0f, scaled(6));
    if (toggle("wipe", studio.wipes, "Wipe between the picture and the one kept (Shift+W); drag the line."))
      studio.act(Action::wipe);
    ImGui::SameLine(0.0f, scaled(2));
    if (toggle("diff", studio.development.difference, "How far it is from the one kept (Shift+D)."))
      studio.act(Action::difference);
  }
  if (studio.original_maps) {
    ImGui::SameLine(0.0f, scaled(6));
    if (toggle("full-range maps", true,
               "The original method instead of adaptive maps (T), for this view only."))
      studio.act(Action::original_maps);
  }
  if (!how.solo.empty() || how.solo_ambient) {
    ImGui::SameLine(0.0f, scaled(6));
    ImGui::PushStyleColor(ImGuiCol_Text, colour::changed);
    if (ImGui::Button("solo")) {
      how.solo.clear();
      how.solo_ambient = false;
    }
    ImGui::PopStyleColor();
    help("Lights are seen alone; click to see everything.");
  }
  end_pane();
}

void show_status(Studio& studio, const PaneRect& pane) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(10), scaled(2)));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetColorU32(ImGuiCol_MenuBarBg));
  begin_pane("##status", pane, false);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ImGui::AlignTextToFramePadding();
  float right = pane.begin.x + pane.size.x;
  const ViewPicturePtr picture = studio.renderer.picture();
  if (picture) {
    const std::string text = fmt::format(
        "{}   {} x {}   {}", picture->scene.quality.name, picture->frame.width, picture->frame.height,
        picture->quick     ? "quick"
        : picture->at_rest ? fmt::format("at rest, {} passes", picture->passes)
                           : fmt::format("pass {}", picture->passes));
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    right -= width + scaled(30);
    ImGui::SetCursorPosX(pane.size.x - width - scaled(10));
    ImGui::TextDisabled("%s", text.c_str());
    ImGui::SameLine(scaled(10));
  }
  // What there is to say on the left gives way to what the picture is.
  ImGui::PushClipRect({pane.begin.x, pane.begin.y}, {right, pane.begin.y + pane.size.y}, true);
  const auto& lines = studio.console.lines();
  if (!studio.job.what.empty()) {
    ImGui::Text("%s  %.0f %%", studio.job.what.c_str(), 100.0 * studio.job.share);
    ImGui::SameLine();
    ImGui::TextDisabled("Esc cancels");
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
        "Alt+mouse (or Ctrl+Alt): left tumbles, middle tracks, right or wheel dollies    F frame   "
        "A all   1 fast   2 high   L+drag turns the key light   F1 hotkeys");
  }
  ImGui::PopClipRect();
  end_pane();
}

}  // namespace plinian::window
