// The command "render" of scripts.
#pragma once

#include "host/scene/workspace.h"

namespace plinian::cli {

/// Adds it to a workspace, which must outlive its commands.
void add_render_command(scene::Workspace& workspace);

}  // namespace plinian::cli
