// Thumbnails.
#include "host/window/panels/snapshot_strip.h"

#include <imgui.h>

#include <algorithm>

#include "host/window/panels/overlay_text.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

float label_width(const Snapshot& snapshot) {
  return ImGui::CalcTextSize(snapshot.name.c_str()).x + scaled(6);
}

constexpr float height_of_pictures = 54.0f;  // [points]

}  // namespace

float snapshot_strip_height(const Studio& studio) {
  if (!studio.show_snapshots || studio.snapshots.all().empty()) return 0.0f;
  return scaled(height_of_pictures) + ImGui::GetTextLineHeight() + scaled(14);
}

void SnapshotStrip::show(Studio& studio, const PaneRect& pane) {
  studio.snapshots.update();
  const auto& all = studio.snapshots.all();
  std::erase_if(textures_, [&](const auto& entry) { return !studio.snapshots.find(entry.first); });
  const float strip = snapshot_strip_height(studio);
  place_ = {};
  if (strip == 0.0f) return;
  const float height = scaled(height_of_pictures), label = ImGui::GetTextLineHeight();
  // Over the line that reads out the pixel.
  const float bottom = pane.begin.y + pane.size.y - label - scaled(14);
  ImGui::SetNextWindowBgAlpha(0.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
  // Where there is nothing, the picture beneath is what the mouse has.
  float width = 0.0f;
  for (const Snapshot& snapshot : all)
    if (snapshot.thumbnail)
      width += std::max(height * float(snapshot.thumbnail->width) / float(snapshot.thumbnail->height),
                        label_width(snapshot)) +
               scaled(10);
  width = std::min(pane.size.x - scaled(16), std::max(width, scaled(60)));
  place_ = {{pane.begin.x + pane.size.x - scaled(8) - width, bottom - strip}, {width, strip}};
  ImGui::SetNextWindowPos(to_im(place_.begin));
  ImGui::SetNextWindowSize(to_im(place_.size));
  ImGui::Begin("##snapshots", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleVar(2);  // tooltips and menus have their own
  std::string forget;
  for (const Snapshot& snapshot : all) {
    if (!snapshot.thumbnail) continue;
    std::unique_ptr<PictureTexture>& texture = textures_[snapshot.name];
    if (!texture) texture = std::make_unique<PictureTexture>();
    texture->show(snapshot.thumbnail);
    const float wide = height * float(snapshot.thumbnail->width) / float(snapshot.thumbnail->height);
    texture->filter({wide, height});
    const bool compared = studio.comparison.other == snapshot.picture;
    ImGui::PushID(snapshot.name.c_str());
    ImGui::BeginGroup();
    ImGui::PushStyleColor(ImGuiCol_Button, compared ? colour::accent : 0xff303030);
    if (ImGui::ImageButton(ImTextureID(std::intptr_t(texture->name())), {wide, height}, {0.0f, 0.0f},
                           {1.0f, 1.0f}, int(scaled(2)))) {
      if (compared) {
        studio.comparison.keep(nullptr, "", OtherKind::none);
      } else {
        studio.comparison.keep(snapshot.picture, snapshot.name, OtherKind::snapshot);
        if (studio.comparison.mode() == CompareMode::off) studio.comparison.set_mode(CompareMode::wipe);
      }
    }
    ImGui::PopStyleColor();
    studio.trace.item(snapshot.name, vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                      vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
    help(snapshot.name + ": " + snapshot.figures + "\nclick: compare; right click: more");
    if (ImGui::BeginPopupContextItem("more")) {
      ImGui::TextDisabled("%s", snapshot.name.c_str());
      if (ImGui::MenuItem("Restore its scene")) studio.run("restoreSnapshot " + graph::quote(snapshot.name));
      if (!ImGui::IsWindowAppearing())  // it is not yet where it will be
        studio.trace.item("restore " + snapshot.name,
                          vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                          vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
      if (ImGui::MenuItem("Forget it")) forget = snapshot.name;
      ImGui::EndPopup();
    }
    draw_text({ImGui::GetCursorScreenPos().x + scaled(3), ImGui::GetCursorScreenPos().y - scaled(2)},
              compared ? colour::accent : colour::faint_text, snapshot.name);
    ImGui::Dummy({std::max(wide + scaled(4), label_width(snapshot)), label});
    ImGui::EndGroup();
    ImGui::PopID();
    ImGui::SameLine(0.0f, scaled(4));
  }
  ImGui::End();
  if (!forget.empty()) {
    if (studio.comparison.name == forget) studio.comparison.keep(nullptr, "", OtherKind::none);
    studio.run("deleteSnapshot " + graph::quote(forget));
  }
}

}  // namespace plinian::window
