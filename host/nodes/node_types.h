// The built-in node types, one file each, registered as anyone's are.
#pragma once

#include <memory>

#include "host/sdk/plugin.h"

namespace plinian::nodes {

class VolumeStore;

void add_time(sdk::Plugin& plugin);
void add_anim_curve(sdk::Plugin& plugin);
void add_transform(sdk::Plugin& plugin);
void add_medium(sdk::Plugin& plugin);
/// directionalLight, spotLight and pointLight.
void add_lights(sdk::Plugin& plugin);
void add_ambient_light(sdk::Plugin& plugin);
void add_camera(sdk::Plugin& plugin);
void add_render_settings(sdk::Plugin& plugin);
void add_volume_noise(sdk::Plugin& plugin);
void add_reference_image(sdk::Plugin& plugin);
/// store: shared with other nodes that read files.
void add_volume_read(sdk::Plugin& plugin, std::shared_ptr<VolumeStore> store);
void add_reload(sdk::Plugin& plugin, std::shared_ptr<VolumeStore> store);

}  // namespace plinian::nodes
