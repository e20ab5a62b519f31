// What is drawn over the picture. No part of the scene, nor of any picture that is written.
#pragma once

namespace plinian::window {

struct OverlayChoice {
  bool grid = true, axes = true, scale_bar = true, bounds = true, icons = true, gate = true;
  bool drawings = true;  // of plug-ins
};

}  // namespace plinian::window
