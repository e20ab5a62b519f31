// Commands about looking at a scene, beside those that edit its graph.
#pragma once

#include "host/scene/workspace.h"

namespace plinian::scene {

/// preset.
void add_preset_commands(Workspace& workspace);
/// quality, isolate, frameView, snapshot.
void add_view_commands(Workspace& workspace);
/// parent, which keeps nodes where they are in the world.
void extend_parent_command(Workspace& workspace);
/// loadReference.
void add_reference_commands(Workspace& workspace);

}  // namespace plinian::scene
