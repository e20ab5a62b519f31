#include "host/scene/quality_set.h"

#include "core/scene/quality_parameters.h"
#include "host/scene/snapshot.h"

namespace plinian::scene {

void write_quality(graph::Session& session, const std::string& set, const Quality& quality) {
  const graph::Node* settings = first_of_type(session.graph(), "renderSettings");
  if (!settings) {
    session.execute("createNode renderSettings -name settings");
    settings = first_of_type(session.graph(), "renderSettings");
  }
  const auto write = [&](const std::string& path, const std::string& words) {
    const graph::Plug plug = graph::Graph::plug(*settings, path);
    if (session.editor().set_problem(plug).empty())
      session.execute("setAttr " + session.graph().name_of(plug) + " " + words);
  };
  for (const Parameter<Quality>& parameter : quality_parameters())
    write(set + "." + parameter.spec.name, to_text(parameter.spec, *parameter.get(quality)));
  write(set + ".preset", graph::quote(quality.name));
}

}  // namespace plinian::scene
