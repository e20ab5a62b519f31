// A puff of smoke with a bumpy skin: a shape that makes its own voxels.
#include <algorithm>
#include <cmath>

#include "host/sdk/plugin.h"

using namespace plinian::sdk;

namespace {

// Density at a distance [radii] from the middle, in a direction: 1 inside, falling over the skin.
float density_at(double x, double y, double z, double bumps, double skin) {
  const double distance = std::sqrt(x * x + y * y + z * z);
  const double surface =
      0.8 + bumps * 0.2 * std::sin(9.0 * x) * std::sin(9.0 * y + 1.0) * std::sin(9.0 * z + 2.0);
  return float(std::clamp((surface - distance) / skin + 0.5, 0.0, 1.0));
}

void initialise(Plugin& plugin) {
  NodeType type("puff");
  type.help = "A puff of smoke of radius 1.";
  const Attribute resolution = type.add({.name = "resolution",
                                         .type = "int",
                                         .default_value = "64",
                                         .help = "Voxels along a side.",
                                         .minimum = 8.0,
                                         .maximum = 512.0,
                                         .keyable = false});
  const Attribute bumps = type.add(
      {.name = "bumps", .default_value = "0.5", .help = "How uneven it is.", .minimum = 0.0, .maximum = 1.0});
  const Attribute medium = type.add({.name = "medium",
                                     .type = "data",
                                     .help = "How it takes up and scatters light: connect a medium.",
                                     .data_type = PLINIAN_MEDIUM_TYPE});
  type.contribute = [=](Context& context, Contribution& contribution) {
    const auto side = std::int32_t(context.number(resolution));
    const double amount = context.number(bumps), voxel = 2.0 / side;
    VolumeSource source;
    source.count = {side, side, side};
    source.object_from_index = scaled(voxel, -1.0 + voxel / 2.0, -1.0 + voxel / 2.0, -1.0 + voxel / 2.0);
    source.concurrent = true;
    source.fill = [=](const Voxel& first, float* density, float*) {
      bool any = false;
      for (int i = 0; i < 512; ++i) {
        const auto place = [&](int axis, int offset) {
          return voxel * (first[std::size_t(axis)] + offset + 0.5) - 1.0;
        };
        density[i] = density_at(place(0, i & 7), place(1, i >> 3 & 7), place(2, i >> 6), amount, 0.1);
        any = any || density[i] > 0.0f;
      }
      return any;
    };
    Medium m = look_of(context, medium);
    m.volume = context.make_volume(source);
    m.object_from_medium = identity;
    contribution.add(m);
  };
  plugin.add(type);
}

}  // namespace

PLINIAN_PLUGIN("puff", "1.0", "A. Artist", "node:puff", initialise);
