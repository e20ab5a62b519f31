// render FILE: the picture of the scene as it is.
#include "host/cli/render_command.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "host/cli/picture.h"
#include "host/cli/reader_badges.h"
#include "host/graph/graph_error.h"
#include "host/scene/missing_types.h"

namespace plinian::cli {

namespace {

// Kept from one call to the next, so that a script that renders often uploads once.
struct Kept {
  std::string wanted;
  NamedRenderer renderer;
  std::set<std::string> told;  // once is enough
};

graph::CommandResult render(scene::Workspace& workspace, Kept& kept, const graph::Arguments& words) {
  RenderArguments arguments;
  arguments.passes = int(words.number("passes").value_or(0.0));
  arguments.pixels = words.text("pixels", "half");
  if (words.has("passes") && (arguments.passes < 1 || arguments.passes > 65536))
    throw graph::GraphError("render: -passes expects an integer from 1 to 65536");
  if (arguments.pixels != "half" && arguments.pixels != "float")
    throw graph::GraphError("render: -pixels expects half or float");
  const std::string missing = scene::missing_types(workspace.session().graph());
  if (!missing.empty() && !words.has("skipUnknown"))
    throw graph::GraphError("render: " + missing +
                            ": load it with loadPlugin, or leave it out with "
                            "-skipUnknown");
  scene::SceneView view = workspace.view();
  view.skip_unknown = words.has("skipUnknown");
  if (words.has("size")) view.size = parse_size(words.text("size"), "-size");
  const WriteOptions writing = write_options(arguments);
  const std::string output = words.text("file");
  check_output(output, writing);
  const std::string wanted = words.text("renderer", "auto");
  if (!kept.renderer.renderer || kept.wanted != wanted) {
    kept.renderer = choose_renderer(wanted);
    kept.wanted = wanted;
  }
  const scene::BuiltSnapshot built = build_snapshot(workspace.session(), view);
  if (!built.problems.empty()) throw graph::GraphError("render: " + built.problems.front());
  for (const std::string& line : built.left_out)
    if (kept.told.insert(line).second) workspace.session().warn(line);
  for (const std::string& line : built.notes)
    if (kept.told.insert(line).second) workspace.session().note(line);
  for (const std::string& line : reader_badges(workspace.session()))
    if (kept.told.insert(line).second) workspace.session().warn(line);
  const Picture picture = make_picture(kept.renderer, built.snapshot, arguments, "", "rendering");
  if (picture.cut_short) throw RenderCancelled();
  write_image(output, picture.image, writing);
  tell_picture(output, picture);
  return {output};
}

}  // namespace

void add_render_command(scene::Workspace& workspace) {
  using enum graph::ArgumentKind;
  const auto kept = std::make_shared<Kept>();
  workspace.session().commands().add(
      {.name = "render",
       .help = "Makes a picture of the scene as it is and answers with the file.",
       .parameters = {{"file", path, ".exr or .png"}},
       .flags = {{"renderer", "auto, gl, cpu or reference (auto)", text},
                 {"passes", "exactly so many (as the quality set says)", integer},
                 {"pixels", "of an EXR: half or float (half)", text},
                 {"size", "WIDTHxHEIGHT, such as 1280x720 (as renderSettings says, or 512x512)", text},
                 {"skipUnknown", "leaves out nodes whose plug-ins are missing", {}}},
       .run = [&workspace, kept](graph::Session&, const graph::Arguments& words) -> graph::CommandResult {
         try {
           return render(workspace, *kept, words);
         } catch (const graph::GraphError&) {
           throw;
         } catch (const RenderCancelled&) {
           throw;
         } catch (const std::runtime_error& error) {
           throw graph::GraphError(std::string("render: ") + error.what());
         }
       }});
}

}  // namespace plinian::cli
