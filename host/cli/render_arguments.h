// What `plinian render` is asked for.
#pragma once

#include <string>
#include <vector>

#include "host/cli/prepared_scene.h"

namespace plinian::cli {

struct RenderArguments {
  SceneArguments scene;
  std::vector<std::string> outputs;
  std::string frames;             // "A-B", "A" or ""
  std::vector<std::string> vary;  // KEY=VALUE,VALUE,...
  std::string sheet;              // of the variants
  std::string renderer = "auto";
  int passes = 0;  // jittered passes; 0: until the picture rests, as the preset says
  float exposure = 0.0f;
  float gamma = 1.0f;
  std::string view;
  std::string pixels = "half", compression = "zip";
  double tolerance = 0.0;
  bool json = false, quiet = false;
};

/// A picture for each frame, but those that are there already. Returns the exit code.
int run_frames(const RenderArguments& arguments, const std::string& command_line);

/// Variants side by side on a sheet. Returns the exit code.
int run_variants(const RenderArguments& arguments);

}  // namespace plinian::cli
