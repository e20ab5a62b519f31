// Frames, file, go.
#include "host/window/panels/playblast_dialog.h"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>
#include <string_view>
#include <utility>

#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"
#include "host/window/files/typed_path.h"
#include "host/window/panels/path_field.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

constexpr const char* extensions[] = {".png", ".exr", ".mp4"};

double number_of(const graph::Node& node, const char* name) {
  return graph::number_of(node.value(node.schema->find(name)));
}

}  // namespace

void PlayblastDialog::open(Studio& studio) {
  opens_ = true;
  problem_.clear();
  problem_height_ = 0.0f;
  if (const graph::Node* time = scene::first_of_type(studio.session().graph(), "time")) {
    first_ = int(number_of(*time, "start"));
    last_ = int(number_of(*time, "end"));
  }
  const std::string& scene = studio.session().scene_path();
  const std::string stem = scene.empty() ? "playblast" : fs::path(scene).stem().string();
  path_ = (studio.session().scene_folder() / (stem + (format_ == 2 ? "" : ".####") + extensions[format_]))
              .string();
}

// What a path ends in says what is written; where it says nothing, what was chosen last.
void PlayblastDialog::set_path(const std::string& path) {
  path_ = path;
  problem_.clear();
  const std::string ends = fs::path(path).extension().string();
  const bool says_nothing =
      ends.size() < 2 || std::string_view("#%$").find(ends[1]) != std::string_view::npos;
  if (says_nothing && fs::path(path).has_filename()) path_ += extensions[format_];
  for (int i = 0; i < 3; ++i)
    if (ends == extensions[i] && (i < 2 || Playblast::has_ffmpeg())) format_ = i;
  if (path_.ends_with(".mp4")) path_ = as_format(path_, ".mp4");
}

// Begins it, or says why not.
void PlayblastDialog::render(Studio& studio) {
  PlayblastSettings settings;
  settings.first = first_;
  settings.last = last_;
  settings.quality = studio.workspace.view().quality;
  settings.view = studio.development.view;
  if (const graph::Node* time = scene::first_of_type(studio.session().graph(), "time"))
    settings.rate = number_of(*time, "rate");
  try {
    const fs::path folder = studio.session().scene_folder();
    settings.output = typed_path(path_, folder).value_or(folder / path_).string();
    problem_ = path_.empty() ? "playblast: name a file" : studio.start_playblast(settings);
  } catch (const graph::GraphError& error) {
    problem_ = std::string("playblast: ") + error.what();
  }
  if (!problem_.empty()) return studio.trace.note("playblast refused: " + problem_);
  ImGui::CloseCurrentPopup();
}

void PlayblastDialog::show_path(Studio& studio) {
  std::string whole;
  try {
    whole = typed_path(path_, studio.session().scene_folder()).value_or(path_).string();
  } catch (const graph::GraphError&) {
    // A variable that is not set; the browser opens where one was last.
  }
  ImGui::BeginGroup();
  const auto typed = path_field(studio,
                                {.name = "playblast",
                                 .typed = path_,
                                 .path = whole,
                                 .extensions = {extensions[format_]},
                                 .saves = true,
                                 .width = scaled(420)},
                                [this](const std::string& chosen) { set_path(chosen); });
  ImGui::EndGroup();
  note_item(studio.trace, "playblast path");
  if (typed) set_path(*typed);
}

// Its room stays: the button that is being pressed when it goes would move away from under the mouse.
void PlayblastDialog::show_problem() {
  if (problem_.empty()) {
    if (problem_height_ > 0.0f) ImGui::Dummy({0.0f, problem_height_});
    return;
  }
  ImGui::BeginGroup();
  ImGui::PushStyleColor(ImGuiCol_Text, colour::error);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + scaled(420));
  ImGui::TextUnformatted(problem_.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::Spacing();
  ImGui::EndGroup();
  problem_height_ = ImGui::GetItemRectSize().y;
}

bool PlayblastDialog::show(Studio& studio, FileDialog& browser) {
  const char* title = "Playblast";
  if (std::exchange(opens_, false)) ImGui::OpenPopup(title);
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
  if (!ImGui::BeginPopupModal(
          title, nullptr,
          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
    return false;
  const bool is_uppermost = !browser.is_open();
  const SceneSnapshot* scene = studio.feed.snapshot() ? &studio.feed.snapshot()->snapshot : nullptr;
  const float power = studio.development.view.gamma;
  const std::string gamma = power == 1.0f ? "" : fmt::format(", gamma {:.3g}", power);
  ImGui::TextDisabled("The scene's camera, %s, %s, exposure %+.2g%s%s",
                      studio.workspace.view().quality.c_str(), view_words(studio.development.view).c_str(),
                      double(studio.development.view.exposure), gamma.c_str(),
                      scene ? fmt::format(", {}x{}", scene->width, scene->height).c_str() : "");
  ImGui::SetNextItemWidth(scaled(90));
  ImGui::InputInt("##first", &first_, 0);
  note_item(studio.trace, "playblast first");
  ImGui::SameLine();
  ImGui::TextUnformatted("to");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(scaled(90));
  ImGui::InputInt("##last", &last_, 0);
  note_item(studio.trace, "playblast last");
  ImGui::SameLine();
  for (int i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0.0f, scaled(2));
    const bool there = i < 2 || Playblast::has_ffmpeg();
    if (!there) ImGui::BeginDisabled();
    if (toggle(extensions[i] + 1, format_ == i, there ? "" : "ffmpeg is not installed") && there) {
      format_ = i;
      path_ = as_format(path_, extensions[i]);
      problem_.clear();
    }
    if (!there) ImGui::EndDisabled();
  }
  show_path(studio);
  ImGui::Spacing();
  show_problem();
  if (ImGui::Button("Render", {scaled(110), 0.0f})) render(studio);
  if (!ImGui::IsWindowAppearing()) note_item(studio.trace, "playblast render");
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {scaled(110), 0.0f}) ||
      (is_uppermost && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))))
    ImGui::CloseCurrentPopup();
  browser.show(studio);
  ImGui::EndPopup();
  return true;
}

}  // namespace plinian::window
