// plinian render --frames: a picture for each frame. What is there already, and would come out the same, is
// left as it is.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/media/frame_sequence.h"
#include "core/scene/nearest_word.h"
#include "core/scene/scene_loader.h"
#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/kept_setup.h"
#include "host/cli/picture.h"

namespace plinian::cli {

namespace fs = std::filesystem;

namespace {

struct FrameRange {
  int first = 1, last = 1;
};

// "1-48" or "12"; either may be negative.
FrameRange parse_frames(const std::string& text) {
  FrameRange range;
  const char* const end = text.data() + text.size();
  auto [rest, error] = std::from_chars(text.data(), end, range.first);
  bool good = error == std::errc();
  range.last = range.first;
  if (good && rest != end) {
    good = *rest == '-';
    if (good) {
      const auto second = std::from_chars(rest + 1, end, range.last);
      good = second.ec == std::errc() && second.ptr == end;
    }
  }
  if (good && range.last < range.first)
    throw std::runtime_error(fmt::format("--frames {}: the last frame comes before the first; --frames {}-{}",
                                         text, range.last, range.first));
  if (good && std::int64_t(range.last) - range.first >= 1'000'000)
    throw std::runtime_error(fmt::format("--frames {}: more than a million frames", text));
  if (!good) throw std::runtime_error(fmt::format("--frames {}: expected FIRST-LAST, such as 1-48", text));
  return range;
}

// "out.exr" becomes "out.####.exr".
FramePattern output_pattern(const std::string& output) {
  if (const auto pattern = FramePattern::parse(output)) return *pattern;
  const fs::path path(output);
  return *FramePattern::parse(
      (path.parent_path() / (path.stem().string() + ".####" + path.extension().string())).string());
}

std::vector<FramePattern> outputs_of(const RenderArguments& arguments) {
  std::vector<FramePattern> patterns;
  for (const std::string& output : arguments.outputs) patterns.push_back(output_pattern(output));
  if (patterns.empty())
    patterns.push_back(
        output_pattern(fs::path(arguments.scene.input).filename().replace_extension(".png").string()));
  return patterns;
}

// Whether a picture was made, to its end, by exactly this job.
bool holds(const std::string& path, const std::string& job) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  try {
    const Image image = read_image(path);
    const auto found = image.metadata.find(attribute::job_hash);
    const auto* text = found == image.metadata.end() ? nullptr : std::get_if<std::string>(&found->second);
    return text && *text == job;
  } catch (const ImageError&) {
    return false;  // half written, or something else: made anew
  }
}

}  // namespace

int run_frames(const RenderArguments& arguments, const std::string& command_line) {
  const FrameRange range = parse_frames(arguments.frames);
  const std::vector<FramePattern> patterns = outputs_of(arguments);
  const WriteOptions writing = write_options(arguments);
  for (const FramePattern& pattern : patterns) check_output(pattern.path(range.first), writing);
  for (std::size_t i = 0; i < arguments.outputs.size(); ++i)
    if (!FramePattern::parse(arguments.outputs[i]))
      note(fmt::format("{}: frames are numbered, from {} on", arguments.outputs[i],
                       patterns[i].path(range.first)));

  PreparedScene scene = prepare_scene(arguments.scene);
  graph::Session& session = scene.workspace->session();
  // A scene of its own says it all; what is made of a sequence is settled by what is there of it.
  const bool settles = !arguments.scene.input.ends_with(".plinian");
  if (const auto kept = settles ? find_setup(patterns, arguments.scene) : std::nullopt;
      kept && restore_setup(session, *kept)) {
    note(fmt::format(
        "camera, scale and lights stay as {} has them: without the pictures they are settled anew",
        kept->picture));
    if (!arguments.scene.save_as.empty()) session.save_scene("");
  }
  const std::string setup = settles ? setup_text(session, arguments.scene) : "";
  // Nobody scrubs back: frames that are done need not stay in memory.
  session.evaluator().cache().set_budget(std::size_t(256) << 20);
  NamedRenderer chosen = choose_renderer(arguments.renderer, {.reference_tolerance = arguments.tolerance});
  nlohmann::ordered_json frames = nlohmann::ordered_json::array();
  int made = 0, left = 0;
  bool cut_short = false;
  for (int frame = range.first; frame <= range.last && !cut_short; ++frame) {
    std::vector<std::string> outputs;
    for (const FramePattern& pattern : patterns) outputs.push_back(pattern.path(frame));
    try {
      session.execute(fmt::format("currentTime {}", frame));
      const SceneSnapshot snapshot = take_snapshot(scene);
      const std::string job = job_hash(snapshot, chosen.name, arguments);
      if (std::all_of(outputs.begin(), outputs.end(),
                      [&](const std::string& output) { return holds(output, job); })) {
        note(fmt::format("{}: there already, made by the same scene, quality and version", join(outputs)));
        frames.push_back({{"frame", frame}, {"outputs", outputs}, {"skipped", true}});
        ++left;
        continue;
      }
      Picture picture = make_picture(chosen, snapshot, arguments, command_line,
                                     fmt::format("frame {} of {}", frame, range.last), job);
      // Half a picture must not pass for a whole one when the rest is made.
      cut_short = picture.cut_short;
      if (cut_short) break;
      picture.image.metadata[attribute::frame] = frame;
      if (settles) picture.image.metadata[setup_attribute] = setup;
      if (scene.seed) picture.image.metadata[attribute::seed] = *scene.seed;
      for (const std::string& output : outputs) write_image(output, picture.image, writing);
      tell_picture(join(outputs), picture);
      nlohmann::ordered_json report = {{"frame", frame}};
      report.update(picture_report(picture, outputs));
      report["skipped"] = false;
      frames.push_back(std::move(report));
      ++made;
    } catch (const RenderCancelled&) {
      cut_short = true;
    } catch (const SceneLoadCancelled&) {
      cut_short = true;
    }
  }
  const int all = range.last - range.first + 1;
  if (arguments.json)
    print(nlohmann::ordered_json{{"input", arguments.scene.input},
                                 {"made", made},
                                 {"skipped", left},
                                 {"interrupted", cut_short},
                                 {"frames", frames},
                                 {"notes", scene.notes},
                                 {"warnings", scene.warnings}}
              .dump(2) +
          "\n");
  if (cut_short) {
    warn(fmt::format("interrupted: {} of {} frames are done; the same command makes the rest", made + left,
                     all));
    return exit_cancelled;
  }
  note(fmt::format("{} of {} frames made, {} were there already", made, all, left));
  return exit_success;
}

}  // namespace plinian::cli
