// Frames, file, go.
#include "host/window/panels/playblast_dialog.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cstdio>
#include <filesystem>
#include <utility>

#include "host/graph/model/conversion.h"
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
  if (const graph::Node* time = scene::first_of_type(studio.session().graph(), "time")) {
    first_ = int(number_of(*time, "start"));
    last_ = int(number_of(*time, "end"));
  }
  const std::string& scene = studio.session().scene_path();
  const std::string stem = scene.empty() ? "playblast" : fs::path(scene).stem().string();
  const std::string path =
      (studio.session().scene_folder() / (stem + (format_ == 2 ? "" : ".####") + extensions[format_]))
          .string();
  std::snprintf(path_, sizeof path_, "%s", path.c_str());
}

void PlayblastDialog::show(Studio& studio) {
  const char* title = "Playblast";
  if (std::exchange(opens_, false)) ImGui::OpenPopup(title);
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
  if (!ImGui::BeginPopupModal(
          title, nullptr,
          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
    return;
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
      fs::path path(path_);
      path.replace_extension(extensions[i]);
      std::snprintf(path_, sizeof path_, "%s", path.c_str());
    }
    if (!there) ImGui::EndDisabled();
  }
  ImGui::SetNextItemWidth(scaled(420));
  ImGui::InputText("##path", path_, sizeof path_);
  note_item(studio.trace, "playblast path");
  ImGui::Spacing();
  if (ImGui::Button("Render", {scaled(110), 0.0f})) {
    PlayblastSettings settings;
    settings.first = first_;
    settings.last = last_;
    settings.output = path_;
    settings.quality = studio.workspace.view().quality;
    settings.view = studio.development.view;
    if (const graph::Node* time = scene::first_of_type(studio.session().graph(), "time"))
      settings.rate = number_of(*time, "rate");
    studio.start_playblast(settings);
    ImGui::CloseCurrentPopup();
  }
  if (!ImGui::IsWindowAppearing()) note_item(studio.trace, "playblast render");
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {scaled(110), 0.0f}) ||
      ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
    ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace plinian::window
