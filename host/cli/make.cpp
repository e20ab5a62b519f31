// plinian make: a procedural medium as a .vdb file.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "core/files/atomic_file.h"
#include "core/media/procedural.h"
#include "core/media/vdb_writer.h"
#include "core/scene/nearest_word.h"
#include "core/scene/renderer.h"
#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/progress.h"

namespace plinian::cli {

namespace {

struct MakeArguments {
  ProceduralSettings settings;
  std::string output;
  std::vector<std::string> set;
  bool quiet = false;
};

const std::string examples = R"(
Examples:
  plinian make ash -o ash.vdb
  plinian make explosion -o explosion.vdb --resolution 128 --seed 7
  plinian make ash -o ash.vdb --set veils=2 --set spread=1.3
The same kind, resolution, seed and shape make the same volume in every run.
)";

// "  billow_size  1 in [0.5, 2]: ..." for each kind, so that --help says what --set takes.
std::string shape_help() {
  std::string text;
  for (const std::string& kind : procedural_kinds()) {
    text += "\nShape of " + kind + ":\n";
    for (const ProceduralParameter& parameter : procedural_parameters(kind))
      text += fmt::format("  {:<14} {:g} in [{:g}, {:g}]: {}\n", parameter.name, parameter.default_value,
                          parameter.low, parameter.high, parameter.help);
  }
  return text;
}

int run_make(MakeArguments arguments) {
  set_quiet(arguments.quiet);
  const auto kinds = procedural_kinds();
  if (std::find(kinds.begin(), kinds.end(), arguments.settings.kind) == kinds.end())
    throw std::runtime_error(fmt::format("{}: no such medium{}; there are: {}", arguments.settings.kind,
                                         did_you_mean(arguments.settings.kind, kinds), join(kinds)));
  if (!arguments.output.ends_with(".vdb"))
    throw std::runtime_error(arguments.output + ": the name of what make writes ends in .vdb");
  for (const std::string& text : arguments.set) {
    const auto equals = text.find('=');
    char* end = nullptr;
    const float value = equals == std::string::npos ? 0.0f : std::strtof(text.c_str() + equals + 1, &end);
    if (!end || *end != '\0' || end == text.c_str() + equals + 1)
      throw std::runtime_error("--set " + text + ": expected SHAPE=NUMBER; --help lists them");
    arguments.settings.shape[text.substr(0, equals)] = value;
  }
  check_writable(arguments.output);
  std::shared_ptr<const BrickVolume> volume;
  try {
    ProgressBar bar("making");
    volume = make_procedural(arguments.settings, [&](double share) { return bar(share); });
  } catch (const ProceduralCancelled&) {
    throw RenderCancelled();
  }
  write_vdb(arguments.output, *volume);
  note(fmt::format("{}: {} at {} voxels, seed {}, {} active voxels, {}", arguments.output,
                   arguments.settings.kind, arguments.settings.resolution, arguments.settings.seed,
                   volume->active_voxels, bytes_text(double(std::filesystem::file_size(arguments.output)))));
  return exit_success;
}

}  // namespace

Run set_up_make(CLI::App& app) {
  auto arguments = std::make_shared<MakeArguments>();
  app.footer(examples + shape_help());
  app.add_option("KIND", arguments->settings.kind, join(procedural_kinds()))->required();
  app.add_option("-o,--output", arguments->output, "file to write")->type_name("FILE.vdb")->required();
  app.add_option("--resolution", arguments->settings.resolution, "voxels along the longest side")
      ->type_name("N")
      ->check(CLI::Range(16, 1024))
      ->capture_default_str();
  app.add_option("--seed", arguments->settings.seed, "another one of the kind")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--set", arguments->set, "a number that shapes it, listed below; may be repeated")
      ->type_name("SHAPE=VALUE")
      ->allow_extra_args(false);
  app.add_flag("-q,--quiet", arguments->quiet, "no notes");
  return [arguments](const std::string&) { return run_make(*arguments); };
}

}  // namespace plinian::cli
