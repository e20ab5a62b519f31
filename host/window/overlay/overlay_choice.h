// What is drawn over the picture. No part of the scene, nor of any picture that is written.
#pragma once

#include <string>

namespace plinian::window {

struct OverlayChoice {
  bool grid = true, axes = true, scale_bar = true, bounds = true, icons = true, gate = true;
  bool drawings = true;  // of plug-ins
  bool handles = true;   // of what is selected
};

/// What is not drawn, a word a line, and back; words that are not understood are left out.
std::string text_of(const OverlayChoice& choice);
OverlayChoice read_overlay_choice(const std::string& text);

}  // namespace plinian::window
