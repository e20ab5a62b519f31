// The plug-in "atfm" and its node type "atfmVolume": the shape that draws a volume by adaptive transmittance
// maps.
//
// attribute  unit
// draw       a volume, or a box or ball of even density
// volume     what is drawn: of volumeRead, volumeNoise or another
// space      object_from_volume: of volumeRead, which knows which way is up in the file
// medium     how it looks: of medium
// visibility off: neither seen nor casting shadows
#include "host/sdk/plugin.h"

namespace {

using namespace plinian::sdk;

void initialise(Plugin& plugin) {
  NodeType type("atfmVolume");
  type.help = "A volume in the picture, lit through adaptive transmittance maps.";
  const Attribute draw =
      type.add({.name = "draw",
                .type = "enum",
                .help = "A volume, or a box from -1 to 1 or a ball of radius 1, of density 1.",
                .choices = "volume,box,sphere",
                .keyable = false});
  const Attribute volume = type.add({.name = "volume",
                                     .type = "data",
                                     .help = "What is drawn: connect a volumeRead or a volumeNoise.",
                                     .data_type = PLINIAN_VOLUME_TYPE});
  const Attribute space = type.add({.name = "space",
                                    .type = "matrix",
                                    .help = "Turns and scales the volume: connect the volumeRead's space.",
                                    .keyable = false});
  const Attribute medium = type.add({.name = "medium",
                                     .type = "data",
                                     .help = "How it takes up and scatters light: connect a medium.",
                                     .data_type = PLINIAN_MEDIUM_TYPE});
  type.add({.name = "visibility",
            .type = "bool",
            .default_value = "true",
            .help = "Off: neither seen nor casting shadows.",
            .of_picture = false});
  type.contribute = [=](Context& context, Contribution& contribution) {
    Medium m = look_of(context, medium);
    m.shape = MediumShape(std::uint32_t(context.number(draw)));
    if (m.shape == MediumShape::voxels) {
      m.volume = context.volume(volume);
      if (!m.volume) throw Error("no volume is connected");
      m.object_from_medium = context.matrix(space);
    }
    contribution.add(m);
  };
  plugin.add(type);
}

}  // namespace

PLINIAN_PLUGIN("atfm", "1.0", "Plinian", "node:atfmVolume", initialise);
