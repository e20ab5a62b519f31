// Small pictures to be clicked, all of them seen at once.
#include "host/window/panels/look_gallery.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "host/window/panels/overlay_text.h"
#include "host/window/panels/snapshot_strip.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

void put_on(Studio& studio, const std::string& look) {
  if (const graph::Node* medium = scene::medium_for_looks(studio.session().graph()))
    studio.run("preset apply " + graph::quote(look) + " " + medium->name);
}

PictureGrid picture_grid(int count, vec2 room, float aspect, float under, float gap, float narrowest,
                         float tallest) {
  PictureGrid best;
  for (int columns = 1; columns <= std::max(1, count); ++columns) {
    const int rows = (std::max(1, count) + columns - 1) / columns;
    const float width = (room.x - gap) / float(columns) - gap;
    if (columns > 1 && width < narrowest) break;
    const float height = std::min({room.y / float(rows) - under, width / aspect, tallest});
    if (height > best.height) best = {columns, std::floor(height)};
  }
  constexpr float least = 16.0f;
  best.height = std::max(best.height, least);
  return best;
}

namespace {

// In the upper right corner, on the line of the heading, which stays where the list scrolls.
void show_close(Studio& studio) {
  const float side = ImGui::GetTextLineHeight();
  const ImVec2 behind = ImGui::GetCursorPos();
  ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - side);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.0f, 0.0f));
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.0f, 0.0f, 0.0f, 0.0f));
  if (ImGui::Button("x##close", {side, side})) studio.show_looks = false;
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  note_item(studio.trace, "close the looks");
  help("Closes the gallery (" + text_of(studio.hotkeys.chord(Action::cancel)) + ").");
  ImGui::SetCursorPos(behind);
}

}  // namespace

void LookGallery::show(Studio& studio, const PaneRect& pane) {
  const ViewPicturePtr shown = studio.renderer.picture();
  const bool is_empty = shown && shown->scene.media.empty();
  if (is_empty) studio.looks.forget();
  if (is_empty || !studio.show_looks) {
    textures_.clear();
    asked_.clear();
  }
  if (!studio.show_looks) return;
  const graph::Node* medium = scene::medium_for_looks(studio.session().graph());
  // They are made where the hands and the picture are at rest.
  if (medium && shown && shown->at_rest && !studio.is_hand_on()) {
    std::string asks = fmt::format("{} {}", shown->number, words_of(studio.development));
    if (asks != asked_) studio.looks.update(shown->scene, studio.development.view);
    asked_ = std::move(asks);
  }
  const auto pictures = studio.looks.pictures();
  const float label = ImGui::GetTextLineHeight();
  // Beneath and over what is said in the picture's corners, where it is high enough for that.
  const float top = std::min(scaled(36), 0.08f * pane.size.y),
              under = std::min(scaled(60), 0.1f * pane.size.y);
  const float room = pane.size.y - top - under - snapshot_strip_height(studio);
  // All of them are seen at once where there is any room for that.
  const float others = label + scaled(14), head = label + scaled(24), gap = scaled(10);
  const int count = pictures ? int(pictures->size()) : 0;
  float aspect = 0.1f, narrowest = scaled(60);
  if (pictures)
    for (const LookPicture& look : *pictures) {
      if (look.picture) aspect = std::max(aspect, float(look.picture->width) / float(look.picture->height));
      narrowest = std::max(narrowest, ImGui::CalcTextSize(look.look.c_str()).x);
    }
  const PictureGrid grid = picture_grid(count, {pane.size.x * 0.8f, room - head}, aspect, others, gap,
                                        narrowest, scaled(LookPictures::height));
  const float height = grid.height, column = std::max(height * aspect + scaled(4), narrowest);
  const int rows = (count + grid.columns - 1) / grid.columns;
  const float wanted = pictures ? float(rows) * (height + others) + head : scaled(70);
  const float width = std::max(float(pictures ? grid.columns : 1) * (column + gap) + scaled(8), scaled(150)) +
                      (wanted > room ? ImGui::GetStyle().ScrollbarSize : 0.0f);
  ImGui::SetNextWindowPos({pane.begin.x + pane.size.x - width - scaled(8), pane.begin.y + top});
  ImGui::SetNextWindowSize({width, std::min(room, wanted)});
  ImGui::SetNextWindowBgAlpha(0.75f);
  ImGui::Begin("##looks", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::TextDisabled("%s", !medium ? "no medium" : pictures ? "Looks" : "making pictures ...");
  show_close(studio);
  if (medium && pictures) {
    const auto* worn = std::get_if<std::string>(&medium->value(medium->schema->find("look")));
    const float left = ImGui::GetCursorPosX(), begin = ImGui::GetCursorPosY();
    int place = 0;
    for (const LookPicture& look : *pictures) {
      ImGui::SetCursorPos({left + float(place % grid.columns) * (column + gap),
                           begin + float(place / grid.columns) * (height + others)});
      ++place;
      ImGui::BeginGroup();
      const bool is_worn = worn && *worn == look.look;
      ImGui::PushID(look.look.c_str());
      ImGui::PushStyleColor(ImGuiCol_Button, is_worn ? colour::accent : 0xff303030);
      ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(scaled(2), scaled(2)));
      bool clicked = false;
      if (look.picture) {
        std::unique_ptr<PictureTexture>& texture = textures_[look.look];
        if (!texture) texture = std::make_unique<PictureTexture>();
        texture->show(look.picture);
        const float wide = height * float(look.picture->width) / float(look.picture->height);
        texture->filter({wide, height});
        clicked = ImGui::ImageButton(ImTextureID(std::intptr_t(texture->name())), {wide, height});
      } else {
        clicked = ImGui::Button(look.problem.empty() ? "..." : "no picture", {column - scaled(4), height});
      }
      ImGui::PopStyleVar();
      ImGui::PopStyleColor();
      note_item(studio.trace, "look " + look.look);
      help(look.problem.empty()
               ? "Puts the look " + look.look + " on " + medium->name + "; Ctrl+Z takes it off again."
               : look.problem);
      ImGui::PushStyleColor(ImGuiCol_Text, is_worn ? colour::accent : colour::faint_text);
      ImGui::TextUnformatted(look.look.c_str());
      ImGui::PopStyleColor();
      ImGui::EndGroup();
      ImGui::PopID();
      if (clicked) put_on(studio, look.look);
    }
  }
  ImGui::End();
}

}  // namespace plinian::window
