// A ruler, a hand, keys.
#include "host/window/panels/timeline_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "host/graph/model/conversion.h"
#include "host/window/fields/arithmetic.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

// Frames between numbers on the ruler, so that they stay apart.
double spacing(double frames, double points) {
  for (const double step : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 5000.0})
    if (points / frames * step >= scaled(44)) return step;
  return 10000.0;
}

}  // namespace

TimelinePanel::Range TimelinePanel::range_of_scene(Studio& studio) const {
  Range range;
  const graph::Node* time = scene::first_of_type(studio.session().graph(), "time");
  if (!time) return range;
  const auto read = [&](const char* name, double otherwise) {
    const graph::AttributeIndex attribute = time->schema->find(name);
    return attribute == graph::no_attribute ? otherwise : graph::number_of(time->value(attribute));
  };
  range.start = read("start", range.start);
  range.end = std::max(range.start, read("end", range.end));
  range.rate = std::max(1.0, read("rate", range.rate));
  return range;
}

void TimelinePanel::find_keys(Studio& studio) {
  const graph::Graph& graph = studio.session().graph();
  if (generation_ == graph.generation()) return;
  generation_ = graph.generation();
  keys_.clear();
  for (const graph::NodeId id : graph.selection()) {
    const graph::Node* node = graph.find(id);
    for (const graph::Input& input : node->inputs) {
      const graph::Node* curve = graph.find(input.source.node);
      if (!curve || curve->type->name() != "animCurve") continue;
      const graph::AttributeIndex key = curve->schema->find("key"), time = curve->schema->find("key.time");
      if (key == graph::no_attribute || time == graph::no_attribute) continue;
      for (const std::int32_t element : curve->elements(key))
        keys_.push_back(graph::number_of(curve->value(time, element)));
    }
  }
}

void TimelinePanel::go_to(Studio& studio, double frame) {
  if (frame != studio.session().evaluator().time())
    studio.run("currentTime " + graph::write_number(frame), "time");
}

void TimelinePanel::step(Studio& studio, double frames) {
  const Range range = range_of_scene(studio);
  go_to(studio, std::clamp(std::round(studio.session().evaluator().time()) + frames, range.start, range.end));
}

void TimelinePanel::toggle_play(Studio& studio) {
  playing_ = !playing_;
  began_ = std::chrono::steady_clock::now();
  began_at_ = studio.session().evaluator().time();
  stepped_ = began_;
}

void TimelinePanel::play(Studio& studio) {
  if (!playing_) return;
  const Range range = range_of_scene(studio);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  const double length = range.end - range.start + 1.0;
  const double frame =
      range.start + std::fmod(std::floor(began_at_ - range.start + seconds * range.rate), length);
  if (every_frame_) {
    // The next one when this one has been seen, not faster than in real time.
    const auto now = std::chrono::steady_clock::now();
    if (!studio.is_picture_there() ||
        std::chrono::duration<double>(now - stepped_).count() * range.rate < 1.0)
      return;
    stepped_ = now;
    const double next = std::floor(studio.session().evaluator().time()) + 1.0;
    go_to(studio, next > range.end ? range.start : next);
    return;
  }
  studio.keep_hand_on();
  // A frame that is still being made is waited for rather than left out of sight.
  if (!studio.feed.is_computing()) go_to(studio, frame);
}

void TimelinePanel::show(Studio& studio, const PaneRect& pane) {
  find_keys(studio);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(8), scaled(4)));
  begin_pane("##timeline", pane, false);
  ImGui::PopStyleVar();
  const Range range = range_of_scene(studio);
  const double now = studio.session().evaluator().time();
  if (toggle(playing_ ? "Stop" : "Play", playing_,
             every_frame_ ? "Play every frame, each until its picture is whole (Space)."
                          : "Play in real time, leaving out what takes too long (Space)."))
    toggle_play(studio);
  note_item(studio.trace, "play");
  ImGui::SameLine(0.0f, scaled(2));
  if (toggle("every", every_frame_,
             "Every frame, each until its picture is whole. What was played so, marked under the ruler, "
             "plays in "
             "real time from then on, until something is changed.")) {
    every_frame_ = !every_frame_;
    if (playing_) {  // from here on
      toggle_play(studio);
      toggle_play(studio);
    }
  }
  note_item(studio.trace, "play every frame");
  ImGui::SameLine(0.0f, scaled(6));
  FieldLook look;
  look.width = scaled(64);
  NumberRange frames;
  frames.whole = true;
  const FieldEdit edit = number_field("##frame", now, frames, look);
  help("The current frame.");
  if (edit.dragged) go_to(studio, *edit.dragged);
  if (edit.typed)
    if (const auto typed = typed_number(*edit.typed, now)) go_to(studio, *typed);
  ImGui::SameLine(0.0f, scaled(8));

  const ImVec2 begin = ImGui::GetCursorScreenPos();
  const ImVec2 size(std::max(40.0f, ImGui::GetContentRegionAvail().x), ImGui::GetFrameHeight());
  ImGui::InvisibleButton("##ruler", size);
  studio.trace.item("timeline", vec2(begin.x, begin.y), vec2(size.x, size.y));
  const double count = range.end - range.start + 1.0;
  const auto place = [&](double frame) {
    return begin.x + float((frame - range.start + 0.5) / count) * size.x;
  };
  if (ImGui::IsItemActive()) {
    playing_ = false;
    const double share = (ImGui::GetIO().MousePos.x - begin.x) / size.x;
    go_to(studio, std::clamp(std::floor(range.start + share * count), range.start, range.end));
    studio.keep_hand_on();
  }
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 end(begin.x + size.x, begin.y + size.y);
  list->AddRectFilled(begin, end, ImGui::GetColorU32(ImGuiCol_FrameBg), ImGui::GetStyle().FrameRounding);
  const double step = spacing(count, size.x);
  ImGui::PushFont(fonts().fixed);
  for (double frame = std::ceil(range.start / step) * step; frame <= range.end; frame += step) {
    const float x = std::round(place(frame));
    list->AddLine({x, end.y - scaled(5)}, {x, end.y}, 0xff6a6664);
    const std::string text = fmt::format("{:g}", frame);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    if (x - width / 2 > begin.x && x + width / 2 < end.x)
      list->AddText({x - width / 2, begin.y + scaled(1)}, colour::faint_text, text.c_str());
  }
  for (const double frame : studio.played.frames()) {
    const float half = 0.5f * size.x / float(count);
    list->AddRectFilled({std::max(begin.x, place(frame) - half), end.y - scaled(2)},
                        {std::min(end.x, place(frame) + half + 0.5f), end.y}, colour::played);
  }
  for (const double key : keys_) {
    const float x = std::round(place(key));
    list->AddRectFilled({x - scaled(1), begin.y + scaled(3)}, {x + scaled(2), end.y - scaled(3)},
                        colour::changed);
  }
  const float x = std::round(place(now));
  list->AddRectFilled({x - scaled(1), begin.y}, {x + scaled(1), end.y}, colour::accent);
  ImGui::PopFont();
  end_pane();
}

}  // namespace plinian::window
