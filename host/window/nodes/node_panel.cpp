// What the mouse does on the canvas: to the view and to places at once, to the scene by commands.
#include "host/window/nodes/node_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/resources.h"
#include "host/window/nodes/diagram_painter.h"
#include "host/window/nodes/node_colours.h"
#include "host/window/nodes/node_failure.h"
#include "host/window/panels/bottom_tabs.h"
#include "host/window/panels/overlay_text.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

std::filesystem::path places_file() {
  const std::filesystem::path folder = user_state_folder();
  return folder.empty() ? folder : folder / "node_places";
}

// [points] the way that makes a press a drag.
float least_way() {
  return scaled(3);
}

bool is_plug(const DiagramHit& hit) {
  return hit.part == DiagramPart::taking_plug || hit.part == DiagramPart::giving_plug;
}

}  // namespace

NodePanel::NodePanel(graph::Session& session) : map_(session, places_file()) {}

bool NodePanel::take(Action action) {
  if (!hovered_ || (action != Action::frame_selection && action != Action::frame_all)) return false;
  wanted_ = action;
  return true;
}

void NodePanel::hide() {
  hovered_ = false;
  hold_ = Hold::nothing;
  wire_.reset();
  boxes_seen_ = 0;
}

void NodePanel::show(Studio& studio, const PaneRect& pane) {
  begin_pane("##nodes", pane, false);
  show_controls(studio);
  map_.choice.filter = filter_;
  map_.update();
  const auto& selection = studio.session().graph().selection();
  selected_ = {selection.begin(), selection.end()};
  show_canvas(studio);
  end_pane();
}

void NodePanel::show_controls(Studio& studio) {
  show_bottom_tabs(studio);
  const bool around = map_.choice.around.has_value();
  if (toggle("all", !around, "All nodes of the scene.")) {
    map_.choice.around.reset();
    wanted_ = Action::frame_all;
  }
  note_item(studio.trace, "nodes all");
  ImGui::SameLine(0.0f, scaled(2));
  if (toggle("selected", around,
             "What is selected now, with all that it depends on and all that it drives.") &&
      !selected_.empty()) {
    map_.choice.around = selected_;
    wanted_ = Action::frame_all;
  }
  note_item(studio.trace, "nodes selected");
  ImGui::SameLine(0.0f, scaled(8));
  if (ImGui::Button("lay out")) {
    map_.lay_out_anew();
    wanted_ = Action::frame_all;
  }
  note_item(studio.trace, "nodes lay out");
  help("Puts the boxes that are shown from left to right as they depend on one another.");
  ImGui::SameLine(0.0f, scaled(8));
  if (ImGui::GetContentRegionAvail().x < scaled(60)) ImGui::NewLine();
  ImGui::SetNextItemWidth(std::min(ImGui::GetContentRegionAvail().x, scaled(160)));
  ImGui::InputTextWithHint("##plugs", "plugs", filter_, sizeof filter_);
  note_item(studio.trace, "nodes filter");
  help("Shows plugs with this in their name on all nodes, beside those that are connected or carry data.");
}

void NodePanel::frame(const std::set<graph::NodeId>& nodes) {
  std::vector<const NodeBox*> boxes;
  for (const NodeBox& box : map_.diagram().boxes)
    if (nodes.empty() || nodes.contains(box.id)) boxes.push_back(&box);
  if (const auto bounds = bounds_of(boxes))
    view_ = framed(bounds->first, bounds->second, size_, scaled(100) / 100.0f);
}

bool NodePanel::is_all_in_sight() const {
  std::vector<const NodeBox*> boxes;
  for (const NodeBox& box : map_.diagram().boxes) boxes.push_back(&box);
  const auto bounds = bounds_of(boxes);
  if (!bounds) return true;
  const vec2 begin = view_.to_pane(bounds->first), end = view_.to_pane(bounds->second);
  return begin.x >= 0.0f && begin.y >= 0.0f && end.x <= size_.x && end.y <= size_.y;
}

// Nodes that were made elsewhere, or a pane that is another size by now.
void NodePanel::frame_what_came() {
  if (hold_ != Hold::nothing || is_own_view_) return;
  const std::size_t boxes = map_.diagram().boxes.size();
  const bool changed = boxes_seen_ != boxes || size_seen_ != size_;
  boxes_seen_ = boxes;
  size_seen_ = size_;
  if (changed && !wanted_ && !is_all_in_sight()) wanted_ = Action::frame_all;
}

void NodePanel::show_canvas(Studio& studio) {
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  corner_ = {corner.x, corner.y};
  size_ = glm::max(vec2(room.x, room.y), vec2(1.0f));
  ImGui::InvisibleButton("##canvas", to_im(size_),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                             ImGuiButtonFlags_MouseButtonRight);
  note_item(studio.trace, "nodes canvas");
  hovered_ = ImGui::IsItemHovered();
  if (framed_ != map_.scenes() && !map_.diagram().boxes.empty()) {
    framed_ = map_.scenes();
    wanted_ = Action::frame_all;
  }
  frame_what_came();
  if (wanted_) {
    is_own_view_ = *wanted_ == Action::frame_selection;
    frame(is_own_view_ ? selected_ : std::set<graph::NodeId>());
  }
  wanted_.reset();
  const ImGuiIO& io = ImGui::GetIO();
  mouse_ = vec2(io.MousePos.x, io.MousePos.y) - corner_;
  constexpr float reach = 8.0f;  // [points of the canvas]
  hot_ = hovered_ || hold_ == Hold::wire
             ? hit(map_.diagram(), view_.to_canvas(mouse_), std::max(reach, scaled(7) / view_.zoom))
             : DiagramHit();
  if (hovered_ && hold_ == Hold::nothing) look_around();
  if (hovered_ && hold_ == Hold::nothing && ImGui::IsMouseClicked(0) && !io.KeyAlt)
    press(studio, ImGui::IsMouseDoubleClicked(0));
  else if (hold_ != Hold::nothing)
    drag(studio);
  last_ = mouse_;
  draw(studio);
  show_help(studio);
  if (studio.trace.is_on()) tell_places(studio);
}

// Middle pans, with Alt and without; the wheel and Alt with the right button zoom.
void NodePanel::look_around() {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMouseClicked(2)) hold_ = Hold::pan;
  if (ImGui::IsMouseClicked(1) && io.KeyAlt) hold_ = Hold::zoom;
  pressed_ = mouse_;
  if (io.MouseWheel == 0.0f) return;
  view_ = zoomed(view_, mouse_, std::pow(1.15f, io.MouseWheel), scaled(100) / 100.0f);
  is_own_view_ = true;
}

void NodePanel::press(Studio& studio, bool twice) {
  const ImGuiIO& io = ImGui::GetIO();
  const graph::Graph& graph = studio.session().graph();
  pressed_ = mouse_;
  moved_ = false;
  if (hot_.part == DiagramPart::nothing) {
    hold_ = Hold::rectangle;
  } else if (is_plug(hot_)) {
    wire_.emplace(graph, map_.diagram(), hot_);
    refused_.clear();
    hold_ = Hold::wire;
  } else if (hot_.part == DiagramPart::opener) {
    const graph::NodeId id = map_.diagram().boxes[hot_.box].id;
    if (!map_.choice.open.erase(id)) map_.choice.open.insert(id);
  } else {
    const NodeBox& box = map_.diagram().boxes[hot_.box];
    const bool selected = selected_.contains(box.id);
    // Two clicks show its attributes alone; one on what is selected with others keeps them all, to be moved.
    if (twice || (!selected && !io.KeyShift && !io.KeyCtrl))
      studio.run("select " + box.name);
    else if (io.KeyShift || io.KeyCtrl)
      studio.run(std::string("select ") + (selected ? "-remove " : "-add ") + box.name);
    held_.clear();
    for (const NodeBox& other : map_.diagram().boxes)
      if (other.id == box.id || (selected && selected_.contains(other.id)))
        held_.emplace_back(other.id, other.place);
    hold_ = Hold::boxes;
  }
}

void NodePanel::drag(Studio& studio) {
  const int button = hold_ == Hold::pan ? 2 : hold_ == Hold::zoom ? 1 : 0;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {  // gives up
    if (hold_ == Hold::boxes)
      for (std::size_t b = 0; b < map_.diagram().boxes.size(); ++b)
        for (const auto& [id, place] : held_)
          if (map_.diagram().boxes[b].id == id) map_.move(b, place);
    wire_.reset();
    hold_ = Hold::nothing;
    return;
  }
  if (!ImGui::IsMouseDown(button)) return let_go(studio);
  moved_ |= glm::distance(mouse_, pressed_) >= least_way();
  is_own_view_ |= hold_ == Hold::pan || hold_ == Hold::zoom;
  if (hold_ == Hold::pan) view_.offset += mouse_ - last_;
  if (hold_ == Hold::zoom)
    view_ = zoomed(view_, pressed_, std::exp((mouse_.x - last_.x) / scaled(150)), scaled(100) / 100.0f);
  if (hold_ != Hold::boxes || !moved_) return;
  for (std::size_t b = 0; b < map_.diagram().boxes.size(); ++b)
    for (const auto& [id, place] : held_)
      if (map_.diagram().boxes[b].id == id)
        map_.move(b, glm::round(place + (mouse_ - pressed_) / view_.zoom));
}

void NodePanel::let_go(Studio& studio) {
  const ImGuiIO& io = ImGui::GetIO();
  const Hold held = std::exchange(hold_, Hold::nothing);
  if (held == Hold::wire) return drop_wire(studio);
  if (held == Hold::rectangle) {
    const vec2 to = moved_ ? mouse_ : pressed_;
    select(studio, boxes_within(map_.diagram(), view_.to_canvas(pressed_), view_.to_canvas(to)));
  } else if (held == Hold::boxes && !moved_ && held_.size() > 1 && !io.KeyShift && !io.KeyCtrl) {
    for (const NodeBox& box : map_.diagram().boxes)
      if (hot_.part == DiagramPart::box && &box == &map_.diagram().boxes[hot_.box])
        studio.run("select " + box.name);
  }
}

void NodePanel::select(Studio& studio, const std::vector<std::size_t>& boxes) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool adds = io.KeyShift || io.KeyCtrl;
  std::string line = adds ? "select -add" : "select";
  for (const std::size_t b : boxes) line += " " + map_.diagram().boxes[b].name;
  if (!boxes.empty())
    studio.run(line);
  else if (!adds && !studio.session().graph().selection().empty())
    studio.run("select -clear");
}

// To take a wire from one plug to another breaks and connects: one step of undo.
void NodePanel::drop_wire(Studio& studio) {
  ConnectDrag wire = *std::exchange(wire_, std::nullopt);
  if (!moved_) return;
  const std::string key = studio.commands.new_merge_key("wire");
  for (const std::string& line : wire.let_go(studio.session().graph(), map_.diagram(), hot_))
    studio.run(line, key);
  studio.commands.end_drag();
}

void NodePanel::draw(Studio& studio) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const graph::Graph& graph = studio.session().graph();
  list.AddRectFilled(to_im(corner_), to_im(corner_ + size_), 0xff221f1e, scaled(3));
  list.PushClipRect(to_im(corner_), to_im(corner_ + size_), true);
  DiagramLook look{corner_, size_, view_, selected_, hot_, nullptr, nullptr};
  look.failure = [&](graph::NodeId id) {
    const auto failure = failure_of(studio.session(), id);
    return !failure ? 0 : failure->blocked ? 1 : 2;
  };
  if (wire_)
    look.fits = [&](const PlugRow& row, bool gives) {
      return (row.plug == wire_->held() && gives == wire_->wants_taker()) ||
             wire_->problem(graph, row.plug, gives).empty();
    };
  draw_diagram(list, graph, map_.diagram(), look);
  if (wire_ && graph.find(wire_->held().node)) {
    vec2 end = corner_ + mouse_, start = corner_ + pressed_;
    for (const NodeBox& box : map_.diagram().boxes)
      for (std::size_t r = 0; r < box.rows.size(); ++r)
        if (box.rows[r].plug == wire_->held())
          start = corner_ + view_.to_pane(plug_place(box, r, wire_->wants_taker()));
    if (!wire_->wants_taker()) std::swap(start, end);
    draw_wire(list, start, end, plug_colour(graph.attribute(wire_->held()).spec.type), 2.2f * view_.zoom);
  }
  if (hold_ == Hold::rectangle && moved_) {
    list.AddRectFilled(to_im(corner_ + pressed_), to_im(corner_ + mouse_),
                       (colour::accent & 0xffffff) | 0x28000000);
    list.AddRect(to_im(corner_ + pressed_), to_im(corner_ + mouse_), colour::accent);
  }
  if (map_.diagram().boxes.empty())
    list.AddText(to_im(corner_ + scaled(10)), colour::faint_text, "the scene has no nodes");
  list.PopClipRect();
}

// Of a plug what it is, or why the wire cannot end there; of a box its type, or why it failed.
void NodePanel::show_help(Studio& studio) {
  if (hot_.part == DiagramPart::nothing || (hold_ != Hold::nothing && hold_ != Hold::wire)) return;
  const graph::Graph& graph = studio.session().graph();
  const NodeBox& box = map_.diagram().boxes[hot_.box];
  const graph::Node* node = graph.find(box.id);
  if (!node) return;
  std::string text;
  unsigned ink = colour::text;
  if (is_plug(hot_)) {
    const PlugRow& row = box.rows[hot_.row];
    const bool gives = hot_.part == DiagramPart::giving_plug;
    const graph::AttributeSpec& spec = graph.attribute(row.plug).spec;
    text = graph.name_of(row.plug) + "  (" +
           (spec.data_type.empty() ? std::string(graph::type_name(spec.type)) : spec.data_type) + ")";
    if (row.locked && !gives) text += ", locked";
    const bool starts = wire_ && row.plug == wire_->held() && gives == wire_->wants_taker();
    if (const std::string problem = wire_ && !starts ? wire_->problem(graph, row.plug, gives) : "";
        !problem.empty()) {
      text = problem;
      ink = colour::warning;
    } else if (!wire_ && !spec.help.empty()) {
      text += "\n" + spec.help;
    }
  } else if (wire_) {
    return;
  } else if (const auto failure = failure_of(studio.session(), box.id)) {
    text = box.name + ": " + failure->message;
    ink = failure->blocked ? colour::warning : colour::error;
  } else {
    if (ImGui::GetIO().MouseDelta.x != 0.0f || ImGui::GetIO().MouseDelta.y != 0.0f) return;
    return help(box.name + "  (" + box.type + ")\n" + node->type->spec().help);
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(scaled(380));
  ImGui::PushStyleColor(ImGuiCol_Text, ink);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  if (wire_ && ink == colour::warning && std::exchange(refused_, text) != text)
    studio.trace.note("refused " + text);
}

// For whoever drives the window from outside.
void NodePanel::tell_places(Studio& studio) {
  const graph::Graph& graph = studio.session().graph();
  const auto tell = [&](const std::string& name, vec2 begin, vec2 size) {
    studio.trace.item(name, corner_ + view_.to_pane(begin), size * view_.zoom);
  };
  for (const NodeBox& box : map_.diagram().boxes) {
    tell("box " + box.name, box.place, {box_width, header_height});
    for (std::size_t r = 0; r < box.rows.size(); ++r)
      for (const bool gives : {false, true}) {
        constexpr float half = 4.0f;
        if (gives ? box.rows[r].gives : box.rows[r].takes)
          tell((gives ? "out " : "in ") + graph.name_of(box.rows[r].plug), plug_place(box, r, gives) - half,
               vec2(2.0f * half));
      }
  }
}

}  // namespace plinian::window
