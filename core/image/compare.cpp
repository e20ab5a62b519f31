#include "core/image/compare.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

namespace plinian {
namespace {

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::optional<double> flip_at(const CompareResult& result, float exposure) {
  for (const FlipAt& at : result.flips)
    if (at.exposure == exposure) return at.flip.mean;
  return std::nullopt;
}

// A figure that can be limited: its key, the side that fails, and how it is read.
struct Figure {
  const char* key;
  bool fails_under;
  std::optional<double> (*read)(const CompareResult&);
};

constexpr std::array<Figure, 8> figures{{
    {"psnr", true, [](const CompareResult& r) { return std::optional(r.pixels.psnr); }},
    {"psnr_mask", true, [](const CompareResult& r) { return r.pixels.psnr_mask; }},
    {"ssim", true, [](const CompareResult& r) { return std::optional(r.ssim); }},
    {"flip", false, [](const CompareResult& r) { return flip_at(r, 0.0f); }},
    {"flip3", false, [](const CompareResult& r) { return flip_at(r, 3.0f); }},
    {"max_error", false, [](const CompareResult& r) { return std::optional(r.pixels.max_error); }},
    {"mse", false, [](const CompareResult& r) { return std::optional(r.pixels.mse); }},
    {"mean", false,
     [](const CompareResult& r) {
       return r.pixels.mean_ratio ? std::optional(std::abs(*r.pixels.mean_ratio - 1.0)) : std::nullopt;
     }},
}};

const Figure* find_figure(const std::string& key) {
  for (const Figure& figure : figures)
    if (key == figure.key) return &figure;
  return nullptr;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

nlohmann::ordered_json finite_or_null(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return *value;
}

}  // namespace

CompareResult compare_images(const Image& a, const Image& reference,
                             const std::vector<float>& flip_exposures) {
  const PicturePair pictures = pair_pictures(a, reference);
  CompareResult result;
  result.width = pictures.width;
  result.height = pictures.height;
  result.pixels = pixel_metrics(pictures);
  result.ssim = ssim(pictures, result.pixels.peak);
  for (const float exposure : flip_exposures) {
    FlipSettings settings;
    settings.exposure = exposure;
    result.flips.push_back(
        {exposure, flip(pictures.a, pictures.reference, pictures.width, pictures.height, settings)});
  }
  result.error.resize(pictures.a.size());
  for (std::size_t i = 0; i < result.error.size(); ++i) {
    const vec3 difference = glm::abs(pictures.a[i] - pictures.reference[i]);
    result.error[i] = pictures.valid[i] ? std::max({difference.r, difference.g, difference.b})
                                        : std::numeric_limits<float>::quiet_NaN();
  }
  result.bad_a = pictures.bad_a;
  result.bad_reference = pictures.bad_reference;
  if (result.bad_a || result.bad_reference)
    result.notes.push_back("pixels that are not finite: " + std::to_string(result.bad_a) +
                           " in the picture, " + std::to_string(result.bad_reference) +
                           " in the reference; left out of every figure");
  if (a.display_referred || reference.display_referred)
    result.notes.push_back(
        std::string(a.display_referred && reference.display_referred ? "both pictures hold"
                    : a.display_referred                             ? "the picture holds"
                                                                     : "the reference holds") +
        " display values, clipped and rounded by a view: compare EXR files for figures of linear radiance");
  return result;
}

std::vector<Limit> parse_limits(const std::string& text) {
  std::vector<Limit> limits;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string entry = trimmed(text.substr(begin, end - begin));
    const std::size_t equals = entry.find('=');
    const std::string key = trimmed(entry.substr(0, equals));
    const std::string value = equals == std::string::npos ? "" : trimmed(entry.substr(equals + 1));
    if (!find_figure(key)) {
      std::string known;
      for (const Figure& figure : figures) known += (known.empty() ? "" : ", ") + std::string(figure.key);
      throw ImageError("limits: unknown key '" + key + "' in '" + text + "'; known are " + known);
    }
    Limit limit{key, 0.0};
    const auto [stop, error] = std::from_chars(value.data(), value.data() + value.size(), limit.value);
    if (error != std::errc() || stop != value.data() + value.size() || !std::isfinite(limit.value))
      throw ImageError("limits: " + key + " needs a number, not '" + value + "', as in " + key + "=0.5");
    limits.push_back(limit);
    begin = end + 1;
  }
  return limits;
}

std::vector<std::string> failed_limits(const CompareResult& result, const std::vector<Limit>& limits) {
  std::vector<std::string> failures;
  for (const Limit& limit : limits) {
    const Figure* figure = find_figure(limit.key);
    if (!figure) throw ImageError("limits: unknown key '" + limit.key + "'");
    const std::optional<double> value = figure->read(result);
    if (!value)
      failures.push_back(limit.key + " cannot be measured on these pictures");
    else if (figure->fails_under ? !(*value >= limit.value) : !(*value <= limit.value))
      failures.push_back(limit.key + " " + number(*value) + " is " +
                         (figure->fails_under ? "under " : "over ") + number(limit.value));
  }
  if (!limits.empty() && (result.bad_a || result.bad_reference))
    failures.push_back(std::to_string(result.bad_a + result.bad_reference) + " pixels are not finite");
  return failures;
}

std::string compare_json(const CompareResult& result, const std::vector<std::string>& failures) {
  nlohmann::ordered_json json;
  json["size"] = {result.width, result.height};
  json["identical"] = result.pixels.mse == 0.0 && !result.bad_a && !result.bad_reference;
  json["psnr"] = finite_or_null(result.pixels.psnr);
  json["psnr_mask"] = finite_or_null(result.pixels.psnr_mask);
  json["ssim"] = result.ssim;
  json["flip"] = nlohmann::ordered_json::array();
  for (const FlipAt& at : result.flips)
    json["flip"].push_back({{"exposure", at.exposure}, {"mean", at.flip.mean}, {"max", at.flip.max}});
  json["mse"] = finite_or_null(result.pixels.mse);
  json["max_error"] = finite_or_null(result.pixels.max_error);
  json["max_error_at"] = {result.pixels.max_error_at.x, result.pixels.max_error_at.y};
  json["mean_ratio"] = finite_or_null(result.pixels.mean_ratio);
  json["peak"] = result.pixels.peak;
  json["mask_pixels"] = result.pixels.mask_pixels;
  json["bad_pixels"] = {{"a", result.bad_a}, {"reference", result.bad_reference}};
  json["notes"] = result.notes;
  json["failures"] = failures;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace plinian
