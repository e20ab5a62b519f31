#include "host/scene/quality_set.h"

#include "core/scene/quality_parameters.h"
#include "host/scene/preset_writer.h"
#include "host/scene/snapshot.h"

namespace plinian::scene {

void write_quality(graph::Session& session, const std::string& set, const Quality& quality) {
  const graph::Node* settings = first_of_type(session.graph(), "renderSettings");
  if (!settings) {
    session.execute("createNode renderSettings -name settings");
    settings = first_of_type(session.graph(), "renderSettings");
  }
  PresetWriter writer(session, *settings);
  for (const Parameter<Quality>& parameter : quality_parameters())
    writer.write(set + "." + parameter.spec.name, to_text(parameter.spec, *parameter.get(quality)));
  writer.write(set + ".preset", graph::quote(quality.name));
  writer.tell_left();
}

}  // namespace plinian::scene
