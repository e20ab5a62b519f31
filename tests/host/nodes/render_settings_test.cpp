#include <gtest/gtest.h>

#include "core/scene/preset.h"
#include "core/scene/quality_parameters.h"
#include "tests/host/nodes/node_session.h"

namespace plinian {
namespace {

TEST(RenderSettingsNode, ItsSetsBeginWithTheShippedPresets) {
  NodeSession s;
  s.run("createNode renderSettings -name r");
  for (const char* set : {"fast", "high"}) {
    const Preset preset = load_preset(std::string(PLINIAN_SOURCE_DIR) + "/presets/" + set + ".json", {});
    for (const Parameter<Quality>& parameter : quality_parameters()) {
      std::string value = s.run(std::string("getAttr r.") + set + "." + parameter.spec.name);
      EXPECT_EQ(value, to_text(parameter.spec, *parameter.get(preset.quality))) << parameter.spec.name;
    }
  }
}

TEST(RenderSettingsNode, ASetIsEditedAloneWithinItsRanges) {
  NodeSession s;
  s.run("createNode renderSettings -name r\nsetAttr r.fast.map.coefficients 99");
  EXPECT_EQ(s.run("getAttr r.fast.map.coefficients"), "16");
  EXPECT_EQ(s.run("getAttr r.high.map.coefficients"), "14");
  // An open end of a range is not part of it.
  EXPECT_EQ(s.run("setAttr r.fast.map.threshold 1\ngetAttr r.fast.map.threshold"), "0.99999994");
  EXPECT_EQ(s.warnings.size(), 2u);
}

TEST(RenderSettingsNode, AnOlderSceneWithoutLightsStaysDark) {
  TemporaryFolder folder;
  folder.write(
      "old.plinian",
      "plinian scene 1.0\nnode renderSettings r\n  .width 99\ntype renderSettings 1\n  .width 512\nend\n");
  NodeSession s;
  s.run("open " + folder / "old.plinian");
  EXPECT_EQ(s.run("getAttr r.default_lights\ngetAttr r.width"), "false\n99");
  EXPECT_EQ(s.run("createNode renderSettings -name n\ngetAttr n.default_lights"), "n\ntrue");
}

}  // namespace
}  // namespace plinian
