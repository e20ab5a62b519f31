// The node type "referenceImage": a picture to compare with, shown in the view and never rendered.
//
// attribute  unit
// file       .exr or .png, or a sequence of them
// time       frames; the scene's time drives it
// layer      of an EXR that has several; empty: its colour
// colour_space of the file's values; auto: as the file says
// place      behind what is rendered, over it, or beside it
// opacity    -
// exposure   stops on an EXR
// camera     shown where this camera is looked through; none: everywhere
// image      what was read
#include "core/image/image_io.h"
#include "core/media/frame_sequence.h"
#include "core/scene/scene_parameters.h"
#include "host/nodes/core_attributes.h"
#include "host/nodes/node_types.h"

namespace plinian::nodes {

void add_reference_image(sdk::Plugin& plugin) {
  sdk::NodeType type("referenceImage");
  type.help = "A picture to compare with: shown in the view, never rendered.";
  const sdk::Attribute file = type.add({.name = "file",
                                        .type = "path",
                                        .help = "An .exr or .png file, or a sequence: plate.####.exr.",
                                        .affects = "image",
                                        .widget = "file .exr .png"});
  const sdk::Attribute time = type.add({.name = "time",
                                        .type = "time",
                                        .default_value = "1",
                                        .help = "The frame of a sequence; connect the scene's time.",
                                        .unit = "frames",
                                        .affects = "image"});
  type.add({.name = "layer", .type = "string", .help = "Of an EXR that has several; empty: its colour."});
  type.add({.name = "colour_space",
            .type = "enum",
            .help = "What the file's values are: as the file says, linear Rec.709, or sRGB.",
            .choices = "auto,linear,srgb"});
  type.add({.name = "place",
            .type = "enum",
            .help = "Where it is shown: behind what is rendered, over it, or beside it.",
            .choices = "behind,over,beside"});
  type.add({.name = "opacity",
            .default_value = "1",
            .help = "0: not seen; 1: hides what is behind it.",
            .minimum = 0,
            .maximum = 1});
  type.add(attribute_of(light_parameters(), "exposure",
                        {.help = "On an EXR.", .soft_minimum = -8, .soft_maximum = 8}));
  type.add({.name = "camera",
            .type = "node",
            .help = "Shown where this camera is looked through; none: everywhere.",
            .keyable = false});
  const sdk::Attribute image = type.add(
      {.name = "image", .type = "data", .help = "What was read.", .data_type = "image", .output = true});
  type.compute = [=](sdk::Context& context, sdk::Attribute) {
    std::string path = context.text(file);
    if (path.empty()) throw sdk::Error("no file is set");
    if (const auto pattern = FramePattern::parse(path)) path = pattern->path(int(context.number(time)));
    auto read = std::make_unique<const Image>(read_image(path));
    const std::size_t bytes = read->channels.size() * read->pixel_count() * sizeof(float);
    context.set_data(image, "image", std::move(read), bytes);
  };
  plugin.add(type);
}

}  // namespace plinian::nodes
