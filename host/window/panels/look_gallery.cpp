// Small pictures to be clicked.
#include "host/window/panels/look_gallery.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "host/window/panels/overlay_text.h"
#include "host/window/panels/snapshot_strip.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

void put_on(Studio& studio, const std::string& look) {
  if (const graph::Node* medium = scene::medium_for_looks(studio.session().graph()))
    studio.run("preset apply " + graph::quote(look) + " " + medium->name);
}

void LookGallery::show(Studio& studio, const PaneRect& pane) {
  if (!studio.show_looks) {
    textures_.clear();
    asked_.clear();
    return;
  }
  const graph::Node* medium = scene::medium_for_looks(studio.session().graph());
  const ViewPicturePtr shown = studio.renderer.picture();
  // They are made where the hands and the picture are at rest.
  if (medium && shown && shown->at_rest && !studio.is_hand_on()) {
    std::string asks = fmt::format("{} {}", shown->number, words_of(studio.development));
    if (asks != asked_) studio.looks.update(shown->scene, studio.development.view);
    asked_ = std::move(asks);
  }
  const auto pictures = studio.looks.pictures();
  const float label = ImGui::GetTextLineHeight(), top = scaled(36);
  const float room = pane.size.y - top - scaled(60) - snapshot_strip_height(studio);
  // All of them are seen at once where there is any room for that.
  const float others = label + scaled(12), head = label + scaled(24);
  const float height = !pictures || pictures->empty()
                           ? scaled(LookPictures::height)
                           : std::clamp((room - head) / float(pictures->size()) - others, scaled(40),
                                        scaled(LookPictures::height));
  float widest = scaled(90);
  if (pictures)
    for (const LookPicture& look : *pictures)
      if (look.picture)
        widest = std::max(widest, height * float(look.picture->width) / float(look.picture->height));
  const float wanted = pictures ? float(pictures->size()) * (height + others) + head : scaled(70);
  const float width = widest + scaled(22) + (wanted > room ? ImGui::GetStyle().ScrollbarSize : 0.0f);
  ImGui::SetNextWindowPos({pane.begin.x + pane.size.x - width - scaled(8), pane.begin.y + top});
  ImGui::SetNextWindowSize({width, std::min(room, wanted)});
  ImGui::SetNextWindowBgAlpha(0.75f);
  ImGui::Begin("##looks", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::TextDisabled("%s", !medium ? "no medium" : pictures ? "Looks" : "making pictures ...");
  if (medium && pictures) {
    const auto* worn = std::get_if<std::string>(&medium->value(medium->schema->find("look")));
    for (const LookPicture& look : *pictures) {
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
        clicked = ImGui::Button(look.problem.empty() ? "..." : "no picture", {widest, height});
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
      ImGui::PopID();
      if (clicked) put_on(studio, look.look);
    }
  }
  ImGui::End();
}

}  // namespace plinian::window
