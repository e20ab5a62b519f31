// plinian sheet: pictures side by side, and under each, where it differs from a reference.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "core/files/atomic_file.h"
#include "core/image/contact_sheet.h"
#include "core/image/flip.h"
#include "core/image/heat_map.h"
#include "core/image/image_io.h"
#include "core/image/metrics.h"
#include "host/cli/command.h"
#include "host/cli/console.h"

namespace plinian::cli {

namespace {

struct SheetArguments {
  std::vector<std::string> inputs, labels;
  std::string output, reference, view;
  float exposure = 0.0f;
  int columns = 0;  // 0: all in one row
  bool quiet = false;
};

constexpr const char* examples = R"(
Examples:
  plinian sheet tfm.exr atfm.exr truth.exr -o sheet.png --label TFM --label ATFM --label reference
  plinian sheet fast.exr high.exr -o sheet.png --against truth.exr)";

// The mean and the map of FLIP at 0 stops.
SheetPicture heat_picture(const Image& picture, const Image& reference) {
  const PicturePair pair = pair_pictures(picture, reference);
  const FlipResult result = flip(pair.a, pair.reference, pair.width, pair.height, {});
  return {pair.width, pair.height, heat_bytes(result.map, 1.0f), fmt::format("FLIP {:.4f}", result.mean)};
}

int run_sheet(const SheetArguments& arguments) {
  set_quiet(arguments.quiet);
  check_output(arguments.output);
  if (std::filesystem::path(arguments.output).extension() != ".png")
    throw ImageError(arguments.output + ": the name of what sheet writes ends in .png");
  ViewSettings settings =
      arguments.view.empty() ? ViewSettings{.view = default_view()} : parse_view(arguments.view);
  settings.exposure = arguments.exposure;
  const ViewTransform view(settings), as_shown({.view = View::srgb});
  std::vector<Image> images;
  for (const std::string& input : arguments.inputs) images.push_back(read_image(input));
  std::vector<SheetPicture> pictures;
  for (std::size_t i = 0; i < images.size(); ++i)
    pictures.push_back(sheet_picture(images[i], images[i].display_referred ? as_shown : view,
                                     i < arguments.labels.size()
                                         ? arguments.labels[i]
                                         : std::filesystem::path(arguments.inputs[i]).stem().string()));
  int columns = arguments.columns > 0 ? arguments.columns : int(pictures.size());
  if (!arguments.reference.empty()) {
    // Under each picture its own map: one row of pictures, one of maps.
    const Image reference = read_image(arguments.reference);
    columns = int(pictures.size());
    for (const Image& image : images) pictures.push_back(heat_picture(image, reference));
  }
  const SheetPicture sheet = contact_sheet(pictures, columns);
  write_file(arguments.output, encode_png(sheet.rgb, sheet.width, sheet.height));
  note(fmt::format("{}: {} {}, {}x{}", arguments.output, pictures.size(),
                   pictures.size() == 1 ? "picture" : "pictures", sheet.width, sheet.height));
  return exit_success;
}

}  // namespace

Run set_up_sheet(CLI::App& app) {
  auto arguments = std::make_shared<SheetArguments>();
  app.footer(examples);
  app.add_option("PICTURES", arguments->inputs, "the pictures, .exr or .png")->required();
  app.add_option("-o,--output", arguments->output, "the sheet to write, .png")->type_name("FILE")->required();
  app.add_option("--label", arguments->labels,
                 "under the pictures, in their order (their names); may be repeated")
      ->type_name("TEXT")
      ->allow_extra_args(false);
  app.add_option("--against", arguments->reference, "a second row: FLIP heat maps against this picture")
      ->type_name("FILE");
  app.add_option("--columns", arguments->columns, "pictures in a row (all)")
      ->type_name("N")
      ->check(CLI::Range(1, 64));
  app.add_option("--exposure", arguments->exposure, "of EXR files")->type_name("STOPS");
  app.add_option("--view", arguments->view, "of EXR files: srgb, filmic, ocio or ocio:DISPLAY/VIEW")
      ->type_name("VIEW");
  app.add_flag("-q,--quiet", arguments->quiet, "no notes");
  return [arguments](const std::string&) { return run_sheet(*arguments); };
}

}  // namespace plinian::cli
