// The node type "volumeNoise": the procedural media.
//
// attribute      unit
// kind           ash, cloud, sandstorm or explosion
// resolution     voxels along a side
// seed           another one of the same kind
// KIND.NAME      the numbers that shape each kind, as core/media/procedural.h declares them
// volume         what comes of it
#include "core/media/procedural.h"
#include "core/scene/scene_hash.h"
#include "core/scene/scene_parameters.h"
#include "host/nodes/core_attributes.h"
#include "host/nodes/node_types.h"
#include "host/sdk/volume_table.h"

namespace plinian::nodes {

namespace {

struct Kind {
  std::string name;
  std::vector<ProceduralParameter> parameters;
  sdk::Attribute first;  // of its shape; the others follow it
};

}  // namespace

void add_volume_noise(sdk::Plugin& plugin) {
  sdk::NodeType type("volumeNoise");
  type.help = "A procedural medium: ash, cloud, sandstorm or explosion, made anew wherever it is opened.";
  std::string words;
  for (const std::string& kind : procedural_kinds()) words += (words.empty() ? "" : ",") + kind;
  const sdk::Attribute kind = type.add(
      {.name = "kind", .type = "enum", .help = "What it looks like.", .choices = words, .affects = "volume"});
  const sdk::Attribute resolution =
      type.add(attribute_of(medium_parameters(), "resolution",
                            {.default_value = std::to_string(ProceduralSettings().resolution),
                             .help = "Voxels along a side.",
                             .affects = "volume",
                             .soft_maximum = 512}));
  const sdk::Attribute seed = type.add(attribute_of(medium_parameters(), "seed",
                                                    {.default_value = "1",
                                                     .help = "Another one of the same kind.",
                                                     .affects = "volume",
                                                     .soft_maximum = 100}));
  std::vector<Kind> kinds;
  for (const std::string& name : procedural_kinds()) {
    Kind entry{name, procedural_parameters(name), {}};
    sdk::AttributeSpec shape{.name = name,
                             .type = "compound",
                             .help = "The shape of " + name + ".",
                             .group = "Shape",
                             .affects = "volume",
                             .children = {},
                             .widget = "",
                             .shown_when = "kind=" + name};
    for (const ProceduralParameter& p : entry.parameters)
      shape.children.push_back({.name = p.name,
                                .default_value = spelled(p.default_value),
                                .help = p.help,
                                .minimum = double(p.low),
                                .maximum = double(p.high)});
    entry.first = {type.add(shape).index + 1};
    kinds.push_back(std::move(entry));
  }
  const sdk::Attribute volume =
      type.add({.name = "volume",
                .type = "data",
                .help = "The medium's density, and its temperature where it is hot.",
                .data_type = PLINIAN_VOLUME_TYPE,
                .output = true});
  type.compute = [=](sdk::Context& context, sdk::Attribute) {
    const Kind& chosen = kinds.at(std::size_t(context.number(kind)));
    ProceduralSettings settings;
    settings.kind = chosen.name;
    settings.resolution = int(context.number(resolution));
    settings.seed = std::uint32_t(context.number(seed));
    for (std::size_t i = 0; i < chosen.parameters.size(); ++i) {
      const ProceduralParameter& parameter = chosen.parameters[i];
      const float value = float(context.number({chosen.first.index + std::int32_t(i)}));
      if (value != parameter.default_value) settings.shape[parameter.name] = value;
    }
    std::shared_ptr<const BrickVolume> made;
    try {
      made = make_procedural(settings, [&](double share) {
        context.progress(share, "making " + chosen.name);
        return !context.cancelled();
      });
    } catch (const ProceduralCancelled&) {
      return;
    }
    const std::uint64_t content = volume_hash(*made);
    sdk::write_volume(context.plain(), volume.index, std::move(made), content);
  };
  plugin.add(type);
}

}  // namespace plinian::nodes
