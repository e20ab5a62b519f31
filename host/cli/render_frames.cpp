// plinian render --frames: a picture for each frame. What is there already, and would come out the same, is
// left as it is.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "core/media/frame_sequence.h"
#include "core/media/sequence_names.h"
#include "core/scene/nearest_word.h"
#include "core/scene/scene_loader.h"
#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/kept_setup.h"
#include "host/cli/picture.h"
#include "host/cli/reader_badges.h"

namespace plinian::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t most_frames = 1'000'000;

// "1-48", "12" or "1-48x4", every fourth; numbers may be negative.
std::vector<int> parse_range(const std::string& text, const std::string& all) {
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto number = [&](int& value) {
    const auto [rest, error] = std::from_chars(at, end, value);
    at = rest;
    return error == std::errc();
  };
  int first = 0, step = 1;
  bool good = number(first);
  int last = first;
  if (good && at != end) good = *at++ == '-' && number(last);
  if (good && at != end) good = *at++ == 'x' && number(step) && at == end && step > 0;
  if (!good)
    throw std::runtime_error(fmt::format(
        "--frames {}: expected FIRST-LAST, such as 1-48, also with a step, 1-48x4, or several: 1,3,10-20",
        all));
  if (last < first)
    throw std::runtime_error(
        fmt::format("--frames {}: the last frame comes before the first; --frames {}-{}", all, last, first));
  std::vector<int> frames;
  if ((std::int64_t(last) - first) / step >= most_frames)
    throw std::runtime_error(fmt::format("--frames {}: more than a million frames", all));
  for (std::int64_t frame = first; frame <= last; frame += step) frames.push_back(int(frame));
  return frames;
}

// Ranges between commas, as they are told at the end of a job; each frame once, in ascending order.
std::vector<int> parse_frames(const std::string& text) {
  std::set<int> frames;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    std::string part = text.substr(begin, end - begin);
    std::erase(part, ' ');
    const std::vector<int> range = parse_range(part, text);
    frames.insert(range.begin(), range.end());
    if (std::int64_t(frames.size()) > most_frames)
      throw std::runtime_error(fmt::format("--frames {}: more than a million frames", text));
    begin = end + 1;
  }
  return {frames.begin(), frames.end()};
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

// "1-3, 7": numbers in ascending order.
std::string ranges_text(const std::vector<int>& frames) {
  std::string text;
  for (std::size_t begin = 0; begin < frames.size();) {
    std::size_t end = begin + 1;
    while (end < frames.size() && frames[end] == frames[end - 1] + 1) ++end;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", frames[begin]);
    if (end - begin > 1) text += fmt::format("-{}", frames[end - 1]);
    begin = end;
  }
  return text;
}

// " (medium 3.2)": what the import has just said of the scale does not hold.
std::string scales_text(const KeptSetup& setup) {
  constexpr std::string_view attribute = ".density_scale ";
  std::vector<std::string> scales;
  for (const std::string& value : setup.values)
    if (const std::size_t at = value.find(attribute); at != value.npos)
      scales.push_back(value.substr(0, at) + " " + value.substr(at + attribute.size()));
  return scales.empty() ? "" : " (" + join(scales) + ")";
}

// What became of the frames.
struct Tally {
  int made = 0, skipped = 0;    // pictures of now and of before
  std::vector<int> incomplete;  // those of them in which a file is missing
  std::string reader;           // that misses the first
  std::vector<int> failed;      // no picture
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
};

// The frames of one job.
class FrameJob {
 public:
  FrameJob(const RenderArguments& arguments, const std::string& command_line)
      : arguments_(arguments),
        command_line_(command_line),
        frames_(parse_frames(arguments.frames)),
        patterns_(outputs_of(arguments)),
        writing_(write_options(arguments)) {
    for (const FramePattern& pattern : patterns_) check_output(pattern.path(frames_.front()), writing_);
    for (std::size_t i = 0; i < arguments.outputs.size(); ++i)
      if (!FramePattern::parse(arguments.outputs[i]))
        note(fmt::format("{}: frames are numbered, from {} on", arguments.outputs[i],
                         patterns_[i].path(frames_.front())));
    scene_ = prepare_scene(arguments.scene, FirstSnapshot::left_out);
    tell_one_file();
    keep_setup();
    // Nobody scrubs back: frames that are done need not stay in memory.
    session().evaluator().cache().set_budget(std::size_t(256) << 20);
    chosen_ = choose_renderer(arguments.renderer, {.reference_tolerance = arguments.tolerance});
  }

  int run() {
    bool cut_short = false;
    for (std::size_t i = 0; i < frames_.size() && !cut_short; ++i) try {
        cut_short = !render(frames_[i]);
      } catch (const RenderCancelled&) {
        cut_short = true;
      } catch (const SceneLoadCancelled&) {
        cut_short = true;
      }
    return tell(cut_short);
  }

 private:
  graph::Session& session() { return scene_.workspace->session(); }

  // Whoever names one file of a sequence and wants its frames means the sequence.
  void tell_one_file() const {
    const fs::path input = arguments_.scene.input;
    if (input.extension() != ".vdb" || frames_.size() == 1 || FramePattern::parse(input.string())) return;
    std::vector<std::string> names;
    std::error_code error;
    const fs::path folder = input.has_parent_path() ? input.parent_path() : fs::path(".");
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
      names.push_back(at->path().filename().string());
    for (const NameGroup& group : group_names(names))
      if (group.members.size() > 1 && std::ranges::any_of(group.members, [&](std::size_t member) {
            return names[member] == input.filename().string();
          }))
        warn(fmt::format("{} is one file, which every frame shows; the sequence is {}",
                         arguments_.scene.input, (input.parent_path() / group.name).string()));
  }

  // A scene of its own says it all; what is made of a sequence is settled by what is there of it.
  void keep_setup() {
    if (arguments_.scene.input.ends_with(".plinian")) return;
    if (const auto kept = find_setup(patterns_, arguments_.scene); kept && restore_setup(session(), *kept)) {
      note(
          fmt::format("camera, density scale{} and lights stay as {} has them: without the pictures they are "
                      "settled anew",
                      scales_text(*kept), kept->picture));
      if (!arguments_.scene.save_as.empty()) session().save_scene("");
    }
    setup_ = setup_text(session(), arguments_.scene);
  }

  // The scene at a frame; empty, and told, where it cannot be made: the other frames are worth having.
  std::optional<SceneSnapshot> snapshot_at(int frame, nlohmann::ordered_json& report) {
    try {
      session().execute(fmt::format("currentTime {}", frame));
      return take_snapshot(scene_);
    } catch (const SceneLoadCancelled&) {
      throw;
    } catch (const std::runtime_error& reason) {
      // What is wrong with many frames in the same way is told once.
      if (reason.what() != last_failure_) error(fmt::format("frame {}: {}", frame, reason.what()));
      last_failure_ = reason.what();
      report["error"] = last_failure_;
      return std::nullopt;
    }
  }

  // False where it was interrupted.
  bool render(int frame) {
    std::vector<std::string> outputs;
    for (const FramePattern& pattern : patterns_) outputs.push_back(pattern.path(frame));
    nlohmann::ordered_json report = {{"frame", frame}, {"outputs", outputs}};
    const std::optional<SceneSnapshot> snapshot = snapshot_at(frame, report);
    if (!snapshot) {
      tally_.failed.push_back(frame);
      tally_.report.push_back(std::move(report));
      return true;
    }
    const std::vector<std::string> missing = missing_files(session());
    const std::string job = job_hash(*snapshot, chosen_.name, arguments_);
    const bool skipped = std::all_of(outputs.begin(), outputs.end(),
                                     [&](const std::string& output) { return holds(output, job); });
    if (skipped) {
      note(fmt::format("{}: there already, made by the same scene, quality and version", join(outputs)));
    } else {
      Picture picture = make_picture(chosen_, *snapshot, arguments_, command_line_,
                                     fmt::format("frame {} of {}", frame, frames_.back()), job);
      // Half a picture must not pass for a whole one when the rest is made.
      if (picture.cut_short) return false;
      picture.image.metadata[attribute::frame] = frame;
      if (!setup_.empty()) picture.image.metadata[setup_attribute] = setup_;
      if (scene_.seed) picture.image.metadata[attribute::seed] = *scene_.seed;
      for (const std::string& output : outputs) write_image(output, picture.image, writing_);
      tell_picture(join(outputs), picture);
      report.update(picture_report(picture, outputs));
    }
    report["skipped"] = skipped;
    ++(skipped ? tally_.skipped : tally_.made);
    if (!missing.empty()) {
      if (tally_.incomplete.empty()) tally_.reader = missing.front().substr(0, missing.front().find(": "));
      tally_.incomplete.push_back(frame);
      report["missing"] = missing;
    }
    tally_.report.push_back(std::move(report));
    return true;
  }

  // The end of a job; returns its exit code.
  int tell(bool cut_short) const {
    const std::size_t all = frames_.size();
    if (arguments_.json)
      print(nlohmann::ordered_json{{"input", arguments_.scene.input},
                                   {"made", tally_.made},
                                   {"skipped", tally_.skipped},
                                   {"incomplete", tally_.incomplete},
                                   {"failed", tally_.failed},
                                   {"interrupted", cut_short},
                                   {"frames", tally_.report},
                                   {"notes", scene_.notes},
                                   {"warnings", scene_.warnings}}
                .dump(2) +
            "\n");
    if (!tally_.incomplete.empty())
      error(
          fmt::format("drawn without a file that is missing or cannot be read: frames {}; --set "
                      "{}.missing=hold fills such places with the frame before",
                      ranges_text(tally_.incomplete), tally_.reader));
    if (!tally_.failed.empty()) error(fmt::format("no picture of frames {}", ranges_text(tally_.failed)));
    if (cut_short) {
      warn(fmt::format("interrupted: {} of {} frames are done; the same command makes the rest",
                       tally_.made + tally_.skipped, all));
      return exit_cancelled;
    }
    note(fmt::format("{} of {} frames made, {} were there already", tally_.made, all, tally_.skipped));
    return tally_.incomplete.empty() && tally_.failed.empty() ? exit_success : exit_failure;
  }

  const RenderArguments& arguments_;
  const std::string& command_line_;
  const std::vector<int> frames_;  // ascending
  const std::vector<FramePattern> patterns_;
  const WriteOptions writing_;
  PreparedScene scene_;
  NamedRenderer chosen_;
  std::string setup_;         // what pictures carry of a setup that is settled; empty: nothing
  std::string last_failure_;  // that was told
  Tally tally_;
};

}  // namespace

int run_frames(const RenderArguments& arguments, const std::string& command_line) {
  return FrameJob(arguments, command_line).run();
}

}  // namespace plinian::cli
