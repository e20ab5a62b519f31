// The built-in node types, one file each, registered as anyone's are.
#pragma once

#include "host/sdk/plugin.h"

namespace plinian::nodes {

void add_time(sdk::Plugin& plugin);
void add_anim_curve(sdk::Plugin& plugin);

}  // namespace plinian::nodes
