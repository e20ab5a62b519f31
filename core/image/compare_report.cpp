#include "core/image/compare_report.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <map>

#include "compare_report_html.h"
#include "core/image/heat_map.h"
#include "core/image/image_io.h"

namespace plinian {
namespace {

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string base64(const std::vector<std::uint8_t>& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t rest = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = std::uint32_t(bytes[i]) << 16;
    if (rest > 1) word |= std::uint32_t(bytes[i + 1]) << 8;
    if (rest > 2) word |= std::uint32_t(bytes[i + 2]);
    for (std::size_t k = 0; k < 4; ++k) text += k <= rest ? digits[word >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

std::string data_url(const std::vector<std::uint8_t>& png) {
  return "data:image/png;base64," + base64(png);
}

std::string stops(float exposure) {
  return exposure == 0.0f ? "0" : format("%+g", exposure);
}

// One <img> per exposure; the first is the one that shows without scripts.
std::string images(const CompareResult& result, const std::string& description,
                   const std::function<std::vector<std::uint8_t>(std::size_t)>& png) {
  std::string html;
  for (std::size_t i = 0; i < result.flips.size(); ++i)
    html += "<img" + std::string(i == 0 ? " class=\"on\"" : "") + " data-exposure=\"" +
            stops(result.flips[i].exposure) + "\" width=\"" + std::to_string(result.width) + "\" height=\"" +
            std::to_string(result.height) + "\" alt=\"" + escaped(description) + " at " +
            stops(result.flips[i].exposure) + " stops\" src=\"" + data_url(png(i)) + "\">";
  return html;
}

std::string row(const std::string& measure, const std::string& value, const std::string& meaning) {
  return "<tr><th scope=\"row\">" + measure + "</th><td class=\"value\">" + value +
         "</td><td class=\"what\">" + meaning + "</td></tr>\n";
}

std::string decibels(double psnr) {
  return std::isfinite(psnr) ? format("%.2f dB", psnr) : "∞ dB";
}

std::string rows(const CompareResult& result) {
  const PixelMetrics& pixels = result.pixels;
  std::string html =
      row("PSNR", decibels(pixels.psnr),
          "Peak squared over the mean squared error. Each 6 dB halves the error. The peak is the larger "
          "of 1 and the reference's 99.9th percentile: here " +
              format("%.4g", pixels.peak) + ".");
  html += row(
      "PSNR where there is something", pixels.psnr_mask ? decibels(*pixels.psnr_mask) : "–",
      pixels.psnr_mask
          ? "The same over the " +
                format("%.1f%%", 100.0 * double(pixels.mask_pixels) / double(result.error.size())) +
                " of the pixels where the reference's alpha is over 0.01: an empty background hides no error."
          : "The reference has no alpha channel, or nothing in it.");
  html += row("SSIM", format("%.5f", result.ssim),
              "Likeness of structure in linear luminance, 11 × 11 Gaussian windows. 1 is identical.");
  for (const FlipAt& at : result.flips)
    html += row("FLIP at " + stops(at.exposure) + " stops", format("%.4f", at.flip.mean),
                "Mean difference that a viewer sees when the two alternate, 0 to 1; the worst pixel has " +
                    format("%.3f", at.flip.max) + ".");
  html += row("Largest error", format("%.4g", pixels.max_error),
              "Of one channel of one pixel, at x " + std::to_string(pixels.max_error_at.x) + ", y " +
                  std::to_string(pixels.max_error_at.y) + " from the upper left.");
  html += row(
      "Mean radiance", pixels.mean_ratio ? format("%+.3f%%", 100.0 * (*pixels.mean_ratio - 1.0)) : "–",
      "How much brighter the picture is than the reference on the whole: a bias that more samples will not "
      "remove.");
  html += row("MSE", format("%.4g", pixels.mse), "Mean squared error of R, G and B.");
  html += row("Not finite", std::to_string(result.bad_a) + " / " + std::to_string(result.bad_reference),
              "Pixels of the picture / of the reference that hold infinity or not-a-number, left out of all "
              "figures.");
  return html;
}

std::string made(const Image& image, const std::string& name, const char* role) {
  std::string html = "<section><h3>" + std::string(role) + " · " + escaped(name) + "</h3>";
  const auto command = image.metadata.find(attribute::command);
  if (command != image.metadata.end() && std::holds_alternative<std::string>(command->second))
    html += "<pre>" + escaped(std::get<std::string>(command->second)) + "</pre>";
  else
    html += "<p class=\"hint\">The file does not record the command line that made it.</p>";
  html += "<dl>";
  for (const auto& [key, value] : image.metadata) {
    if (!key.starts_with("plinian:") || key == attribute::command) continue;
    const bool time = key.starts_with(attribute::time_prefix);
    std::string label =
        time ? "time of " + key.substr(std::string(attribute::time_prefix).size()) : key.substr(8);
    std::string text;
    for (char& c : label)
      if (c == '_') c = ' ';
    if (const int* number = std::get_if<int>(&value)) text = std::to_string(*number);
    if (const float* number = std::get_if<float>(&value)) text = format(time ? "%.1f ms" : "%.6g", *number);
    if (const std::string* words = std::get_if<std::string>(&value)) text = *words;
    if (!text.empty()) html += "<dt>" + escaped(label) + "</dt><dd>" + escaped(text) + "</dd>";
  }
  return html + "</dl></section>";
}

std::string list_of(const char* kind, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string html = "<ul class=\"" + std::string(kind) + "\">";
  for (const std::string& line : lines) html += "<li>" + escaped(line) + "</li>";
  return html + "</ul>";
}

// Replaces each {{name}}; what is put in is not looked at again.
std::string fill(const std::string& page, const std::map<std::string, std::string>& values) {
  std::string html;
  std::size_t begin = 0;
  for (std::size_t open; (open = page.find("{{", begin)) != std::string::npos;) {
    const std::size_t close = page.find("}}", open);
    html.append(page, begin, open - begin);
    html += values.at(page.substr(open + 2, close - open - 2));
    begin = close + 2;
  }
  return html.append(page, begin);
}

}  // namespace

std::string compare_report(const Image& a, const Image& reference, const CompareResult& result,
                           const ReportText& text, const ViewSettings& view) {
  if (result.flips.empty())
    throw ImageError("report: the comparison has no exposure to show the pictures at");
  const auto seen = [&](const Image& image) {
    return [&](std::size_t i) {
      ViewSettings settings = view;
      settings.exposure += result.flips[i].exposure;
      return encode_png(to_display_bytes(image, ViewTransform(settings)), result.width, result.height);
    };
  };
  const auto heat = [&](const std::vector<float>& map, float scale) {
    return encode_png(heat_bytes(map, scale), result.width, result.height);
  };
  const float error_scale = heat_full_scale(result.error);
  const std::vector<std::string> failures = failed_limits(result, text.limits);

  std::map<std::string, std::string> values;
  values["title"] = escaped(text.name_a + " against " + text.name_reference);
  values["name_a"] = escaped(text.name_a);
  values["name_reference"] = escaped(text.name_reference);
  values["width"] = std::to_string(result.width);
  values["height"] = std::to_string(result.height);
  values["view"] = escaped(ViewTransform(view).description());
  values["failures"] = list_of("failures", failures);
  values["notes"] = list_of("notes", result.notes);
  values["verdict"] = text.limits.empty() ? ""
                      : failures.empty()  ? "<div class=\"verdict holds\">Keeps its limits</div>"
                                          : "<div class=\"verdict fails\">Fails its limits</div>";
  for (const FlipAt& at : result.flips)
    values["exposure_buttons"] +=
        "<button data-value=\"" + stops(at.exposure) + "\">" + stops(at.exposure) + "</button>";
  values["images_a"] = images(result, text.name_a, seen(a));
  values["images_reference"] = images(result, text.name_reference, seen(reference));
  values["images_flip"] =
      images(result, "FLIP heat map", [&](std::size_t i) { return heat(result.flips[i].flip.map, 1.0f); });
  values["image_error"] = data_url(heat(result.error, error_scale));
  values["error_scale"] = format("%g", error_scale);
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0})
    values["error_ticks"] += "<span>" + format("%.3g", part * error_scale) + "</span>";
  values["bad_legend"] = result.bad_a || result.bad_reference ? "; cyan is not finite." : ".";
  for (int i = 0; i <= 18; ++i) {
    const vec3 colour = 255.0f * heat_colour(float(i) / 18.0f);
    values["heat_gradient"] += (i ? ", rgb(" : "rgb(") + format("%.0f", colour.r) + " " +
                               format("%.0f", colour.g) + " " + format("%.0f", colour.b) + ")";
  }
  values["worst_left"] = format("%.4f", 100.0 * (result.pixels.max_error_at.x + 0.5) / result.width);
  values["worst_top"] = format("%.4f", 100.0 * (result.pixels.max_error_at.y + 0.5) / result.height);
  values["rows"] = rows(result);
  values["made"] =
      made(a, text.name_a, "The picture") + made(reference, text.name_reference, "The reference");
  return fill(compare_report_page, values);
}

void write_compare_report(const std::string& path, const Image& a, const Image& reference,
                          const CompareResult& result, const ReportText& text, const ViewSettings& view) {
  write_file(path, compare_report(a, reference, result, text, view));
}

}  // namespace plinian
