// The end of a path is what tells it from others.
#include "host/window/panels/path_field.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <filesystem>
#include <sstream>
#include <utility>

#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

// A text that has no room shows its beginning while it is edited, and else its end.
std::optional<std::string> field_of(const PathField& field, float width) {
  const float padding = ImGui::GetStyle().FramePadding.x, room = width - 2.0f * padding;
  const float length = ImGui::CalcTextSize(field.typed.c_str()).x;
  const bool ends = length > room && ImGui::GetActiveID() != ImGui::GetID("##value");
  const unsigned ink = ImGui::GetColorU32(ImGuiCol_Text);
  if (ends) ImGui::PushStyleColor(ImGuiCol_Text, 0u);
  std::optional<std::string> typed = text_field("##value", field.typed, width, field.enabled);
  if (!ends) return typed;
  ImGui::PopStyleColor();
  const ImVec2 begin = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushClipRect({begin.x + padding, begin.y}, {end.x - padding, end.y}, true);
  list.AddText({std::round(end.x - padding - length), begin.y + ImGui::GetStyle().FramePadding.y}, ink,
               field.typed.c_str());
  ImGui::PopClipRect();
  return typed;
}

}  // namespace

std::vector<std::string> file_widget(const std::string& widget) {
  std::istringstream words(widget);
  std::string word;
  words >> word;
  std::vector<std::string> extensions;
  if (word == "file")
    while (words >> word) extensions.push_back(word);
  return extensions;
}

std::optional<std::string> path_field(Studio& studio, const PathField& field,
                                      std::function<void(const std::string&)> take) {
  const float button = ImGui::GetFrameHeight(), gap = scaled(3);
  std::optional<std::string> typed = field_of(field, field.width - button - gap);
  ImGui::SameLine(0.0f, gap);
  ImGui::BeginDisabled(!field.enabled);
  if (ImGui::Button("...", {button, button})) {
    const fs::path path(field.path);
    studio.ask_file = FileWish{{.title = "Choose a file for " + field.name,
                                .folder = path.parent_path(),
                                .name = path.filename().string(),
                                .extensions = field.extensions,
                                .saves = field.saves},
                               std::move(take)};
  }
  ImGui::EndDisabled();
  note_item(studio.trace, field.name + " browse");
  help("Chooses it in the file browser.");
  return typed;
}

}  // namespace plinian::window
