// One plug-in that is linked in.
#include "host/nodes/built_in.h"

#include "host/nodes/node_types.h"
#include "host/nodes/volume_store.h"

namespace plinian::nodes {

namespace {

void initialise(sdk::Plugin& plugin) {
  add_time(plugin);
  add_anim_curve(plugin);
  add_transform(plugin);
  add_medium(plugin);
  add_lights(plugin);
  add_ambient_light(plugin);
  add_camera(plugin);
  add_render_settings(plugin);
  add_reference_image(plugin);
  add_volume_noise(plugin);
  const auto store = std::make_shared<VolumeStore>();
  add_volume_read(plugin, store);
  add_reload(plugin, store);
}

PLINIAN_LINKED_PLUGIN(
    plugin, "nodes", "0.1.0", "Plinian",
    "node:time node:animCurve node:transform node:medium node:directionalLight node:spotLight "
    "node:pointLight node:ambientLight node:camera node:renderSettings node:referenceImage "
    "node:volumeNoise node:volumeRead command:reload",
    initialise);

}  // namespace

const PlinianLinkedPlugin& built_in_plugin() {
  return plugin;
}

void add_built_in(graph::Session& session, sdk::PluginManager& plugins) {
  plugins.add_linked(plugin);
  // What texts call by this name not every scene has.
  session.editor().graph().hint_at_node = [](std::string_view name) {
    return std::string(name == "settings" ? ": createNode renderSettings -name settings makes it" : "");
  };
  if (session.graph().size() == 0) session.new_scene();
}

}  // namespace plinian::nodes
