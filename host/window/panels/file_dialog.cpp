// A modal around a FileBrowser.
#include "host/window/panels/file_dialog.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <utility>

#include "core/scene/resources.h"
#include "host/window/panels/typing.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

fs::path bookmark_file() {
  const fs::path folder = user_config_folder();
  return folder.empty() ? folder : folder / "bookmarks";
}

bool is_pressed(ImGuiKey key, bool repeats = true) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeats);
}

bool is_pasted() {
  const ImGuiIO& io = ImGui::GetIO();
  return (io.KeyCtrl && is_pressed(ImGuiKey_V)) || (io.KeyShift && is_pressed(ImGuiKey_Insert));
}

template <std::size_t N>
void put(char (&buffer)[N], const std::string& text) {
  std::snprintf(buffer, N, "%s", text.c_str());
}

}  // namespace

FileDialog::FileDialog(std::function<void()> wake) : browser_(std::move(wake)), places_(bookmark_file()) {}

void FileDialog::open(Studio& studio, FileQuestion question, std::function<void(const std::string&)> take) {
  const std::vector<std::string> recent = studio.files.recent.all();
  const std::string& open_scene = studio.session().scene_path();
  const fs::path scene = open_scene.empty() ? fs::path() : fs::path(open_scene).parent_path();
  fs::path& last = folders_[question.title];
  if (!question.saves && question.name.empty() && !last.empty())
    question.folder = last;
  else if (question.folder.empty() && last.empty() && !recent.empty())
    question.folder = fs::path(recent.front()).parent_path();
  else if (question.folder.empty())
    question.folder = last;
  places_.begin(scene, recent);
  browser_.begin(std::move(question));
  take_ = std::move(take);
  listed_.clear();
  opens_ = true;
}

void FileDialog::close() {
  folders_[browser_.question().title] = browser_.folder();
  is_open_ = false;
  ImGui::CloseCurrentPopup();
}

void FileDialog::take() {
  const auto path = browser_.take();
  if (!path) return table_.follow();
  close();
  take_(path->string());
}

void FileDialog::show(Studio& studio) {
  const char* title = browser_.question().title.c_str();
  if (std::exchange(opens_, false)) {
    ImGui::OpenPopup(title);
    is_open_ = true;
    focused_ = -2;
  }
  if (!is_open_) return;
  const ImVec2 room = ImGui::GetMainViewport()->Size;
  const ImVec2 most(room.x - scaled(32), room.y - scaled(32));
  const auto at_most = [&](float x, float y) {
    return ImVec2(std::min(scaled(x), most.x), std::min(scaled(y), most.y));
  };
  ImGui::SetNextWindowSizeConstraints(at_most(520, 300), most);
  ImGui::SetNextWindowSize(at_most(880, 520), ImGuiCond_Once);
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  if (!ImGui::BeginPopupModal(title, nullptr,
                              ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollbar |
                                  ImGuiWindowFlags_NoScrollWithMouse))
    return;
  if (browser_.update()) table_.follow();
  if (!browser_.is_reading() && listed_ != browser_.folder()) {
    listed_ = browser_.folder().string();
    studio.trace.note(fmt::format("folder {} lists {}", listed_, browser_.rows().size()));
  }
  take_keys();
  if (is_open_) {
    show_head(studio);
    show_list(studio);
    show_line(studio);
    show_foot(studio);
  }
  ImGui::EndPopup();
}

// Those that mean the list also while the name is typed in.
void FileDialog::take_keys() {
  if (is_pressed(ImGuiKey_Escape, false) && !path_active_) {
    if (browser_.overwrites().empty()) return close();
    browser_.keep_it();
  }
  if (path_active_) return;
  if (ImGui::GetIO().KeyAlt) {
    if (is_pressed(ImGuiKey_UpArrow, false)) browser_.go_up();
    return;
  }
  int rows = 0;
  if (is_pressed(ImGuiKey_DownArrow)) rows = 1;
  if (is_pressed(ImGuiKey_UpArrow)) rows = -1;
  if (is_pressed(ImGuiKey_PageDown)) rows = table_.page();
  if (is_pressed(ImGuiKey_PageUp)) rows = -table_.page();
  if (rows != 0) {
    browser_.step(rows);
    table_.follow();
  }
  if (browser_.text().empty() && is_pressed(ImGuiKey_Backspace, false)) browser_.go_up();
}

void FileDialog::show_head(Studio& studio) {
  if (ImGui::ArrowButton("##up", ImGuiDir_Up)) browser_.go_up();
  note_item(studio.trace, "file up");
  help("The folder above (Backspace where no name is typed, or Alt+Up).");
  ImGui::SameLine(0.0f, scaled(4));
  ImGui::SetNextItemWidth(-1.0f);
  if (!path_active_) put(path_, browser_.folder().string());
  const bool entered = ImGui::InputText("##path", path_, sizeof path_, ImGuiInputTextFlags_EnterReturnsTrue);
  path_active_ = ImGui::IsItemActive();
  note_item(studio.trace, "file path");
  if (!path_active_) help(browser_.folder().string());
  if (!entered) return;
  browser_.type(path_);
  take();
}

void FileDialog::show_list(Studio& studio) {
  const float foot = 2.0f * ImGui::GetFrameHeightWithSpacing() + scaled(2);
  const float height = std::max(scaled(60), ImGui::GetContentRegionAvail().y - foot);
  if (const auto place = places_.show(studio.trace, browser_.folder(), {scaled(176), height}))
    browser_.go_to(*place);
  ImGui::SameLine(0.0f, scaled(6));
  const FileTable::Doing doing =
      table_.show(studio.trace, browser_, {ImGui::GetContentRegionAvail().x, height});
  if (!doing.clicked) return;
  browser_.choose(*doing.clicked);
  if (doing.twice) take();
}

// What there is to be said, or to be asked.
void FileDialog::show_line(Studio& studio) {
  const ImVec2 begin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
  const bool asks = !browser_.overwrites().empty();
  FileBrowser::Line line =
      asks ? FileBrowser::Line{browser_.overwrites().filename().string() + " is there already.", false}
           : browser_.line();
  if (line.is_why_empty) line.text.clear();  // the list says it
  const float buttons = asks ? 2.0f * scaled(90) + 2.0f * scaled(8) : 0.0f;
  ImGui::PushClipRect(begin, {begin.x + width - buttons, begin.y + height}, true);
  ImGui::AlignTextToFramePadding();
  const unsigned ink = line.is_problem ? colour::error : asks ? colour::warning : colour::faint_text;
  ImGui::PushStyleColor(ImGuiCol_Text, ink);
  ImGui::TextUnformatted(line.text.c_str());
  ImGui::PopStyleColor();
  help(line.text);
  ImGui::PopClipRect();
  if (!asks) return;
  ImGui::SetCursorScreenPos({begin.x + width - buttons + scaled(8), begin.y});
  if (ImGui::Button("Overwrite", {scaled(90), 0.0f})) take();
  note_item(studio.trace, "file overwrite");
  ImGui::SameLine(0.0f, scaled(8));
  if (ImGui::Button("Keep it", {scaled(90), 0.0f})) browser_.keep_it();
  note_item(studio.trace, "file keep");
}

int FileDialog::edit(ImGuiInputTextCallbackData& data) {
  if (!std::exchange(reloads_, false)) return 0;
  data.DeleteChars(0, data.BufTextLen);
  data.InsertChars(0, name_);
  forget_typing();
  return 0;
}

void FileDialog::show_name(Studio& studio, float width) {
  // The keys are the name's unless another field has them.
  const bool free = !ImGui::IsAnyItemActive() && !ImGui::IsMouseDown(0);
  if (free && ImGui::GetFrameCount() - focused_ > 3) {
    ImGui::SetKeyboardFocusHere();
    expect_typing();
    focused_ = ImGui::GetFrameCount();
  }
  if (browser_.text() != name_) {
    put(name_, browser_.text());
    reloads_ = true;
  }
  const bool nobodys = !ImGui::IsAnyItemActive();
  ImGui::SetNextItemWidth(width);
  const char* hint = browser_.question().saves ? "name" : "a name to look for, or a path";
  bool entered = ImGui::InputTextWithHint(
      "##name", hint, name_, sizeof name_,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways,
      [](ImGuiInputTextCallbackData* data) { return static_cast<FileDialog*>(data->UserData)->edit(*data); },
      this);
  if (!ImGui::IsItemActive()) reloads_ = false;
  note_item(studio.trace, "file name");
  if (browser_.text() != name_) {
    browser_.type(name_, is_pasted());
    table_.follow();
  }
  // Also where the field has not got the keys back yet.
  entered |= nobodys && is_pressed(ImGuiKey_Enter, false);
  // One that is held down is no answer to what it brought up.
  if (entered && (browser_.overwrites().empty() || is_pressed(ImGuiKey_Enter, false))) take();
}

void FileDialog::show_foot(Studio& studio) {
  const float button = scaled(90), gap = scaled(8);
  show_name(studio, ImGui::GetContentRegionAvail().x - 2.0f * (button + gap));
  if (!is_open_) return;
  ImGui::SameLine(0.0f, gap);
  const bool saves = browser_.question().saves;
  ImGui::BeginDisabled(browser_.text().empty() && (saves || !browser_.chosen()));
  if (ImGui::Button(saves ? "Save" : "Open", {button, 0.0f})) take();
  ImGui::EndDisabled();
  note_item(studio.trace, "file take");
  ImGui::SameLine(0.0f, gap);
  if (ImGui::Button("Cancel", {button, 0.0f}) && is_open_) close();
  note_item(studio.trace, "file cancel");
}

}  // namespace plinian::window
