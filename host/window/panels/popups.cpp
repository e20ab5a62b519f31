// Modal windows and lists.
#include "host/window/panels/popups.h"

#include <imgui.h>

#include <filesystem>
#include <utility>

#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

void at_the_middle() {
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
}

constexpr ImGuiWindowFlags plain =
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

}  // namespace

void show_unsaved_question(Studio& studio) {
  const char* title = "Unsaved changes";
  if (!studio.files.after_unsaved) return;
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  at_the_middle();
  if (!ImGui::BeginPopupModal(title, nullptr, plain)) return;
  if (ImGui::IsWindowAppearing()) studio.trace.note("question");
  const std::string& path = studio.session().scene_path();
  ImGui::Text("%s has changes that are not saved.",
              path.empty() ? "The scene" : std::filesystem::path(path).filename().c_str());
  ImGui::Spacing();
  const auto trace = [&](const char* name) {
    if (ImGui::IsWindowAppearing()) return;  // it is not yet where it will be
    studio.trace.item(name, vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                      vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
  };
  const ImVec2 size(scaled(110), 0.0f);
  if (ImGui::Button("Save", size)) {
    if (path.empty()) {  // a name first; then it may be asked for again
      studio.ask_save_as = true;
      studio.files.after_unsaved = nullptr;
    } else {
      studio.run("save");
      studio.commands.later(std::exchange(studio.files.after_unsaved, nullptr));
    }
    ImGui::CloseCurrentPopup();
  }
  trace("unsaved save");
  ImGui::SameLine();
  if (ImGui::Button("Discard", size)) {
    studio.commands.later(std::exchange(studio.files.after_unsaved, nullptr));
    ImGui::CloseCurrentPopup();
  }
  trace("unsaved discard");
  ImGui::SameLine();
  if (ImGui::Button("Cancel", size) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
    studio.files.after_unsaved = nullptr;
    ImGui::CloseCurrentPopup();
  }
  trace("unsaved cancel");
  ImGui::EndPopup();
}

void show_recovery(Studio& studio) {
  const char* title = "Not saved";
  if (studio.files.left_behind.empty()) return;
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  at_the_middle();
  if (!ImGui::BeginPopupModal(title, nullptr, plain)) return;
  const bool appears = ImGui::IsWindowAppearing();
  const Autosave::Left left = studio.files.left_behind.front();
  ImGui::Text(
      "%s was being edited when the program ended without saving.",
      left.scene_path.empty() ? "A new scene" : std::filesystem::path(left.scene_path).filename().c_str());
  ImGui::Spacing();
  const auto button = [&](const char* label, const char* name) {
    const bool pressed = ImGui::Button(label, {scaled(110), 0.0f});
    if (!appears)
      studio.trace.item(name, vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                        vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
    ImGui::SameLine();
    return pressed;
  };
  bool answered = true;
  if (button("Recover", "recovery recover")) {
    studio.files.recover(left);
    studio.files.left_behind.clear();  // the others are asked about next time
  } else if (button("Discard", "recovery discard")) {
    Autosave::discard(left);
    studio.files.left_behind.erase(studio.files.left_behind.begin());
  } else if (button("Later", "recovery later") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
    studio.files.left_behind.clear();
  } else {
    answered = false;
  }
  if (answered) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void show_hotkey_list(Studio& studio) {
  if (!studio.show_hotkeys) return;
  at_the_middle();
  ImGui::SetNextWindowBgAlpha(1.0f);
  ImGui::SetNextWindowSizeConstraints({scaled(430), 0.0f},
                                      {scaled(600), ImGui::GetMainViewport()->Size.y * 0.9f});
  if (ImGui::Begin("Hotkeys", &studio.show_hotkeys, plain | ImGuiWindowFlags_NoCollapse)) {
    std::string group = "Mouse";
    const auto row = [](const char* keys, const char* what) {
      ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour::accent), "%s", keys);
      ImGui::SameLine(scaled(170));
      ImGui::TextUnformatted(what);
    };
    heading("Mouse");
    row("Alt + left", "tumble (Ctrl+Alt where the desktop keeps Alt)");
    row("Alt + middle", "track");
    row("Alt + right, wheel", "dolly");
    row("drag a handle", "Ctrl in round steps, Shift slowly; Esc takes it back");
    row("drag a number", "Ctrl fine, Shift coarse; click to type, also *2, +=3");
    for (const Hotkey& hotkey : studio.hotkeys.all()) {
      if (hotkey.group != group) {
        ImGui::Spacing();
        heading(group = hotkey.group);
      }
      row((text_of(hotkey.chord) + (hotkey.is_held ? " + mouse" : "")).c_str(), hotkey.help.c_str());
    }
    ImGui::Spacing();
    ImGui::TextDisabled("~/.config/plinian/hotkeys changes them: a line 'undo Ctrl+Z' for each.");
  }
  ImGui::End();
}

void show_job(Studio& studio) {
  if (studio.commands.job.what.empty()) return;
  at_the_middle();
  ImGui::Begin("##job", nullptr, plain | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::TextUnformatted(studio.commands.job.what.c_str());
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, colour::accent);
  ImGui::ProgressBar(float(studio.commands.job.share), {scaled(260), scaled(6)}, "");
  ImGui::PopStyleColor();
  ImGui::TextDisabled("Esc cancels");
  ImGui::End();
}

}  // namespace plinian::window
