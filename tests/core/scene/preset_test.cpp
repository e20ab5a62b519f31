#include "core/scene/preset.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "core/scene/quality_parameters.h"
#include "tests/core/scene/temporary_folder.h"

namespace plinian {
namespace {

const std::string shipped = PLINIAN_SOURCE_DIR "/presets";

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string preset(const std::string& body) {
  return R"({"plinian_preset": {"major": 1, "minor": 0}, )" + body + "}";
}

// What loading a preset with that text says, with the folder's name left out.
std::string error_for(const std::string& text) {
  TemporaryFolder folder;
  const std::string path = folder.write("mine.json", text);
  std::string error = error_of([&] { load_preset(path, {shipped}); });
  EXPECT_EQ(error.find('\n'), std::string::npos);
  if (error.starts_with(folder.path().string())) error = error.substr(folder.path().string().size() + 1);
  return error;
}

// How many fields an aggregate has: the most values it can be made from. An enum or a number will take a
// value that turns into anything.
struct Anything {
  template <class T>
  operator T() const;
};
template <class T, class... Values>
constexpr int field_count() {
  if constexpr (requires { T{Values{}..., Anything{}}; })
    return field_count<T, Values..., Anything>();
  else
    return sizeof...(Values);
}

int parameters_under(const std::string& object) {
  int count = 0;
  for (const auto& parameter : quality_parameters()) count += parameter.spec.name.starts_with(object + ".");
  return count;
}

TEST(QualityParameters, DeclareEveryFieldOfTheQualityStructsOnce) {
  EXPECT_EQ(parameters_under("map"), field_count<MapQuality>());
  EXPECT_EQ(parameters_under("view"), field_count<ViewQuality>());
  EXPECT_EQ(quality_parameters().size(), std::size_t(field_count<MapQuality>() + field_count<ViewQuality>()));
}

TEST(QualityParameters, HoldDefaultsThatTheyWouldAccept) {
  Quality quality;
  for (const auto& parameter : quality_parameters()) {
    const std::string text = to_text(parameter.spec, *parameter.get(quality));
    EXPECT_TRUE(set_quality(quality, parameter.spec.name, text)) << parameter.spec.name;
    EXPECT_FALSE(parameter.spec.help.empty()) << parameter.spec.name;
  }
}

TEST(Preset, FastHasSixCoefficientsAndHighFourteen) {
  EXPECT_EQ(load_preset("fast", {shipped}).quality.map.coefficients, 6);
  EXPECT_EQ(load_preset("high", {shipped}).quality.map.coefficients, 14);
  EXPECT_EQ(load_preset("high", {shipped}).quality.name, "high");
}

TEST(Preset, IsKnownByTheNameOfItsFile) {
  const TemporaryFolder folder;
  folder.write("mid.json", preset(R"("name": "fast", "map": {"coefficients": 8})"));
  const Preset found = load_preset("mid", {folder.path().string(), shipped});
  EXPECT_EQ(found.quality.name, "mid") << "as copies of a shipped one are";
  EXPECT_EQ(found.quality.map.coefficients, 8);
}

TEST(Preset, ThatIsItsOwnBaseSaysSo) {
  const TemporaryFolder folder;
  const std::string path = folder.write("loop.json", preset(R"("base": "loop")"));
  EXPECT_EQ(error_of([&] {
              load_preset("loop", {folder.path().string(), shipped});
            }),
            path + ": base: loop is this preset itself; name another one, or leave the base out for fast");
}

TEST(Preset, TheShippedOnesHoldEveryParameterAndNeedNoBase) {
  for (const char* name : {"fast", "high"}) {
    const std::string text = text_of(shipped + "/" + name + ".json");
    for (const auto& parameter : quality_parameters()) {
      const auto key = parameter.spec.name.substr(parameter.spec.name.find('.') + 1);
      EXPECT_NE(text.find('"' + key + '"'), std::string::npos) << name << " lacks " << parameter.spec.name;
    }
    // Alone in a folder, so that there is nothing it could stand on.
    TemporaryFolder folder;
    folder.write("alone.json", text);
    EXPECT_EQ(error_of([&] { load_preset("alone", {folder.path().string()}); }), "");
  }
}

TEST(Preset, TakesWhatItLeavesOutFromItsBase) {
  TemporaryFolder folder;
  folder.write("mine.json", preset(R"("base": "high", "map": {"threshold": 0.25}, "_why": "a test")"));
  const Quality high = load_preset("high", {shipped}).quality;
  const Preset mine = load_preset("mine", {folder.path().string(), shipped});
  EXPECT_EQ(mine.quality.map.threshold, 0.25f);
  EXPECT_EQ(mine.quality.map.coefficients, 14);
  EXPECT_EQ(mine.quality.view.shade_samples, high.view.shade_samples);
  EXPECT_EQ(mine.quality.name, "mine");
  EXPECT_TRUE(mine.warnings.empty());
}

TEST(Preset, OfTheUserHidesTheInstalledOneOfThatNameAndMayStandOnIt) {
  TemporaryFolder folder;
  folder.write("fast.json", preset(R"("map": {"resolution": 128})"));
  const Preset fast = load_preset("fast", {folder.path().string(), shipped});
  EXPECT_EQ(fast.quality.map.resolution, 128);
  EXPECT_EQ(fast.quality.map.coefficients, 6);
  EXPECT_EQ(fast.warnings,
            std::vector<std::string>{folder / "fast.json" + ": stands in for the preset 'fast' that comes "
                                                            "with the program"});
  EXPECT_TRUE(load_preset("high", {folder.path().string(), shipped}).warnings.empty());
}

TEST(Preset, SurvivesBeingWrittenAndRead) {
  Quality quality = load_preset("high", {shipped}).quality;
  quality.map.threshold = 0.1f;
  quality.map.encoding = Encoding::tfm;
  TemporaryFolder folder;
  const std::string path = folder.write("copy.json", preset_text(quality));
  const Quality copy = load_preset(path, {}).quality;
  for (const auto& parameter : quality_parameters())
    EXPECT_EQ(*parameter.get(copy), *parameter.get(quality)) << parameter.spec.name;
  EXPECT_NE(preset_text(quality).find("\"threshold\": 0.1,"), std::string::npos) << "written as people would";
}

TEST(Preset, RefusesWhatItDoesNotUnderstandInOneLineThatNamesTheKey) {
  EXPECT_EQ(error_for(preset(R"("map": {"treshold": 0.1})")),
            "mine.json: map.treshold: unknown key (did you mean 'map.threshold'?)");
  EXPECT_EQ(error_for(preset(R"("mpa": {})")), "mine.json: mpa: unknown key (did you mean 'map'?)");
  EXPECT_EQ(error_for(preset(R"("map": {"threshold": 1.5})")),
            "mine.json: map.threshold: expected a number in (0, 1), got 1.5");
  EXPECT_EQ(error_for(preset(R"("map": {"coefficients": 6.5})")),
            "mine.json: map.coefficients: expected an integer from 2 to 16, got 6.5");
  EXPECT_EQ(error_for(preset(R"("map": {"coefficients": "six"})")),
            "mine.json: map.coefficients: expected an integer from 2 to 16, got \"six\"");
  EXPECT_EQ(error_for(preset(R"("map": {"encoding": "fom"})")),
            "mine.json: map.encoding: expected one of tfm, atfm, got \"fom\"");
  EXPECT_EQ(error_for(preset(R"("map": 3)")), "mine.json: map: expected an object, got 3");
  EXPECT_EQ(error_for(preset(R"("view": {"passes": true})")),
            "mine.json: view.passes: expected an integer from 1 to 65536, got true");
  EXPECT_EQ(error_for(preset(R"("map": {"threshold": 0.1, "threshold": 0.2})")),
            "mine.json: threshold: the key stands there twice");
}

TEST(Preset, RefusesWhatIsNoPreset) {
  EXPECT_EQ(error_for("{}"),
            "mine.json: not a preset: it needs \"plinian_preset\": {\"major\": 1, \"minor\": 0}");
  EXPECT_EQ(error_for("[1, 2]"),
            "mine.json: not a preset: it needs \"plinian_preset\": {\"major\": 1, \"minor\": 0}");
  EXPECT_TRUE(error_for("{\n  \"map\": }").starts_with("mine.json:2:10: not JSON: syntax error"))
      << error_for("{\n  \"map\": }");
  EXPECT_EQ(error_for(""), "mine.json: the file is empty (or a folder)");
  EXPECT_EQ(error_of([] { load_preset("fst", {shipped}); }),
            "fst: no such preset (did you mean 'fast'?); there are: fast, high");
  EXPECT_EQ(error_for(preset(R"("base": "hgh")")),
            "mine.json: base: hgh: no such preset (did you mean 'high'?); there are: fast, high");
  EXPECT_NE(error_of([] { load_preset("/nowhere/x.json", {shipped}); }).find("no such file"),
            std::string::npos);
}

TEST(Preset, OfANewerMinorVersionIsReadWithWarningsAndOfANewerMajorRefused) {
  TemporaryFolder folder;
  const std::string path = folder.write(
      "mine.json",
      R"({"plinian_preset": {"major": 1, "minor": 7}, "map": {"sparkle": 1, "threshold": 0.5}})");
  const Preset mine = load_preset(path, {shipped});
  EXPECT_EQ(mine.quality.map.threshold, 0.5f);
  ASSERT_EQ(mine.warnings.size(), 1u);
  EXPECT_NE(mine.warnings[0].find("map.sparkle: unknown key"), std::string::npos) << mine.warnings[0];
  // A wrong value is wrong in every version.
  EXPECT_NE(
      error_for(R"({"plinian_preset": {"major": 1, "minor": 7}, "map": {"threshold": 5}})").find("(0, 1)"),
      std::string::npos);
  EXPECT_EQ(error_for(R"({"plinian_preset": {"major": 2, "minor": 0}})"),
            "mine.json: plinian_preset.major: this program reads version 1, not 2; a newer one is needed");
}

TEST(Preset, ThatStandsOnItselfIsAnErrorAndNoEndlessLoop) {
  TemporaryFolder folder;
  folder.write("a.json", preset(R"("base": "b")"));
  folder.write("b.json", preset(R"("base": "a")"));
  EXPECT_NE(error_of([&] { load_preset("a", {folder.path().string()}); }).find("loop"), std::string::npos);
}

TEST(Preset, IsSetByNameAndText) {
  Quality quality;
  EXPECT_TRUE(set_quality(quality, "map.threshold", "0.02"));
  EXPECT_EQ(quality.map.threshold, 0.02f);
  EXPECT_TRUE(set_quality(quality, "map.encoding", "tfm"));
  EXPECT_EQ(quality.map.encoding, Encoding::tfm);
  EXPECT_TRUE(set_quality(quality, "view.exact_light_at_rest", "on"));
  EXPECT_TRUE(quality.view.exact_light_at_rest);
  EXPECT_FALSE(set_quality(quality, "map.nothing", "1"));
  EXPECT_EQ(error_of([&] { set_quality(quality, "map.threshold", "1,2"); }),
            "--set map.threshold: expected a number in (0, 1), got [1,2]");
}

}  // namespace
}  // namespace plinian
