// A modal with a path, places and a list.
#include "host/window/panels/file_dialog.h"

#include <imgui.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace fs = std::filesystem;

void FileDialog::open(const std::string& title, const fs::path& folder, const std::string& name,
                      std::vector<std::string> extensions, bool saves) {
  title_ = title;
  extensions_ = std::move(extensions);
  saves_ = saves;
  opens_ = true;
  std::snprintf(name_, sizeof name_, "%s", name.c_str());
  if (folder_.empty() || !folder.empty()) go_to(folder.empty() ? fs::current_path() : folder);
}

void FileDialog::go_to(const fs::path& folder) {
  folder_ = fs::absolute(folder).lexically_normal();
  std::snprintf(path_, sizeof path_, "%s", folder_.c_str());
  entries_ = list_files(folder_, extensions_, &problem_);
}

std::optional<std::string> FileDialog::show() {
  if (title_.empty()) return std::nullopt;
  if (std::exchange(opens_, false)) ImGui::OpenPopup(title_.c_str());
  std::optional<std::string> chosen;
  ImGui::SetNextWindowSize({scaled(640), scaled(460)}, ImGuiCond_Appearing);
  const ImVec2 middle = ImGui::GetMainViewport()->GetCenter();
  ImGui::SetNextWindowPos(middle, ImGuiCond_Appearing, {0.5f, 0.5f});
  if (!ImGui::BeginPopupModal(title_.c_str(), nullptr, ImGuiWindowFlags_NoSavedSettings)) return chosen;
  const char* home = std::getenv("HOME");
  if (ImGui::Button("Up")) go_to(folder_.parent_path());
  ImGui::SameLine(0.0f, scaled(4));
  if (home && ImGui::Button("Home")) go_to(home);
  ImGui::SameLine(0.0f, scaled(4));
  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::InputText("##path", path_, sizeof path_, ImGuiInputTextFlags_EnterReturnsTrue)) {
    const fs::path typed(path_);
    if (fs::is_directory(typed))
      go_to(typed);
    else if (!typed.filename().empty()) {  // a whole path that was pasted
      std::snprintf(name_, sizeof name_, "%s", typed.filename().c_str());
      go_to(typed.parent_path());
    }
  }
  bool confirmed = false;
  ImGui::BeginChild("##files", {0.0f, -2.0f * ImGui::GetFrameHeightWithSpacing() - scaled(4)}, true);
  if (!problem_.empty())
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour::error), "%s", problem_.c_str());
  std::optional<fs::path> entered;
  for (const FileEntry& entry : entries_) {
    if (entry.is_folder) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    const bool clicked =
        ImGui::Selectable(entry.label.c_str(), entry.name == name_,
                          ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups);
    if (entry.is_folder) ImGui::PopStyleColor();
    if (!clicked) continue;
    if (entry.is_folder)
      entered = folder_ / entry.name;
    else
      std::snprintf(name_, sizeof name_, "%s", entry.name.c_str());
    if (!entry.is_folder && ImGui::IsMouseDoubleClicked(0)) confirmed = true;
  }
  if (entered) go_to(*entered);
  ImGui::EndChild();
  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  if (ImGui::InputTextWithHint("##name", "name", name_, sizeof name_, ImGuiInputTextFlags_EnterReturnsTrue))
    confirmed = true;
  if (ImGui::Button(saves_ ? "Save" : "Open", {scaled(90), 0.0f})) confirmed = true;
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {scaled(90), 0.0f}) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
    ImGui::CloseCurrentPopup();
  if (confirmed && name_[0] != 0) {
    fs::path path = fs::path(name_).is_absolute() ? fs::path(name_) : folder_ / name_;
    if (saves_ && path.extension().empty()) path += extensions_.front();
    chosen = path.string();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  return chosen;
}

}  // namespace plinian::window
