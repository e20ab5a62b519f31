// Scenes that are being edited, kept aside, so that a program that is killed loses little.
//
// Each running program has a file of its own and holds a lock on it; a file without a holder was left behind
// by a program that had no time to tidy up.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plinian::window {

class Autosave {
 public:
  /// folder: made when it is needed; empty: nothing is kept.
  explicit Autosave(std::filesystem::path folder);
  /// Forgets what was kept: the program ends in order.
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Keeps a scene's text in place of what was kept before. scene_path: its own file, or "". Throws
  /// FileError.
  void keep(const std::string& text, const std::string& scene_path);
  /// What was kept stays there for the next program.
  void leave();
  /// The scene was saved, or is of no interest any more.
  void forget();

  struct Left {
    std::filesystem::path file;  // to be opened
    std::string scene_path;      // of the scene that it was; empty where it had none
  };
  /// What others left behind, newest first.
  std::vector<Left> left_behind() const;
  static void discard(const Left& left);

 private:
  std::filesystem::path folder_, file_;  // file_: empty until something was kept
  int lock_ = -1;
};

}  // namespace plinian::window
