// Only the rows that are seen are drawn, however many there are.
#include "host/window/panels/file_table.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"
#include "host/window/platform/trace.h"

namespace plinian::window {

namespace {

// Names from the left, sizes and times up to the right. [points]
struct Columns {
  float begin, name_end, size_end, time_end;
};

Columns columns_of(float left, float width) {
  const float time_end = left + width - scaled(8), size_end = time_end - scaled(136);
  return {left + scaled(8), size_end - scaled(84), size_end, time_end};
}

// Told apart by shape alone: a folder has a tab, a file a folded corner, a sequence a second page behind it.
void draw_icon(ImDrawList* list, ImVec2 at, float side, FileEntry::Kind kind) {
  const float u = side / 14.0f;
  const auto point = [&](float x, float y) { return ImVec2(at.x + x * u, at.y + y * u); };
  const float thick = std::max(1.0f, std::round(u));
  if (kind == FileEntry::Kind::folder) {
    list->AddRectFilled(point(0.5f, 2), point(6, 5), colour::accent, u);
    list->AddRectFilled(point(0.5f, 4), point(13.5f, 12.5f), colour::accent, u);
    return;
  }
  const unsigned ink = 0xffb4b0ae;
  const auto page = [&](float x, float y) {
    const ImVec2 outline[] = {point(x, y), point(x + 5, y), point(x + 8, y + 3), point(x + 8, y + 10.5f),
                              point(x, y + 10.5f)};
    list->AddConvexPolyFilled(outline, 5, ImGui::GetColorU32(ImGuiCol_FrameBg));
    list->AddPolyline(outline, 5, ink, ImDrawFlags_Closed, thick);
  };
  if (kind == FileEntry::Kind::sequence) {
    page(4.5f, 0.5f);
    page(1.5f, 3);
  } else {
    page(3, 1.5f);
  }
}

void right_aligned(ImDrawList* list, float right, float y, unsigned ink, const std::string& text) {
  list->AddText({std::round(right - ImGui::CalcTextSize(text.c_str()).x), y}, ink, text.c_str());
}

void draw_row(const FileEntry& entry, ImVec2 at, float width, float height) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Columns columns = columns_of(at.x, width);
  const float side = scaled(14), left = columns.begin + side + scaled(8);
  const float y = std::round(at.y + (height - ImGui::GetTextLineHeight()) / 2);
  draw_icon(list, {columns.begin, std::round(at.y + (height - side) / 2)}, side, entry.kind);
  const std::string name = entry.name + (entry.is_folder() ? "/" : "");
  list->PushClipRect({left, at.y}, {columns.name_end, at.y + height}, true);
  list->AddText({left, y}, colour::text, name.c_str());
  if (entry.kind == FileEntry::Kind::sequence)
    list->AddText({left + ImGui::CalcTextSize(name.c_str()).x + scaled(10), y}, colour::faint_text,
                  range_text(entry).c_str());
  list->PopClipRect();
  if (!entry.is_folder())
    right_aligned(list, columns.size_end, y, colour::faint_text, size_text(entry.bytes));
  right_aligned(list, columns.time_end, y, colour::faint_text, time_text(entry.modified));
}

// All that a row says, where it is cut.
std::string whole(const FileEntry& entry) {
  std::string text = entry.name;
  if (entry.kind == FileEntry::Kind::sequence)
    text += "\n" + std::to_string(entry.count) + " files, " + range_text(entry);
  return text;
}

}  // namespace

void FileTable::show_headings(Trace& trace, FileBrowser& browser, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  const Columns columns = columns_of(at.x, width);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto heading = [&](const char* label, FileColumn column, float begin, float end, bool to_right) {
    ImGui::SetCursorScreenPos({begin, at.y});
    const bool pressed = ImGui::InvisibleButton(label, {end - begin, height});
    note_item(trace, std::string("file column ") + label);
    const bool on = browser.order().column == column;
    if (pressed) {
      // What is newest and what is largest is looked for first.
      browser.set_order({column, on ? !browser.order().descending : column != FileColumn::name});
      follow();
    }
    const unsigned ink = on || ImGui::IsItemHovered() ? colour::text : colour::faint_text;
    const float y = std::round(at.y + (height - ImGui::GetTextLineHeight()) / 2);
    const float text = ImGui::CalcTextSize(label).x, arrow = scaled(7);
    const float left = to_right ? std::round(end - text) : begin + scaled(8);
    list->AddText({left, y}, ink, label);
    if (!on) return;
    const float x = to_right ? left - arrow - scaled(6) : left + text + scaled(6);
    const float middle = std::round(at.y + height / 2), up = scaled(2);
    if (browser.order().descending)
      list->AddTriangleFilled({x, middle - up}, {x + arrow, middle - up}, {x + arrow / 2, middle + up}, ink);
    else
      list->AddTriangleFilled({x, middle + up}, {x + arrow, middle + up}, {x + arrow / 2, middle - up}, ink);
  };
  heading("Name", FileColumn::name, at.x, columns.name_end, false);
  heading("Size", FileColumn::size, columns.name_end, columns.size_end, true);
  heading("Modified", FileColumn::modified, columns.size_end + scaled(8), columns.time_end, true);
  const float right = at.x + ImGui::GetContentRegionMax().x;
  list->AddLine({at.x, at.y + height}, {right, at.y + height}, ImGui::GetColorU32(ImGuiCol_Border));
  ImGui::SetCursorScreenPos({at.x, at.y + height + 1.0f});
}

void FileTable::scroll_to(const FileBrowser& browser, float row_height) {
  const float view = ImGui::GetWindowHeight(), top = ImGui::GetScrollY();
  page_ = std::max(1, int(view / row_height) - 1);
  if (!std::exchange(follows_, false)) return;
  const float begin = browser.chosen() ? row_height * float(*browser.chosen()) : 0.0f;
  if (begin < top || !browser.chosen())
    ImGui::SetScrollY(begin);
  else if (begin + row_height > top + view)
    ImGui::SetScrollY(begin + row_height - view);
}

FileTable::Doing FileTable::show(Trace& trace, FileBrowser& browser, vec2 size) {
  Doing doing;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetColorU32(ImGuiCol_WindowBg));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::BeginChild("##table", {size.x, size.y}, true, ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar();  // tooltips have their own
  const float width = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
  show_headings(trace, browser, width);
  ImGui::BeginChild("##rows", {0.0f, 0.0f}, false);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
  ImGui::BeginDisabled(browser.is_reading());
  const float height = ImGui::GetTextLineHeight() + scaled(7);
  scroll_to(browser, height);
  ImGuiListClipper clipper;
  clipper.Begin(int(browser.rows().size()), height);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const FileEntry& entry = browser.rows()[std::size_t(i)];
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::PushID(i);
      if (list_row("##row", browser.chosen() == std::size_t(i), height)) {
        doing.clicked = std::size_t(i);
        doing.twice = ImGui::IsMouseDoubleClicked(0);
      }
      ImGui::PopID();
      note_item(trace, "file " + entry.name);
      help(whole(entry));
      draw_row(entry, at, width, height);
    }
  clipper.End();
  if (const FileBrowser::Line line = browser.line(); line.is_why_empty) {
    ImGui::SetCursorPos({scaled(8), scaled(6)});
    ImGui::PushTextWrapPos(width - scaled(8));
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(line.is_problem ? colour::error : colour::faint_text),
                       "%s", line.text.c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::EndDisabled();
  ImGui::PopStyleVar();
  ImGui::EndChild();
  ImGui::EndChild();
  ImGui::PopStyleColor();
  return doing;
}

}  // namespace plinian::window
