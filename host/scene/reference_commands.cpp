// loadReference: the picture that others are compared with, or the plate behind them.
#include <filesystem>

#include "core/media/frame_sequence.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"
#include "host/graph/values/file_path.h"
#include "host/scene/scene_commands.h"

namespace plinian::scene {

using graph::Arguments;
using graph::CommandResult;
using graph::quote;
using graph::Session;

namespace {

bool is_plate(const graph::Node& node) {
  return graph::number_of(node.value(node.schema->find("place"))) == 0.0;
}

// A scene is compared with one picture and has one plate: who loads another means it instead.
void check_picture(const Session& session, const std::string& file) {
  const std::string path = graph::expand_path(file, session.scene_folder());
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error)) return;
  if (std::filesystem::is_directory(path, error))
    throw graph::GraphError("loadReference: " + path + ": is a folder, no picture");
  const auto pattern = FramePattern::parse(path);
  if (pattern && !pattern->frames_on_disk().empty()) return;
  throw graph::GraphError("loadReference: " + path +
                          (pattern ? ": no file of that sequence is there" : ": there is no such file"));
}

CommandResult load_reference(Session& session, const Arguments& arguments) {
  check_picture(session, arguments.text("file"));
  const bool plate = arguments.has("plate");
  std::string name;
  for (const graph::Node* node : session.graph().nodes())
    if (node->type->name() == "referenceImage" && is_plate(*node) == plate) name = node->name;
  if (name.empty()) {
    name = session.execute(std::string("createNode referenceImage -name ") + (plate ? "plate" : "reference"))
               .front();
    session.execute("setAttr " + name + ".place " + (plate ? "behind" : "beside"));
  }
  const std::string file = arguments.text("file");
  session.execute("setAttr " + name + ".file " + quote(file));
  session.execute("setAttr " + name + ".layer " + quote(arguments.text("layer")));
  session.execute("setAttr " + name + ".colour_space " + quote(arguments.text("colourSpace", "auto")));
  const graph::Plug time = session.graph().plug(name + ".time");
  const bool driven = !session.graph().find(time.node)->inputs_of(time.attribute, time.element).empty();
  if (FramePattern::parse(file) && !driven)
    session.execute("connectAttr " + session.graph().find(session.time_node())->name + ".out " + name +
                    ".time");
  return {name};
}

}  // namespace

void add_reference_commands(Workspace& workspace) {
  using enum graph::ArgumentKind;
  workspace.session().commands().add(
      {.name = "loadReference",
       .help =
           "Loads the picture that the view is compared with, or the plate behind it, and answers with its "
           "node.",
       .parameters = {{"file", path, ".exr, .png or a sequence of them, such as ref.####.exr"}},
       .flags = {{"plate", "it is shown behind what is rendered", {}},
                 {"layer", "of an EXR that has several (its colour)", text},
                 {"colourSpace", "auto, linear or srgb (auto: as the file says)", text}},
       .run = load_reference});
}

}  // namespace plinian::scene
