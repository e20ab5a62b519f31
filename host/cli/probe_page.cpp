#include "host/cli/probe_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/scene/tick_step.h"

namespace plinian::cli {

namespace {

constexpr double width = 760, height = 260, left = 64, right = 16, top = 16, bottom = 40;  // [px]

constexpr const char* style = R"(<style>
body{background:#17191c;color:#d4d7db;font:15px/1.5 system-ui,sans-serif;max-width:820px;margin:32px auto;padding:0 16px}
h1{font-size:20px;font-weight:600}h2{font-size:16px;font-weight:600;margin:28px 0 4px}
p{margin:4px 0;color:#a3a8ae}code{color:#a3a8ae}
svg{background:#1f2226;border-radius:6px;display:block;margin:8px 0}
text{fill:#8b9097;font:12px system-ui,sans-serif}.axis{stroke:#3b4046}
.exact{stroke:#e8b04a}.map{stroke:#5fb0ef}.density{stroke:#8fbf6f}.bound{stroke:#8b9097;stroke-dasharray:4 4}
.point{stroke:#e8e8e8}polyline{fill:none;stroke-width:1.8}
.key{font-size:13px}.key b{font-weight:600}
</style>)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '<'   ? "&lt;"
              : c == '>' ? "&gt;"
              : c == '&' ? "&amp;"
              : c == '"' ? "&quot;"
                         : std::string(1, c);
  return result;
}

double mean(const dvec3& v) {
  return (v.x + v.y + v.z) / 3.0;
}

class Plot {
 public:
  Plot(double x_low, double x_high, double y_high) : x_low_(x_low), x_high_(x_high), y_high_(y_high) {
    svg_ = fmt::format("<svg viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">", width, height);
    const double x_step = tick_step(x_high - x_low), y_step = tick_step(y_high);
    for (double x = std::ceil(x_low / x_step) * x_step; x <= x_high; x += x_step)
      svg_ += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:g}</text>", place_x(x),
                          height - bottom + 18, std::abs(x) < 1e-9 * x_step ? 0.0 : x);
    for (double y = 0.0; y <= y_high * 1.0001; y += y_step)
      svg_ += fmt::format(
          "<line class=\"axis\" x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/><text x=\"{}\" y=\"{:.1f}\" "
          "text-anchor=\"end\">{:g}</text>",
          left, width - right, place_y(y), place_y(y), left - 8, place_y(y) + 4, y);
    svg_ +=
        fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">metres</text>", width - right, height - 4);
  }

  template <class Samples, class X, class Y>
  void curve(const char* kind, const Samples& samples, const X& x, const Y& y) {
    svg_ += fmt::format("<polyline class=\"{}\" points=\"", kind);
    for (const auto& sample : samples)
      svg_ += fmt::format("{:.2f},{:.2f} ", place_x(x(sample)), place_y(std::min(y(sample), y_high_)));
    svg_ += "\"/>";
  }
  void mark(const char* kind, double x, const std::string& label) {
    if (!(x >= x_low_ && x <= x_high_)) return;
    const bool at_right = place_x(x) > 0.85 * width;
    svg_ += fmt::format(
        "<line class=\"{0}\" x1=\"{1:.1f}\" x2=\"{1:.1f}\" y1=\"{2}\" y2=\"{3}\"/><text x=\"{4:.1f}\" "
        "y=\"{5}\" "
        "text-anchor=\"{6}\">{7}</text>",
        kind, place_x(x), top, height - bottom, place_x(x) + (at_right ? -5.0 : 5.0),
        top + 26 + 16 * (marks_++ % 3), at_right ? "end" : "start", label);
  }
  std::string svg() const { return svg_ + "</svg>\n"; }

 private:
  double place_x(double x) const { return left + (x - x_low_) / (x_high_ - x_low_) * (width - left - right); }
  double place_y(double y) const { return height - bottom - y / y_high_ * (height - top - bottom); }

  double x_low_, x_high_, y_high_;
  int marks_ = 0;
  std::string svg_;
};

std::string view_section(const ProbeReport& report) {
  const auto& samples = report.view.samples;
  if (samples.empty()) return "<p>The ray meets no medium.</p>\n";
  double densest = 1e-30;
  for (const auto& sample : samples) densest = std::max(densest, mean(sample.sigma_t));
  const auto t = [](const ViewRayProbe::Sample& sample) { return sample.t; };
  std::string html = "<h2>Along the view ray</h2><p>Extinction [1/m], by distance from the camera</p>";
  Plot extinction(samples.front().t, samples.back().t, 1.05 * densest);
  extinction.curve("density", samples, t,
                   [](const ViewRayProbe::Sample& sample) { return mean(sample.sigma_t); });
  extinction.mark("point", report.t, "probed here");
  html += extinction.svg() + "<p>Transmittance to the camera</p>";
  Plot transmittance(samples.front().t, samples.back().t, 1.0);
  transmittance.curve("exact", samples, t,
                      [](const ViewRayProbe::Sample& sample) { return mean(sample.transmittance); });
  transmittance.mark("point", report.t, "probed here");
  return html + transmittance.svg();
}

std::string light_section(const LightRayProbe& light) {
  std::string html = fmt::format(
      "<h2>{}</h2><p>Transmittance from the light, by distance along its ray. At the point: exact {:.4f}, "
      "map "
      "{:.4f}.</p>",
      escaped(light.light), mean(light.exact), mean(light.map));
  if (light.samples.empty()) return html;
  Plot plot(light.samples.front().k, light.samples.back().k, 1.0);
  const auto k = [](const LightRayProbe::Sample& sample) { return sample.k; };
  plot.curve("exact", light.samples, k,
             [](const LightRayProbe::Sample& sample) { return mean(sample.exact); });
  plot.curve("map", light.samples, k, [](const LightRayProbe::Sample& sample) { return mean(sample.map); });
  for (const LightRayProbe::Bounds& bounds : light.bounds) {
    if (bounds.missed) continue;
    plot.mark("bound", bounds.k_min, "kmin");
    plot.mark("bound", bounds.k_max, bounds.dense ? "kmax" : "kmax (thin)");
  }
  plot.mark("point", light.k, "the point");
  return html + plot.svg() +
         "<p class=\"key\"><b style=\"color:#e8b04a\">exact</b> &nbsp; <b style=\"color:#5fb0ef\">map</b> "
         "&nbsp; "
         "mean of the channels</p>\n";
}

}  // namespace

std::string probe_page(const ProbeReport& report) {
  std::string html = fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Probe of {0}</title>{1}"
      "<h1>Pixel {2}, {3} of {0}</h1><p>{4} x {5} pixels. <code>{6}</code></p>\n",
      escaped(report.scene), style, report.pixel.x, report.pixel.y, report.size.x, report.size.y,
      escaped(report.command));
  html += view_section(report);
  for (const LightRayProbe& light : report.lights) html += light_section(light);
  return html + "</html>\n";
}

}  // namespace plinian::cli
