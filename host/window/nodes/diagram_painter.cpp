// Wires first, boxes over them, plugs last.
#include "host/window/nodes/diagram_painter.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "host/window/nodes/node_colours.h"
#include "host/window/panels/overlay_text.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

constexpr unsigned body_colour = 0xff35302e, header_colour = 0xff453f3c, edge_colour = 0xff1c1918;
constexpr unsigned dim_text = 0xffa8a29e, unfit_colour = 0xff55504d;

unsigned with_alpha(unsigned colour, unsigned alpha) {
  return (colour & 0x00ffffffu) | alpha << 24;
}

class Painter {
 public:
  Painter(ImDrawList& list, const graph::Graph& graph, const Diagram& diagram, const DiagramLook& look)
      : list_(list), graph_(graph), diagram_(diagram), look_(look), zoom_(look.view.zoom) {}

  void run() {
    // Smaller than this, rows are of no use.
    constexpr float least_text = 7.5f, size = 13.0f;
    shows_rows_ = size * zoom_ >= scaled(least_text);
    // Words stay readable as long as their rows have the height for it.
    text_size_ = std::max(size * zoom_, std::min(scaled(11), row_height * zoom_));
    for (const Lineage& lineage : diagram_.lineages) draw_lineage(lineage);
    for (const Wire& wire : diagram_.wires) draw(wire);
    for (std::size_t b = 0; b < diagram_.boxes.size(); ++b)
      if (is_seen(diagram_.boxes[b])) draw_box(b);
  }

 private:
  vec2 at(vec2 canvas) const { return look_.corner + look_.view.to_pane(canvas); }

  bool is_seen(const NodeBox& box) const {
    const vec2 begin = look_.view.to_pane(box.place), end = look_.view.to_pane(box.place + size_of(box));
    return end.x > 0.0f && end.y > 0.0f && begin.x < look_.size.x && begin.y < look_.size.y;
  }

  bool is_selected(std::size_t box) const { return look_.selected.contains(diagram_.boxes[box].id); }

  void draw_lineage(const Lineage& lineage) {
    const NodeBox &parent = diagram_.boxes[lineage.parent], &child = diagram_.boxes[lineage.child];
    const vec2 from = at(parent.place + vec2(box_width, header_height / 2));
    const vec2 to = at(child.place + vec2(0.0f, header_height / 2));
    const float steps = std::max(4.0f, glm::distance(from, to) / scaled(7));
    const bool hot = is_selected(lineage.parent) || is_selected(lineage.child);
    for (float i = 0.0f; i < steps; i += 1.0f)  // dashes
      list_.AddLine(to_im(glm::mix(from, to, i / steps)), to_im(glm::mix(from, to, (i + 0.5f) / steps)),
                    with_alpha(dim_text, hot ? 0xc0 : 0x60), std::max(1.0f, zoom_));
  }

  void draw(const Wire& wire) {
    const NodeBox &from = diagram_.boxes[wire.from_box], &to = diagram_.boxes[wire.to_box];
    const bool hot = is_selected(wire.from_box) || is_selected(wire.to_box);
    const unsigned colour = plug_colour(graph_.attribute(from.rows[wire.from_row].plug).spec.type);
    draw_wire(list_, at(plug_place(from, wire.from_row, true)), at(plug_place(to, wire.to_row, false)),
              with_alpha(colour, look_.fits ? 0x50
                                 : hot      ? 0xff
                                            : 0xa0),
              std::max(1.0f, (hot ? 2.2f : 1.6f) * zoom_));
  }

  // What is too long is cut, with two dots.
  void text(ImFont* font, float size, vec2 place, float width, unsigned colour, std::string words) {
    const auto length = [&] { return font->CalcTextSizeA(size, 1e6f, 0.0f, words.c_str()).x; };
    if (length() > width && words.size() > 2) {
      words += "..";
      while (length() > width && words.size() > 3) words.erase(words.size() - 3, 1);
    }
    list_.AddText(font, size, to_im(place), colour, words.c_str());
  }

  void draw_box(std::size_t b) {
    const NodeBox& box = diagram_.boxes[b];
    const vec2 begin = at(box.place), end = at(box.place + size_of(box));
    const float round = 4.0f * zoom_, header = header_height * zoom_;
    const bool hot = look_.hot.part != DiagramPart::nothing && look_.hot.box == b;
    list_.AddRectFilled(to_im(begin + 3.0f * zoom_), to_im(end + 3.0f * zoom_), 0x50000000, round);
    list_.AddRectFilled(to_im(begin), to_im(end), body_colour, round);
    list_.AddRectFilled(to_im(begin), {end.x, begin.y + header}, header_colour, round,
                        box.rows.empty() ? 0 : ImDrawFlags_RoundCornersTop);
    list_.AddRectFilled(to_im(begin), {begin.x + 5.0f * zoom_, begin.y + header}, node_colour(box.type),
                        round,
                        box.rows.empty() ? ImDrawFlags_RoundCornersLeft : ImDrawFlags_RoundCornersTopLeft);
    draw_header(box, begin);
    const int failure = look_.failure ? look_.failure(box.id) : 0;
    const unsigned edge = is_selected(b) ? colour::accent
                          : failure == 2 ? colour::error
                          : hot          ? dim_text
                                         : edge_colour;
    list_.AddRect(to_im(begin), to_im(end), edge, round, 0, is_selected(b) || failure == 2 ? 2.0f : 1.0f);
    if (failure) draw_badge(vec2(end.x, begin.y), failure);
    for (std::size_t r = 0; r < box.rows.size(); ++r) draw_row(b, r);
  }

  void draw_header(const NodeBox& box, vec2 begin) {
    const float height = header_height * zoom_;
    const float size = std::max(text_size_, std::min(scaled(11), height));
    const bool opens = box.open || box.has_more;
    const float room = (box_width - 12.0f - (opens && shows_rows_ ? header_height : 4.0f)) * zoom_;
    if (size >= scaled(6))
      text(fonts().bold, size, begin + vec2(11.0f * zoom_, (height - size) / 2), room, colour::text,
           box.name);
    if (!opens || !shows_rows_) return;
    const vec2 middle = begin + vec2(box_width - header_height / 2, header_height / 2) * zoom_;
    const float r = 4.0f * zoom_;
    if (box.open)
      list_.AddTriangleFilled({middle.x - r, middle.y - r / 2}, {middle.x + r, middle.y - r / 2},
                              {middle.x, middle.y + r}, dim_text);
    else
      list_.AddTriangleFilled({middle.x - r / 2, middle.y - r}, {middle.x + r, middle.y},
                              {middle.x - r / 2, middle.y + r}, dim_text);
  }

  // Stands out of the corner, so that it is seen however far one zooms out.
  void draw_badge(vec2 corner, int failure) {
    const float r = std::max(scaled(6), 8.0f * zoom_);
    list_.AddCircleFilled(to_im(corner), r, failure == 2 ? colour::error : colour::warning);
    const ImVec2 size = fonts().bold->CalcTextSizeA(1.6f * r, 1e6f, 0.0f, "!");
    list_.AddText(fonts().bold, 1.6f * r, {corner.x - size.x / 2, corner.y - size.y / 2}, 0xff201c1a, "!");
  }

  void draw_row(std::size_t b, std::size_t r) {
    const NodeBox& box = diagram_.boxes[b];
    const PlugRow& row = box.rows[r];
    const bool fits =
        !look_.fits || (row.takes && look_.fits(row, false)) || (row.gives && look_.fits(row, true));
    const vec2 left = at(plug_place(box, r, false)), right = at(plug_place(box, r, true));
    const bool hot =
        look_.hot.box == b && look_.hot.row == r &&
        (look_.hot.part == DiagramPart::taking_plug || look_.hot.part == DiagramPart::giving_plug);
    if (shows_rows_) {
      const float top = left.y - text_size_ / 2, pad = 11.0f * zoom_;
      float room = right.x - left.x - 2 * pad;
      const unsigned ink = !fits ? unfit_colour : hot ? 0xffffffffu : row.takes ? colour::text : dim_text;
      if (row.colour && fits) {
        const float side = 11.0f * zoom_;
        const vec3 shown = display_colour(*row.colour);
        const vec2 end(right.x - pad, left.y + side / 2);
        list_.AddRectFilled(to_im(end - side), to_im(end),
                            ImGui::ColorConvertFloat4ToU32({shown.x, shown.y, shown.z, 1.0f}), 2.0f * zoom_);
        room -= side + 4.0f * zoom_;
      } else if (!row.value.empty()) {
        const float width = fonts().text->CalcTextSizeA(text_size_, 1e6f, 0.0f, row.value.c_str()).x;
        list_.AddText(fonts().text, text_size_, {right.x - pad - width, top}, fits ? dim_text : unfit_colour,
                      row.value.c_str());
        room -= width + 6.0f * zoom_;
      }
      if (row.takes) {
        text(fonts().text, text_size_, {left.x + pad, top}, room, ink, row.label);
      } else {
        const float width =
            std::min(room, fonts().text->CalcTextSizeA(text_size_, 1e6f, 0.0f, row.label.c_str()).x);
        text(fonts().text, text_size_, {right.x - pad - width, top}, width + 1.0f, ink, row.label);
      }
    }
    if (row.takes) draw_plug(left, row, false, hot && look_.hot.part == DiagramPart::taking_plug);
    if (row.gives) draw_plug(right, row, true, hot && look_.hot.part == DiagramPart::giving_plug);
  }

  // Filled where something is connected; a square where it is locked.
  void draw_plug(vec2 middle, const PlugRow& row, bool gives, bool hot) {
    const bool fits = !look_.fits || look_.fits(row, gives);
    const unsigned ink = fits ? plug_colour(graph_.attribute(row.plug).spec.type) : unfit_colour;
    const float r = (hot && fits ? 6.0f : 4.5f) * zoom_;
    if (row.locked && !gives) {
      list_.AddRectFilled(to_im(middle - r), to_im(middle + r), unfit_colour, 1.0f);
      return;
    }
    list_.AddCircleFilled(to_im(middle), r + zoom_, edge_colour, 12);
    if (gives ? row.drives : row.driven)
      list_.AddCircleFilled(to_im(middle), r, ink, 12);
    else
      list_.AddCircle(to_im(middle), r - 0.5f * zoom_, ink, 12, std::max(1.0f, 1.6f * zoom_));
  }

  ImDrawList& list_;
  const graph::Graph& graph_;
  const Diagram& diagram_;
  const DiagramLook& look_;
  float zoom_, text_size_ = 13.0f;
  bool shows_rows_ = true;
};

}  // namespace

void draw_wire(ImDrawList& list, vec2 from, vec2 to, unsigned colour, float thickness) {
  const float bend = std::clamp(std::abs(to.x - from.x) * 0.5f, scaled(16), scaled(120));
  list.AddBezierCubic(to_im(from), {from.x + bend, from.y}, {to.x - bend, to.y}, to_im(to), colour,
                      thickness);
}

void draw_diagram(ImDrawList& list, const graph::Graph& graph, const Diagram& diagram,
                  const DiagramLook& look) {
  Painter(list, graph, diagram, look).run();
}

}  // namespace plinian::window
