// plinian compare: how far one picture is from another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "core/image/compare_report.h"
#include "core/image/image_io.h"
#include "core/scene/nearest_word.h"
#include "host/cli/command.h"
#include "host/cli/console.h"

namespace plinian::cli {

namespace {

struct CompareArguments {
  std::string a, reference, report, limits, view = "srgb";
  bool json = false, quiet = false;
};

constexpr const char* examples = R"(
Examples:
  plinian compare fast.exr reference.exr
  plinian compare fast.exr reference.exr --report report.html
  plinian compare fast.exr reference.exr --fail-under psnr=35,ssim=0.975
Figures are of linear radiance, so compare EXR files. psnr, psnr_mask (where the reference's alpha is over 0.01)
and ssim fail when they fall under their limit; mse, max_error, flip, flip3 and mean when they rise over it.)";

std::string decibel(double psnr) {
  return std::isfinite(psnr) ? fmt::format("{:.2f} dB", psnr) : "identical";
}

std::string figures_text(const CompareResult& result) {
  const PixelMetrics& pixels = result.pixels;
  std::string text = fmt::format("psnr       {}\n", decibel(pixels.psnr));
  if (pixels.psnr_mask)
    text += fmt::format("psnr_mask  {}  ({} pixels with alpha > 0.01)\n", decibel(*pixels.psnr_mask),
                        pixels.mask_pixels);
  text += fmt::format("ssim       {:.5f}\nmse        {:.4g}\nmax_error  {:.4g} at {}, {}\n", result.ssim,
                      pixels.mse, pixels.max_error, pixels.max_error_at.x, pixels.max_error_at.y);
  for (const FlipAt& at : result.flips)
    text += fmt::format("flip       {:.4f} at {:+g} stops\n", at.flip.mean, at.exposure);
  if (pixels.mean_ratio) text += fmt::format("mean       {:.5f} of the reference's\n", *pixels.mean_ratio);
  if (result.bad_a + result.bad_reference > 0)
    text += fmt::format("not finite {} pixels, {} in the reference\n", result.bad_a, result.bad_reference);
  return text;
}

int run_compare(const CompareArguments& arguments) {
  set_quiet(arguments.quiet);
  const auto limits = arguments.limits.empty() ? std::vector<Limit>{} : parse_limits(arguments.limits);
  const ViewSettings view = parse_view(arguments.view);
  if (!arguments.report.empty()) check_writable(arguments.report);
  const Image a = read_image(arguments.a), reference = read_image(arguments.reference);
  const CompareResult result = compare_images(a, reference);
  const std::vector<std::string> failures = failed_limits(result, limits);
  if (!arguments.report.empty()) {
    write_compare_report(arguments.report, a, reference, result, {arguments.a, arguments.reference, limits},
                         view);
    note("report: " + arguments.report);
  }
  for (const std::string& line : result.notes) note(line);
  // Comparing two scenes may be meant; it must not happen unnoticed.
  const auto scene_a = a.metadata.find(attribute::scene_hash),
             scene_b = reference.metadata.find(attribute::scene_hash);
  if (scene_a != a.metadata.end() && scene_b != reference.metadata.end() &&
      scene_a->second != scene_b->second)
    warn(fmt::format("{} and {} are pictures of different scenes", arguments.a, arguments.reference));
  print(arguments.json ? compare_json(result, failures) + "\n" : figures_text(result));
  if (failures.empty()) return exit_success;
  error(fmt::format("{}: {}", arguments.a, join(failures, "; ")));
  return exit_failure;
}

}  // namespace

Run set_up_compare(CLI::App& app) {
  auto arguments = std::make_shared<CompareArguments>();
  app.footer(examples);
  app.add_option("A", arguments->a, "the picture to judge")->required();
  app.add_option("B", arguments->reference, "the reference that it is judged by")->required();
  app.add_option("--report", arguments->report,
                 "a page with both pictures, error maps and figures, in one file")
      ->type_name("FILE.html");
  app.add_option("--fail-under", arguments->limits, "exit with 1 unless the figures keep to these limits")
      ->type_name("psnr=35,ssim=0.97");
  app.add_option("--view", arguments->view,
                 "of the pictures in the report, not of the figures: srgb, filmic, ocio")
      ->type_name("VIEW")
      ->capture_default_str();
  app.add_flag("--json", arguments->json, "figures on standard output, for scripts");
  app.add_flag("-q,--quiet", arguments->quiet, "no notes");
  return [arguments](const std::string&) { return run_compare(*arguments); };
}

}  // namespace plinian::cli
