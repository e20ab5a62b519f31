// Shapes and volumes from outside: a node that makes voxels, one that reads and thins them, and a shape that
// shows them.
#include <limits>

#include "host/sdk/plugin.h"

namespace {

using namespace plinian::sdk;

NodeType blob() {
  NodeType type("blob");
  const Attribute radius = type.add({.name = "radius", .default_value = "6", .affects = "out"});
  const Attribute hot = type.add({.name = "hot", .type = "bool", .affects = "out"});
  const Attribute fails = type.add({.name = "fails", .type = "bool", .affects = "out"});
  const Attribute spoiled =
      type.add({.name = "spoiled", .type = "int", .default_value = "-99", .affects = "out"});
  const Attribute begin =
      type.add({.name = "begin", .type = "int", .default_value = "-20", .affects = "out"});
  const Attribute side = type.add({.name = "side", .type = "int", .default_value = "41", .affects = "out"});
  const Attribute out =
      type.add({.name = "out", .type = "data", .data_type = "plinian.volume", .output = true});
  type.compute = [=](Context& context, Attribute) {
    const double r = context.number(radius);
    const bool failing = context.number(fails) != 0.0;
    const double bad_planes = context.number(spoiled);
    VolumeSource source;
    const auto first = std::int32_t(context.number(begin)), count = std::int32_t(context.number(side));
    source.first = {first, first, first};
    source.count = {count, count, count};
    source.object_from_index = scaled(0.5, 1.0, 0.0, 0.0);
    source.temperatures = context.number(hot) != 0.0;
    source.concurrent = true;
    source.fill = [=](const Voxel& first, float* density, float* temperature) {
      if (failing) throw Error("no more voxels");
      bool any = false;
      for (int i = 0; i < 512; ++i) {
        const int x = first[0] + i % 8, y = first[1] + i / 8 % 8, z = first[2] + i / 64;
        if (x * x + y * y + z * z > r * r) continue;
        density[i] = x >= bad_planes ? 2.0f
                     : y < 0         ? -1.0f
                     : y == 0        ? std::numeric_limits<float>::infinity()
                                     : std::numeric_limits<float>::quiet_NaN();
        if (temperature) temperature[i] = 1500.0f;
        any = true;
      }
      return any;
    };
    context.set(out, context.make_volume(source));
  };
  return type;
}

NodeType thin() {
  NodeType type("thin");
  const Attribute in =
      type.add({.name = "in", .type = "data", .data_type = "plinian.volume", .affects = "out"});
  const Attribute out =
      type.add({.name = "out", .type = "data", .data_type = "plinian.volume", .output = true});
  type.compute = [=](Context& context, Attribute) {
    const Volume volume = context.volume(in);
    if (!volume) throw Error("there is no volume");
    const VolumeInfo info = context.info(volume);
    std::vector<float> voxels = context.voxels(volume, info.first, info.count);
    for (float& density : voxels) density *= 0.5f;
    context.set(out, context.make_volume(
                         VolumeSource::dense(info.first, info.count, info.object_from_index, voxels)));
  };
  return type;
}

NodeType cloud() {
  NodeType type("cloud");
  const Attribute volume = type.add({.name = "volume", .type = "data", .data_type = "plinian.volume"});
  const Attribute density = type.add({.name = "density", .default_value = "1", .affects = "opacity"});
  const Attribute colour = type.add({.name = "colour", .type = "colour", .default_value = "0.9 0.8 0.7"});
  const Attribute g = type.add({.name = "g", .default_value = "0.3"});
  const Attribute lamp = type.add({.name = "lamp", .type = "bool"});
  const Attribute note = type.add({.name = "note", .type = "string", .of_picture = false});
  const Attribute opacity = type.add({.name = "opacity", .output = true});
  type.compute = [=](Context& context, Attribute) { context.set(opacity, 2.0 * context.number(density)); };
  type.contribute = [=](Context& context, Contribution& out) {
    Medium medium;
    medium.volume = context.volume(volume);
    if (!medium.volume) medium.shape = MediumShape::sphere;
    const auto c = context.vector(colour);
    medium.density_scale = float(context.number(density));
    medium.sigma_s = {c[0], c[1], c[2]};
    medium.phase = PhaseKind::henyey_greenstein;
    medium.g = float(context.number(g));
    medium.object_from_medium = scaled(3.0);
    out.add(medium);
    if (context.number(lamp) == 0.0) return;
    out.add(Light{.name = "Lamp", .type = LightType::spot, .toward = {0, 2, 0}, .position = {0, 5, 0}});
    out.add(Light{.type = LightType::ambient, .colour = {0.1f, 0.2f, 0.3f}, .exposure = 1.0f});
    out.add(Camera{.name = "Eye", .object_from_camera = scaled(1.0, 0, 0, 9), .focal_length = 50.0f});
    out.add_bounds({-1, -2, -3}, {1, 2, 3});
    out.add_bounds({0, 0, 0}, {4, 1, 1});
  };
  (void)note;
  return type;
}

void initialise(Plugin& plugin) {
  plugin.add(blob());
  plugin.add(thin());
  plugin.add(cloud());
}

}  // namespace

PLINIAN_PLUGIN("cloud", "1.0", "A. Artist", "node:blob node:thin node:cloud", initialise);
