// One snapshot made into one picture, with all that is to be known of how it was made.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/image/image_io.h"
#include "host/cli/render_arguments.h"
#include "host/cli/renderers.h"

namespace plinian::cli {

struct Picture {
  Image image;
  RenderStats stats;
  std::string renderer, preset, scene_hash;
  std::string most;        // "at most 32 passes"
  bool cut_short = false;  // Ctrl-C ended it before it was done
  double load_ms = 0.0, render_ms = 0.0;
};

/// What is written, and how. Throws where an output cannot be, before any time is spent.
WriteOptions write_options(const RenderArguments& arguments);

/// Renders a snapshot; Ctrl-C lets the current pass end and keeps what there is. label: of the progress bar.
/// job: stored in the picture where it is not empty; last: the renderer is let go. Throws RenderCancelled
/// where the renderer has no passes.
Picture make_picture(NamedRenderer& renderer, const SceneSnapshot& snapshot, const RenderArguments& arguments,
                     const std::string& command_line, const std::string& label, const std::string& job = "",
                     bool last = false);

/// Everything that a picture depends on, as a number: scene, quality, renderer, passes, view and version.
std::string job_hash(const SceneSnapshot& snapshot, const std::string& renderer,
                     const RenderArguments& arguments);

/// "ash.png: gl, fast, 512x512, 12 passes in 0.31 s (maps 8 ms)".
void tell_picture(const std::string& outputs, const Picture& picture);

/// For --json: what is true of one picture.
nlohmann::ordered_json picture_report(const Picture& picture, const std::vector<std::string>& outputs);

}  // namespace plinian::cli
