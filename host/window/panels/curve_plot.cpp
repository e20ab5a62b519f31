// Axes, curves, marks.
#include "host/window/panels/curve_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/scene/tick_step.h"
#include "host/window/panels/overlay_text.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

constexpr unsigned grid_colour = 0xff3a3734, faint_colour = 0xff8f8986;

// From the plot's own units to points of the window.
struct Axes {
  const Plot& plot;
  vec2 begin, size;
  ImVec2 place(dvec2 p) const {
    const double x = (p.x - plot.x_low) / (plot.x_high - plot.x_low);
    const double y = std::clamp(p.y / plot.y_high, 0.0, 1.0);
    return {begin.x + float(x) * size.x, begin.y + float(1.0 - y) * size.y};
  }
};

std::string label_of(double value, double step) {
  return fmt::format("{:g}", std::abs(value) < 1e-9 * step ? 0.0 : value);
}

// Of how many ticks one has a label, where that takes `room` and a tick `step`. [points]
int labelled(float room, double step) {
  return std::max(1, int(std::ceil(double(room) / step)));
}

void draw_axes(ImDrawList* list, const Axes& axes) {
  const Plot& plot = axes.plot;
  const double range = plot.x_high - plot.x_low, x_step = tick_step(range), y_step = tick_step(plot.y_high);
  const int each_y = labelled(ImGui::GetTextLineHeight(), y_step / plot.y_high * double(axes.size.y));
  for (int i = 0; i * y_step <= plot.y_high * 1.0001; ++i) {
    const ImVec2 at = axes.place({plot.x_low, i * y_step});
    list->AddLine(at, {at.x + axes.size.x, at.y}, grid_colour);
    if (i % each_y != 0) continue;
    const std::string text = label_of(i * y_step, y_step);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list->AddText({at.x - size.x - scaled(5), at.y - 0.5f * size.y}, faint_colour, text.c_str());
  }
  const auto first = std::int64_t(std::ceil(plot.x_low / x_step)),
             last = std::int64_t(std::floor(plot.x_high / x_step));
  float widest = 0.0f;
  for (std::int64_t i = first; i <= last; ++i)
    widest = std::max(widest, ImGui::CalcTextSize(label_of(double(i) * x_step, x_step).c_str()).x);
  const int each_x = labelled(widest + scaled(6), x_step / range * double(axes.size.x));
  for (std::int64_t i = first; i <= last; ++i) {
    if (i % each_x != 0) continue;
    const ImVec2 at = axes.place({double(i) * x_step, 0.0});
    const std::string text = label_of(double(i) * x_step, x_step);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list->AddText({at.x - 0.5f * size.x, at.y + scaled(2)}, faint_colour, text.c_str());
  }
  for (const double y : plot.thresholds) {
    const ImVec2 at = axes.place({plot.x_low, y});
    for (float x = 0.0f; x < axes.size.x; x += scaled(8))
      list->AddLine({at.x + x, at.y}, {at.x + std::min(x + scaled(3), axes.size.x), at.y}, faint_colour);
  }
}

void draw_marks(ImDrawList* list, const Axes& axes) {
  int row = 0;
  for (const PlotMark& mark : axes.plot.marks) {
    if (!(mark.x >= axes.plot.x_low && mark.x <= axes.plot.x_high)) continue;
    const ImVec2 at = axes.place({mark.x, 0.0});
    list->AddLine(at, {at.x, axes.begin.y}, mark.colour);
    const ImVec2 size = ImGui::CalcTextSize(mark.label.c_str());
    const bool at_right = at.x + size.x + scaled(6) > axes.begin.x + axes.size.x;
    draw_text({at_right ? at.x - size.x - scaled(4) : at.x + scaled(4),
               axes.begin.y + float(row++ % 3) * (size.y + 1.0f)},
              mark.colour, mark.label);
  }
}

}  // namespace

std::optional<double> show_plot(const char* id, const Plot& plot, vec2 size) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(id, to_im(size));
  const bool held = ImGui::IsItemActive();
  const float line = ImGui::GetTextLineHeight();
  const vec2 begin(corner.x + scaled(40), corner.y + scaled(4));
  const Axes axes{plot, begin, vec2(corner.x, corner.y) + size - begin - vec2(scaled(8), line + scaled(4))};
  ImDrawList* list = ImGui::GetWindowDrawList();
  draw_axes(list, axes);
  std::vector<ImVec2> points;
  for (const Curve& curve : plot.curves) {
    points.clear();
    for (const dvec2& point : curve.points) points.push_back(axes.place(point));
    list->AddPolyline(points.data(), int(points.size()), curve.colour, 0, scaled(1.5f));
  }
  draw_marks(list, axes);
  if (!held) return std::nullopt;
  const double share = std::clamp(double(ImGui::GetIO().MousePos.x - axes.begin.x) / axes.size.x, 0.0, 1.0);
  return plot.x_low + share * (plot.x_high - plot.x_low);
}

}  // namespace plinian::window
