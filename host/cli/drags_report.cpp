// The table of bench --drags.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/cli/drags.h"

namespace plinian::cli {

namespace {

using nlohmann::ordered_json;

std::string decibels(const ordered_json& value) {
  return value.is_null() ? std::string("-") : fmt::format("{:.1f}", value.get<double>());
}

std::string drag_line(const std::string& name, const ordered_json& drag) {
  const ordered_json &latency = drag["latency_ms"], &ssim = drag["ssim"];
  return fmt::format("  {:<10}{:>12.1f}{:>10.0f}{:>8.0f}{:>15.0f}%{:>11.3f}{:>9.3f}{:>9.3f}{:>14}{:>8}\n",
                     name, drag["per_second"].get<double>(), latency["median"].get<double>(),
                     latency["p95"].get<double>(), 100.0 * drag["within_150_ms"].get<double>(),
                     ssim["median"].get<double>(), ssim["p5"].get<double>(), ssim["worst"].get<double>(),
                     fmt::format("{}x{}", drag["size"][0].get<int>(), drag["size"][1].get<int>()),
                     drag["map_resolution"].get<int>());
}

std::string rest_lines(const ordered_json& rest) {
  std::string text =
      fmt::format("  let go in {} [dB against the reference]:", rest["preset"].get<std::string>());
  for (const auto& [seconds, psnr] : rest["psnr_after_s"].items())
    text += fmt::format("  {} s: {}", seconds, decibels(psnr));
  text += rest["at_rest_s"].is_null()
              ? std::string("; not yet at rest")
              : fmt::format("; at rest after {:.1f} s", rest["at_rest_s"].get<double>());
  text +=
      rest["passes"].is_null() ? std::string("\n") : fmt::format(", {} passes\n", rest["passes"].get<int>());
  if (!rest["pop"].is_null())
    text += fmt::format("  the first picture then, against the last before: SSIM {:.3f}, {} dB\n",
                        rest["pop"]["ssim"].get<double>(), decibels(rest["pop"]["psnr"]));
  return text;
}

}  // namespace

std::string drags_table(const ordered_json& report) {
  std::string text = fmt::format(
      "{} at {}x{} with {}, {}; drags of {} s in {}\n\n  "
      "{:<10}{:>12}{:>10}{:>8}{:>16}{:>11}{:>9}{:>9}{:>14}{:>8}\n",
      report["scene"].get<std::string>(), report["size"][0].get<int>(), report["size"][1].get<int>(),
      report["renderer"].get<std::string>(), report["machine"].get<std::string>(),
      report["seconds"].get<double>(), report["preset"].get<std::string>(), "", "pictures/s", "late [ms]",
      "95%", "within 150 ms", "SSIM", "5%", "worst", "size", "maps");
  for (const auto& [name, drag] : report["drags"].items()) text += drag_line(name, drag);

  text += "\n";
  if (!report["rest"].is_null()) text += rest_lines(report["rest"]);
  text += fmt::format("  taking hold while it is refined: {:.0f} ms to the first picture, {:.0f} at worst\n",
                      report["take_hold_ms"]["median"].get<double>(),
                      report["take_hold_ms"]["worst"].get<double>());
  return text;
}

}  // namespace plinian::cli
