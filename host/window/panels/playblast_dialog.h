// Asks what a playblast is to be.
#pragma once

#include "host/window/studio.h"

namespace plinian::window {

class PlayblastDialog {
 public:
  void open(Studio& studio);
  void show(Studio& studio);

 private:
  int first_ = 1, last_ = 1, format_ = 0;
  char path_[2048] = "";
  bool opens_ = false;
};

}  // namespace plinian::window
