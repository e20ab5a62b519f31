// Asks what a playblast is to be.
#pragma once

#include <string>

#include "host/window/panels/file_dialog.h"
#include "host/window/studio.h"

namespace plinian::window {

class PlayblastDialog {
 public:
  void open(Studio& studio);
  /// The browser stands over it where it asks for a path. Returns whether it is open.
  bool show(Studio& studio, FileDialog& browser);

 private:
  void set_path(const std::string& path);
  void render(Studio& studio);
  void show_path(Studio& studio);
  void show_problem();

  int first_ = 1, last_ = 1, format_ = 0;
  std::string path_;
  std::string problem_;          // why it could not begin, one line; until something else is asked for
  float problem_height_ = 0.0f;  // [points] that it had
  bool opens_ = false;
};

}  // namespace plinian::window
