// plinian probe: why a pixel looks as it does.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/files/atomic_file.h"
#include "core/integrate/ray_probe.h"
#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/prepared_scene.h"
#include "host/cli/probe_page.h"
#include "host/cli/scene_arguments.h"

namespace plinian::cli {

using nlohmann::ordered_json;

namespace {

struct ProbeArguments {
  SceneArguments scene;
  std::string pixel, output;
  double t = 0.0;  // 0: where alpha passes 0.5
  int samples = 256;
  bool json = false, quiet = false;
};

constexpr const char* examples = R"(
Examples:
  plinian probe ash --pixel 256,300
  plinian probe shot.plinian --pixel 256,300 -o probe.html
  plinian probe smoke.vdb --size 960x540 --pixel 480,200 --preset high --json
Pixels count from the upper left corner of a picture of --size, as in an image editor. Lights are probed where
alpha passes 0.5 on the pixel's ray, or at --at. 'exact' is what the reference computes, 'map' what the picture
reads from the light's transmittance map.)";

ordered_json as_json(const dvec3& v) {
  return {v.x, v.y, v.z};
}

ordered_json as_json(const ProbeReport& report) {
  ordered_json view = {
      {"origin", as_json(report.view.origin)},
      {"direction", as_json(report.view.direction)},
      {"depth", std::isfinite(report.view.depth) ? ordered_json(report.view.depth) : nullptr},
      {"samples", ordered_json::array()}};
  for (const ViewRayProbe::Sample& sample : report.view.samples)
    view["samples"].push_back({{"t", sample.t},
                               {"sigma_t", as_json(sample.sigma_t)},
                               {"transmittance", as_json(sample.transmittance)}});
  ordered_json lights = ordered_json::array();
  for (const LightRayProbe& light : report.lights) {
    ordered_json bounds = ordered_json::array(), samples = ordered_json::array();
    for (const LightRayProbe::Bounds& one : light.bounds)
      bounds.push_back(
          {{"k_min", one.k_min}, {"k_max", one.k_max}, {"dense", one.dense}, {"missed", one.missed}});
    for (const LightRayProbe::Sample& one : light.samples)
      samples.push_back({{"k", one.k}, {"exact", as_json(one.exact)}, {"map", as_json(one.map)}});
    lights.push_back({{"light", light.light},
                      {"k", light.k},
                      {"exact", as_json(light.exact)},
                      {"map", as_json(light.map)},
                      {"bounds", bounds},
                      {"samples", samples}});
  }
  ordered_json result = {{"input", report.scene},
                         {"pixel", {report.pixel.x, report.pixel.y}},
                         {"size", {report.size.x, report.size.y}},
                         {"view", view}};
  if (!report.view.samples.empty())
    result["point"] = {{"t", report.t}, {"position", as_json(report.view.at(report.t))}};
  result["lights"] = lights;
  return result;
}

std::string as_text(const ProbeReport& report) {
  const ViewRayProbe& view = report.view;
  std::string text =
      fmt::format("pixel {}, {} of {}x{}\n", report.pixel.x, report.pixel.y, report.size.x, report.size.y);
  if (view.samples.empty()) return text + "  its ray meets no medium\n";
  const dvec3 through = view.samples.back().transmittance, p = view.at(report.t);
  text +=
      fmt::format("  density between {:.4g} m and {:.4g} m; {:.3g} of the light behind gets through\n",
                  view.samples.front().t, view.samples.back().t, (through.x + through.y + through.z) / 3.0);
  text += std::isfinite(view.depth) ? fmt::format("  alpha passes 0.5 at {:.4g} m\n", view.depth)
                                    : std::string("  alpha stays under 0.5\n");
  text += fmt::format("at {:.4g} m: ({:.4g}, {:.4g}, {:.4g}) m\n\n", report.t, p.x, p.y, p.z);
  text += fmt::format("  {:<16}{:>28}{:>28}{:>12}\n", "transmittance", "exact (r g b)", "map (r g b)",
                      "map - exact");
  for (const LightRayProbe& light : report.lights) {
    const dvec3 difference = light.map - light.exact;
    double worst = 0.0;
    for (int c = 0; c < 3; ++c) worst = std::abs(difference[c]) > std::abs(worst) ? difference[c] : worst;
    const auto rgb = [](const dvec3& v) { return fmt::format("{:.4f} {:.4f} {:.4f}", v.x, v.y, v.z); };
    text +=
        fmt::format("  {:<16}{:>28}{:>28}{:>+12.4f}\n", light.light, rgb(light.exact), rgb(light.map), worst);
    for (const LightRayProbe::Bounds& bounds : light.bounds)
      text += bounds.missed
                  ? std::string("    its map's texel meets no medium\n")
                  : fmt::format("    at {:.4g} m of its ray; light fades from {:.4g} m and {} {:.4g} m\n",
                                light.k, bounds.k_min, bounds.dense ? "is dead at" : "comes out at",
                                bounds.k_max);
  }
  return text;
}

int run_probe(const ProbeArguments& arguments, const std::string& command_line) {
  set_quiet(arguments.quiet);
  if (!arguments.output.empty()) {
    if (!arguments.output.ends_with(".html"))
      throw std::runtime_error(arguments.output + ": the name of what probe writes ends in .html");
    check_writable(arguments.output);
  }
  const PreparedScene prepared = prepare_scene(arguments.scene);
  const SceneSnapshot& scene = prepared.snapshot;
  ProbeReport report;
  report.scene = arguments.scene.input;
  report.command = command_line;
  report.size = {scene.width, scene.height};
  char rest = 0;
  if (std::sscanf(arguments.pixel.c_str(), "%d,%d%c", &report.pixel.x, &report.pixel.y, &rest) != 2)
    throw std::runtime_error("--pixel: expected X,Y, as in 256,300, not '" + arguments.pixel + "'");
  if (report.pixel.x < 0 || report.pixel.y < 0 || report.pixel.x >= scene.width ||
      report.pixel.y >= scene.height)
    throw std::runtime_error(fmt::format("--pixel: {} lies outside the picture of {}x{} (--size)",
                                         arguments.pixel, scene.width, scene.height));
  const RayProbe probe(scene);
  report.view = probe.view_ray(report.pixel, arguments.samples);
  if (!report.view.samples.empty()) {
    report.t = arguments.t > 0.0 ? arguments.t : report.view.middle();
    for (std::size_t l = 0; l < scene.lights.size(); ++l)
      report.lights.push_back(probe.light_ray(report.view.at(report.t), l, arguments.samples));
  }
  if (!arguments.output.empty()) {
    write_file(arguments.output, std::string_view(probe_page(report)));
    note("written to " + arguments.output);
  }
  print(arguments.json ? as_json(report).dump(2) + "\n" : as_text(report));
  return exit_success;
}

}  // namespace

Run set_up_probe(CLI::App& app) {
  auto arguments = std::make_shared<ProbeArguments>();
  app.footer(examples);
  add_scene_arguments(app, arguments->scene, true);
  app.add_option("--pixel", arguments->pixel, "whose ray is followed")->type_name("X,Y")->required();
  app.add_option("--at", arguments->t, "distance from the camera of the point that lights are probed at [m]")
      ->type_name("METRES")
      ->check(CLI::PositiveNumber);
  app.add_option("--samples", arguments->samples, "of each curve")
      ->type_name("N")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  app.add_option("-o,--output", arguments->output, "a page with the curves, .html")->type_name("FILE");
  app.add_flag("--json", arguments->json, "for scripts, with the curves");
  app.add_flag("-q,--quiet", arguments->quiet, "no notes");
  return [arguments](const std::string& command_line) { return run_probe(*arguments, command_line); };
}

}  // namespace plinian::cli
