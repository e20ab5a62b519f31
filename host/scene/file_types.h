// What the command `import` takes beside scenes: volumes, neutral scenes, and cameras of other programs.
#pragma once

#include "host/graph/commands/session.h"

namespace plinian::scene {

/// .vdb (also a sequence): its media, placed and scaled. .json: a neutral scene.
void add_scene_importers(graph::Session& session);
/// .chan and the camera in the header of an .exr.
void add_camera_importers(graph::Session& session);

}  // namespace plinian::scene
