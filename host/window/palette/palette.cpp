// A field, a list, four keys.
#include "host/window/palette/palette.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/resources.h"
#include "host/window/hotkeys/actions.h"
#include "host/window/palette/attribute_entries.h"
#include "host/window/palette/menu_entries.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

constexpr const char* popup = "##palette";
constexpr std::size_t most_recent = 20;
constexpr std::size_t most_rows = 200;  // that anybody would scroll through

fs::path recent_file() {
  const fs::path folder = user_state_folder();
  return folder.empty() ? folder : folder / "palette";
}

bool is_pressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

void begin_line(Studio& studio, const std::string& text) {
  act(studio, Action::console_line);
  studio.show_panels = true;
  studio.typed_ahead = text;
}

unsigned colour_of(const std::string& kind) {
  if (kind == "action") return colour::accent;
  if (kind == "node") return colour::good;
  if (kind == "attribute") return colour::played;
  if (kind == "look") return colour::changed;
  return colour::faint_text;
}

}  // namespace

Palette::Palette() : recent_(recent_file(), most_recent) {}

void Palette::begin(Studio& studio) {
  entries_ = palette_entries(studio.session(), studio.hotkeys, studio.workspace.plugins().menu());
  for (PaletteEntry& entry : menu_entries()) entries_.push_back(std::move(entry));
  query_[0] = 0;
  shown_query_.clear();
  find(studio);
  chosen_ = 0;
  ImGui::OpenPopup(popup);
}

// Of attributes there are too many to hold them all ready.
void Palette::find(Studio& studio) {
  const graph::Graph& graph = studio.session().graph();
  const std::vector<std::string> recent = recent_.all();
  std::vector<PaletteEntry> attributes = attribute_entries(graph, query_, most_rows);
  constexpr std::string_view kind = "attribute ";
  if (query_[0] == 0)
    for (const std::string& id : recent)
      if (id.starts_with(kind))
        if (auto entry = attribute_entry(graph, id.substr(kind.size())))
          attributes.push_back(std::move(*entry));
  found_ = matching(entries_, query_, recent, attributes, most_rows);
}

// Round at neither end: one who holds the key down stays there.
void Palette::step() {
  const std::size_t count = found_.size(), before = chosen_;
  constexpr std::size_t page = 10;
  if (is_pressed(ImGuiKey_DownArrow)) ++chosen_;
  if (is_pressed(ImGuiKey_UpArrow) && chosen_ > 0) --chosen_;
  if (is_pressed(ImGuiKey_PageDown)) chosen_ += page;
  if (is_pressed(ImGuiKey_PageUp)) chosen_ -= std::min(chosen_, page);
  chosen_ = count == 0 ? 0 : std::min(chosen_, count - 1);
  moved_ = chosen_ != before;
}

void Palette::show_row(Studio& studio, const PaletteEntry& entry, std::size_t row) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
  ImGui::PushID(int(row));
  ImGui::Selectable("##row", row == chosen_, ImGuiSelectableFlags_DontClosePopups, {0.0f, height});
  note_item(studio.trace, "palette " + entry.id());
  if (moved_ && row == chosen_) ImGui::SetScrollHereY(0.5f);
  ImGui::PopID();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float y = at.y + (height - ImGui::GetTextLineHeight()) / 2;
  const float kind_width = scaled(76), keys_width = ImGui::CalcTextSize(entry.keys.c_str()).x;
  list->AddText({at.x + scaled(4), y}, colour_of(entry.kind), entry.kind.c_str());
  const float title = at.x + kind_width;
  const float right = at.x + width - scaled(6) - (keys_width > 0.0f ? keys_width + scaled(12) : 0.0f);
  list->PushClipRect({title, at.y}, {right, at.y + height}, true);
  list->AddText({title, y}, colour::text, entry.title.c_str());
  const float behind = title + ImGui::CalcTextSize(entry.title.c_str()).x + scaled(12);
  list->AddText({behind, y}, colour::faint_text, entry.detail.c_str());
  list->PopClipRect();
  list->AddText({at.x + width - scaled(6) - keys_width, y}, colour::accent, entry.keys.c_str());
}

std::optional<Action> Palette::choose(Studio& studio, const PaletteEntry& entry) {
  recent_.add(entry.id());
  studio.show_palette = false;
  ImGui::CloseCurrentPopup();
  if (entry.action) return entry.action;
  if (entry.act) {
    entry.act(studio);
    return std::nullopt;
  }
  if (!entry.field.empty()) {
    // One that is shown with others stays with them: all are edited.
    const graph::Graph& graph = studio.session().graph();
    const auto& selection = graph.selection();
    if (selection.empty() || "select " + graph.find(selection.back())->name != entry.line)
      studio.run(entry.line);
    studio.show_panels = true;
    field_ = entry.field;
  } else if (entry.is_open)
    begin_line(studio, entry.line + " ");
  else
    studio.commands.run(entry.line, "", true);
  return std::nullopt;
}

std::optional<Action> Palette::show(Studio& studio) {
  if (!studio.show_palette) {
    is_open_ = false;
    return std::nullopt;
  }
  const bool appears = !std::exchange(is_open_, true);
  if (appears) begin(studio);
  const ImVec2 room = ImGui::GetMainViewport()->Size;
  // As high as what is found, up to where it scrolls; its upper edge stays.
  const ImGuiStyle& style = ImGui::GetStyle();
  const float row = ImGui::GetFrameHeight(), most = std::min(scaled(420), room.y * 0.7f);
  const float rows = float(std::max<std::size_t>(1, found_.size())) * row;
  const ImVec2 size(std::min(scaled(620), room.x - scaled(40)),
                    std::min(most, row + style.ItemSpacing.y + rows + 2.0f * style.WindowPadding.y));
  ImGui::SetNextWindowPos({std::floor((room.x - size.x) / 2), std::floor(room.y * 0.12f)});
  ImGui::SetNextWindowSize(size);
  if (!ImGui::BeginPopup(popup, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    studio.show_palette = is_open_ = false;
    return std::nullopt;
  }
  studio.trace.item("palette window", {ImGui::GetWindowPos().x, ImGui::GetWindowPos().y}, {size.x, size.y});
  step();
  if (appears) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered =
      ImGui::InputTextWithHint("##query", "an action, a command, a node, an attribute, a look", query_,
                               sizeof query_, ImGuiInputTextFlags_EnterReturnsTrue);
  note_item(studio.trace, "palette");
  if (shown_query_ != query_) {
    shown_query_ = query_;
    find(studio);
    chosen_ = 0;
    moved_ = true;
    studio.trace.note("palette finds " + (found_.empty() ? "nothing" : found_.front().id()));
  }
  std::optional<std::size_t> taken;
  if (entered && chosen_ < found_.size()) taken = chosen_;
  ImGui::BeginChild("##found");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
  for (std::size_t row = 0; row < found_.size(); ++row) {
    show_row(studio, found_[row], row);
    if (ImGui::IsItemClicked()) taken = row;
  }
  ImGui::PopStyleVar();
  if (found_.empty()) ImGui::TextDisabled("nothing is called so");
  ImGui::EndChild();
  std::optional<Action> action;
  if (taken)
    action = choose(studio, found_[*taken]);
  else if (is_pressed(ImGuiKey_Escape)) {
    studio.show_palette = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  return action;
}

}  // namespace plinian::window
