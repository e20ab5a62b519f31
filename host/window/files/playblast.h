// A playblast: frames of the scene as it is seen, rendered beside the window by the program itself.
//
// There is no second way to render a sequence: the scene is written aside and `plinian render --frames` makes
// the pictures, in a process of its own with less of a claim to the processor. A film is made of them by
// ffmpeg, where it is installed.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/image/view_transform.h"

namespace plinian::window {

struct PlayblastSettings {
  int first = 1, last = 1;       // [frames]
  std::string output;            // .png or .exr, with or without a place for the number; .mp4
  double rate = 24.0;            // [frames/s] of a film
  std::string quality = "fast";  // the set that is on
  ViewSettings view;
};

/// The output with another extension, ".png": a film is one file, and has no place for a frame's number; what
/// is numbered has one, "shot.####.png" of "shot.mp4".
std::string as_format(const std::string& output, const std::string& extension);

/// "filmic", "ocio:DISPLAY/VIEW": a view as `render --view` takes it.
std::string view_words(const ViewSettings& view);

class Playblast {
 public:
  /// program: that renders; by default the one that runs.
  explicit Playblast(std::string program = "") : program_(std::move(program)) {}
  /// Ends what runs.
  ~Playblast();
  Playblast(const Playblast&) = delete;
  Playblast& operator=(const Playblast&) = delete;

  static bool has_ffmpeg();

  /// scene: its text; folder: that paths in it are relative to, where it is written aside. Throws
  /// std::runtime_error, one line: a range or an output that cannot be, a folder that takes no files, one
  /// that is running.
  void start(const PlayblastSettings& settings, const std::string& scene,
             const std::filesystem::path& folder);
  void cancel();
  bool is_running() const { return child_ > 0; }
  int frames_done() const { return done_; }
  int frames() const { return settings_.last - settings_.first + 1; }
  const PlayblastSettings& settings() const { return settings_; }

  struct End {
    bool succeeded = false;
    std::string line;  // what there is to say
  };
  /// Looks how far it is; returns how it ended, once. To be called once a turn.
  std::vector<End> poll();

 private:
  void run(const std::vector<std::string>& words);
  void read_words();
  void tidy_up();
  End ended(int status);

  void begin();
  void begin_film();

  std::string program_;
  PlayblastSettings settings_;
  std::filesystem::path scene_, frames_folder_;  // written aside; the second for a film
  pid_t child_ = -1;
  int words_from_ = -1;  // what it says
  std::string said_;
  int done_ = 0, left_ = 0;                 // frames; left_: that were there already, among the others
  bool cancelled_ = false, films_ = false;  // films_: ffmpeg runs
};

}  // namespace plinian::window
