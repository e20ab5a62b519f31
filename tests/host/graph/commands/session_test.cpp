#include "host/graph/commands/session.h"

#include <fstream>

#include "host/graph/files/scene_reader.h"
#include "tests/host/graph/commands/test_session.h"

namespace plinian::graph {
namespace {

TEST(Session, CommandsEditEchoAndAreUndoneAsOneStep) {
  TestSession s;
  EXPECT_EQ(s.run("createNode every -name e\nsetAttr e.weight 0.25  # a quarter\n\nsetAttr e.axis 1 0 0\n"
                  "getAttr e.weight\ngetAttr e.axis.x\ngetAttr e.axis"),
            "e\n0.25\n1\n1 0 0");
  EXPECT_EQ(s.echoes.at(1), "setAttr e.weight 0.25");
  EXPECT_EQ(s.run("undo 2"), "setAttr e.axis 1 0 0\nsetAttr e.weight 0.25");
  EXPECT_EQ(s.run("getAttr e.weight"), "0.5");
  EXPECT_EQ(s.run("redo"), "setAttr e.weight 0.25");
  EXPECT_EQ(s.run("undo 100\nls"), "setAttr e.weight 0.25\ncreateNode -name e every\ntime1");
}

TEST(Session, ADragIsOneStep) {
  TestSession s;
  s.run("createNode every -name e");
  for (int i = 1; i <= 50; ++i) s.execute("setAttr e.weight 0." + std::to_string(i), "drag 7");
  s.run("undo");
  EXPECT_EQ(s.run("getAttr e.weight"), "0.5");
}

TEST(Session, ClampsAndSaysSo) {
  TestSession s;
  s.run("createNode every -name e\nsetAttr e.count 700");
  EXPECT_EQ(s.run("getAttr e.count"), "100");
  EXPECT_EQ(s.warnings, std::vector<std::string>{
                            "e.count is out of its range (an integer from 0 to 100) and was set to 100"});
  EXPECT_EQ(s.echoes.back(), "getAttr e.count");
}

TEST(Session, EchoesTheValueThatHolds) {
  TestSession s;
  s.run("createNode every -name e1\ncreateNode every -name e2\nsetAttr e1.count 700");
  EXPECT_EQ(s.echoes.back(), "setAttr e1.count 100");
  s.run("setAttr e1.weight -0.5");
  EXPECT_EQ(s.echoes.back(), "setAttr e1.weight 0");
  s.run("setAttr e1.weight 0.25");
  EXPECT_EQ(s.echoes.back(), "setAttr e1.weight 0.25");
  s.run("setAttr e?.count 700");
  EXPECT_EQ(s.echoes.back(), "setAttr e?.count 700") << "several have no value in common";
}

TEST(Session, DeletesWhatServedNothingElse) {
  TestSession s;
  std::vector<std::string> notes;
  s.on_note = [&](const std::string& line) { notes.push_back(line); };
  s.run(
      "createNode group -name place\ncreateNode shape -name ball -parent place\n"
      "createNode sum -name own\ncreateNode sum -name before\ncreateNode sum -name shared\n"
      "createNode sum -name other\ncreateNode group -name rig\n"
      "connectAttr before.out own.a\nconnectAttr own.out ball.size\nconnectAttr shared.out own.b\n"
      "connectAttr shared.out other.a\nconnectAttr rig.visibility before.a");
  const std::string all = s.run("ls");
  s.run("delete place");
  EXPECT_EQ(s.run("ls own before"), "own\nbefore") << "unless it is asked for";
  s.run("undo");
  s.run("delete -inputs place");
  EXPECT_EQ(s.run("ls"), "time1\nshared\nother\nrig");
  EXPECT_EQ(notes, std::vector<std::string>{"delete: own, before too, which served nothing else"});
  s.run("undo");
  EXPECT_EQ(s.run("ls"), all) << "in one step";
}

TEST(Session, SaysWhatComputedValuesTakeAndLetsGoOfThem) {
  TestSession s;
  EXPECT_EQ(s.run("cache -limit 64"), "0 of 64 MiB");
  s.run("createNode volumeNoise -name n\nsetAttr n.resolution 32\nevaluate n");
  EXPECT_NE(s.run("cache").find(" of 64 MiB"), std::string::npos);
  EXPECT_NE(s.run("cache"), "0 of 64 MiB");
  EXPECT_EQ(s.run("cache -clear"), "0 of 64 MiB");
  EXPECT_NE(s.refusal("cache -limit -1").find("from 0"), std::string::npos);
}

TEST(Session, FindsSelectsAndListsNodes) {
  TestSession s;
  s.run("createNode sum -name ash1\ncreateNode sum -name ash2\ncreateNode group -name ground");
  EXPECT_EQ(s.run("ls ash*"), "ash1\nash2");
  EXPECT_EQ(s.run("ls ?sh2 g*d"), "ash2\nground");
  EXPECT_EQ(s.run("ls -type group"), "ground");
  EXPECT_EQ(s.run("select ash*\nselect -add ground\nselect -remove ash1\nls -selected"), "ash2\nground");
  EXPECT_EQ(s.run("delete\nls"), "time1\nash1");
  EXPECT_EQ(s.run("undo\nls -selected"), "delete\nash2\nground");
  EXPECT_EQ(s.run("select -clear\nls -selected"), "");
}

TEST(Session, ConnectsAndListsConnections) {
  TestSession s;
  s.run(
      "createNode sum -name x\ncreateNode sum -name y\nconnectAttr x.out y.a\nconnectAttr x.out y.weights\n"
      "connectAttr y.vector.z x.offset.x");
  EXPECT_EQ(s.run("listConnections y"), "x.out -> y.a\nx.out -> y.weights[0]\ny.vector.z -> x.offset.x");
  EXPECT_EQ(s.run("listConnections y -destination"), "y.vector.z -> x.offset.x");
  EXPECT_EQ(s.run("listConnections y.weights"), "x.out -> y.weights[0]");
  EXPECT_EQ(s.run("disconnectAttr y.weights\nlistConnections x -destination"), "x.out -> y.a");
}

TEST(Session, FewerStepsThanAskedForAreTold) {
  TestSession s;
  std::vector<std::string> notes;
  s.on_note = [&](const std::string& line) { notes.push_back(line); };
  s.run("createNode sum -name x\ncreateNode sum -name y");
  EXPECT_EQ(s.run("undo 5"), "createNode -name y sum\ncreateNode -name x sum");
  EXPECT_EQ(notes, std::vector<std::string>{"undo: there were 2 steps, not 5"});
}

TEST(Session, WhoLooksOnIsToldOfASaveAndOfItsFailure) {
  const TemporaryFolder folder;
  TestSession s;
  s.on_progress = [](double) { return false; };
  s.run("createNode sum -name x");
  s.run("save " + (folder / "a.plinian"));
  EXPECT_TRUE(std::filesystem::exists(folder / "a.plinian")) << "what has begun is not cancelled";
  EXPECT_NE(s.refusal("save " + (folder / "nowhere/a.plinian")).find("save: "), std::string::npos);
}

TEST(Session, AnExportNamesTheConnectionsThatItLeavesOut) {
  const TemporaryFolder folder;
  TestSession s;
  std::vector<std::string> notes;
  s.on_note = [&](const std::string& line) { notes.push_back(line); };
  s.run("createNode sum -name x\ncreateNode sum -name y\nconnectAttr x.out y.a\nconnectAttr x.out y.b");
  s.run("export " + (folder / "y.plinian") + " y");
  EXPECT_EQ(notes, std::vector<std::string>{"export: without the connection of y.a from x.out and 1 more: "
                                            "-inputs takes what drives the nodes along"});
  notes.clear();
  s.run("export " + (folder / "all.plinian") + " y -inputs");
  EXPECT_TRUE(notes.empty());
}

TEST(Session, AScriptGoesOnBehindALineThatFailsWhereThatIsAskedFor) {
  TestSession s;
  std::vector<std::string> errors;
  std::vector<std::string> lines = {"createNode sum -name x", "bad", "setAttr x.a 3"};
  const auto next = [&, i = std::size_t(0)]() mutable {
    return i < lines.size() ? std::optional(lines[i++]) : std::nullopt;
  };
  run_script(s, next, "a.pln", nullptr, [&](const std::string& line) { errors.push_back(line); });
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_TRUE(errors[0].starts_with("a.pln:2: unknown command 'bad'")) << errors[0];
  EXPECT_EQ(s.run("getAttr x.a"), "3");
}

TEST(Session, DuplicatesParentsRenamesLocksAndAddsAttributes) {
  TestSession s;
  EXPECT_EQ(s.run("createNode group -name g\ncreateNode shape -name leaf -parent g\nduplicate g"),
            "g\nleaf\ng1");
  EXPECT_EQ(s.run("ls"), "time1\ng\nleaf\ng1\nleaf1");
  EXPECT_EQ(s.run("duplicate g -name other\nduplicate g leaf -name other\nundo 2"),
            "other\nother1\nother2\nduplicate -name other g leaf\nduplicate -name other g");
  s.run("parent leaf leaf1 g1");
  EXPECT_EQ(s.graph().find("leaf")->parent, s.graph().get("g1").id);
  s.run("parent -world leaf");
  EXPECT_FALSE(s.graph().find("leaf")->parent);
  EXPECT_EQ(s.run("rename leaf leaf1"), "leaf2");
  EXPECT_EQ(s.run("addAttr leaf2 heat -min 0 -default 4\ngetAttr leaf2.heat"), "leaf2.heat\n4");
  EXPECT_EQ(s.run("addAttr leaf2 mode -type enum -choices off,low:10,high -default high\ngetAttr leaf2.mode"),
            "leaf2.mode\nhigh");
  EXPECT_EQ(s.run("lockAttr leaf2.heat\ngetAttr -lock leaf2.heat\nlockAttr -off leaf2.heat\ngetAttr -lock "
                  "leaf2.heat"),
            "true\nfalse");
  EXPECT_EQ(s.run("setAttr leaf2.heat 9\nresetAttr leaf2.heat\ngetAttr leaf2.heat"), "4");
}

TEST(Session, WhatIsExportedKeepsItsPlaceAndWhereAskedForWhatDrivesIt) {
  const TemporaryFolder folder;
  TestSession s;
  const std::string file = folder / "part.plinian";
  s.run(
      "createNode transform -name top\ncreateNode transform -name inner -parent top\n"
      "createNode sum -name x\nconnectAttr x.out inner.translate.y\nsetAttr top.translate 1 2 3");
  const auto nodes_after = [&](const std::string& command) {
    s.run(command + " \"" + file + "\" inner\nimport -namespace lib \"" + file + "\"");
    const std::string names = s.run("ls lib:*");
    s.run("undo");
    return names;
  };
  EXPECT_EQ(nodes_after("export"), "lib:top\nlib:inner");
  EXPECT_EQ(nodes_after("export -inputs"), "lib:top\nlib:inner\nlib:x");
  s.run("import -namespace lib \"" + file + "\"");
  EXPECT_EQ(s.run("getAttr lib:top.translate.z"), "3");
}

TEST(Session, ANodeAnswersWithAllThatCanBeSetOnIt) {
  TestSession s;
  s.run("createNode transform -name t\nsetAttr t.translate 1 2 3");
  const std::string all = s.run("getAttr t");
  EXPECT_NE(all.find("translate.y 2\n"), std::string::npos) << all;
  EXPECT_NE(all.find("rotate_order xyz\n"), std::string::npos) << all;
  EXPECT_EQ(s.refusal("setAttr .x 1"), "'.x' names no attribute: write NODE.ATTRIBUTE");
}

TEST(Session, WhatIsImportedSharesTheNodesOfWhichASceneHasOne) {
  const TemporaryFolder folder;
  TestSession s;
  const std::string file = folder / "a.plinian";
  s.run("createNode sum -name x\nconnectAttr time1.out x.a\nsave \"" + file + "\"");
  std::vector<std::string> notes;
  s.on_note = [&](const std::string& line) { notes.push_back(line); };
  EXPECT_EQ(s.run("import -namespace lib \"" + file + "\"\nls"), "lib:x\ntime1\nx\nlib:x");
  EXPECT_EQ(notes, std::vector<std::string>{file + ": time1 stays as it is here"});
  EXPECT_EQ(s.run("listConnections lib:x"), "time1.out -> lib:x.a");
}

TEST(Session, SavesOpensImportsAndExports) {
  const TemporaryFolder folder;
  TestSession s;
  const std::string file = folder / "a.plinian", part = folder / "part.plinian";
  s.run("createNode sum -name x\nsetAttr x.a 3\nsave \"" + file + "\"");
  EXPECT_FALSE(s.history().is_modified());
  EXPECT_EQ(s.scene_folder(), folder.path());
  s.run("setAttr x.a 4\nexport \"" + part + "\" x");
  EXPECT_EQ(s.refusal("open \"" + file + "\""),
            "open: the scene has unsaved changes: save it first, or give -force");
  s.run("save\nnewScene\nopen \"" + file + "\"");
  EXPECT_EQ(s.run("getAttr x.a"), "4");
  EXPECT_EQ(s.run("import -namespace lib \"" + part + "\"\nls"), "lib:x\ntime1\nx\nlib:x");
  EXPECT_EQ(s.run("undo\nls"), "import -namespace lib \"" + part + "\"\ntime1\nx");
  EXPECT_TRUE(std::filesystem::exists(file + ".bak"));
  // What cannot be opened leaves the scene as it is.
  std::ofstream(folder / "bad.plinian") << "plinian scene 1.0\nnode sum\n";
  EXPECT_NE(s.refusal("open -force \"" + folder / "bad.plinian" + "\"").find("bad.plinian:2"),
            std::string::npos);
}

TEST(Session, ANewerSceneIsReadOnlyUnderItsOwnName) {
  const TemporaryFolder folder;
  std::ofstream(folder / "new.plinian") << "plinian scene 2.0\nnode sum s\nend\n";
  TestSession s;
  s.run("open \"" + folder / "new.plinian" + "\"");
  EXPECT_EQ(s.warnings.size(), 1u);
  EXPECT_NE(s.refusal("save").find("is read-only here: save it under another name"), std::string::npos);
  s.run("save \"" + folder / "mine.plinian" + "\"\nsetAttr s.a 1\nsave");
  EXPECT_NE(read_text_file(folder / "new.plinian").find("2.0"), std::string::npos);
}

TEST(Session, EvaluatesAndHelps) {
  TestSession s;
  s.run("createNode animCurve -name c\nsetAttr c.key[0].value 2.5");
  EXPECT_EQ(s.run("evaluate c -check"), "c.out 2.5");
  EXPECT_NE(s.run("help").find("setKeyframe     "), std::string::npos);
  EXPECT_TRUE(s.run("help setAttr").starts_with("setAttr PLUG VALUE...\n"));
  for (const std::string& name : s.commands().names())
    EXPECT_FALSE(s.commands().get(name).help.empty()) << name;
}

TEST(Session, PatternsNameAttributesOfManyNodes) {
  TestSession s;
  s.run("createNode sum -name x1\ncreateNode sum -name x2\ncreateNode group -name g\nsetAttr x*.a 3");
  EXPECT_EQ(s.run("getAttr x1.a\ngetAttr x2.a"), "3\n3");
  s.run("setAttr x1.b 5\nsetAttr x1.offset 1 2 3\nsetAttr x1.weights[4] 6\nresetAttr x?.*");
  EXPECT_EQ(s.run("getAttr x1.a\ngetAttr x1.b\ngetAttr x1.offset\ngetAttr x1.weights"), "0\n0\n0 0 0");
  s.run("lockAttr *.offset *.translate");
  EXPECT_EQ(s.refusal("setAttr x2.offset 1 1 1"), "x2.offset is locked");
  EXPECT_EQ(s.refusal("setAttr g.translate 1 1 1"), "g.translate is locked");
  s.run("lockAttr -off *.*\nsetAttr x2.offset 1 1 1");
  EXPECT_EQ(s.refusal("setAttr q*.a 1"), "no node matches 'q*'");
  EXPECT_EQ(s.refusal("setAttr x*.q* 1"), "no attribute matches 'x*.q*' that can be used here");
  EXPECT_EQ(s.refusal("setAttr x* 1"), "'x*' names no attribute: write NODE.ATTRIBUTE");
  s.run("createNode transform -name t1\ncreateNode transform -name t2\nsetAttr t?.translate 1 2 3");
  EXPECT_EQ(s.run("getAttr t2.translate"), "translate.x 1\ntranslate.y 2\ntranslate.z 3");
  s.run("delete t?");
  // What cannot be animated is not meant.
  EXPECT_EQ(s.run("setKeyframe g.* -time 1"), "g_translate_x\ng_translate_y\ng_translate_z\ng_visibility");
  EXPECT_EQ(s.run("cutKey g.t*\ncutKey *.*"), "3\n1");
}

TEST(Session, APatternIsReadWithTheNamesOfWhatMatches) {
  TestSession s;
  s.run("createNode sum -name x1\ncreateNode sum -name x2\nsetAttr x2.a 3\nlockAttr x1.a");
  EXPECT_EQ(s.run("getAttr x*.a"), "x1.a 0\nx2.a 3");
  EXPECT_EQ(s.run("getAttr -lock x*.a"), "x1.a true\nx2.a false");
  s.run("createNode group -name set:roof");
  EXPECT_EQ(s.refusal("getAttr *.translat"),
            "no attribute matches '*.translat' that can be used here (did you mean 'translate'?)");
  EXPECT_EQ(s.refusal("delete rof*"), "no node matches 'rof*'");
  EXPECT_EQ(s.refusal("delete roof*"), "no node matches 'roof*' (did you mean 'set:roof*'?)");
  EXPECT_EQ(s.refusal("delete set:ruof*"), "no node matches 'set:ruof*' (did you mean 'set:roof'?)");
  EXPECT_EQ(s.refusal("getAttr roof.translate"), "there is no node 'roof' (did you mean 'set:roof'?)");
}

TEST(Session, ARampIsEmptiedAndTakesItsPointsInQuotesToo) {
  TestSession s;
  s.run("createNode every -name e\nsetAttr e.profile \"0:0:linear 1:1:smooth\"");
  EXPECT_EQ(s.run("getAttr e.profile"), "0:0:linear 1:1:smooth");
  s.run("setAttr e.profile \"\"");
  EXPECT_EQ(s.run("getAttr e.profile"), "");
  s.run("setAttr e.profile 0:1:linear\nresetAttr e.profile");
  EXPECT_EQ(s.run("getAttr e.profile"), "");
}

TEST(Session, AScriptMayBeginWithAByteOrderMark) {
  TestSession s;
  EXPECT_EQ(s.run("\xef\xbb\xbf"
                  "createNode sum -name x"),
            "x");
}

TEST(Session, OpenAddsWhatSaveAdds) {
  TestSession s;
  const TemporaryFolder folder;
  s.run("createNode sum -name x\nsave \"" + folder / "shot" + "\"\nnewScene\nopen \"" + folder / "shot" +
        "\"\nls");
  EXPECT_EQ(s.scene_path(), folder / "shot.plinian");
  EXPECT_EQ(s.run("ls x"), "x");
}

TEST(Session, KeysAreCutInRanges) {
  TestSession s;
  s.run("createNode sum -name x");
  const auto key = [&] {
    for (const char* time : {"1", "5", "10", "20"})
      s.run("setKeyframe x.a -value 2 -time " + std::string(time));
  };
  key();
  EXPECT_EQ(s.run("cutKey x.a -from 5 -to 10"), "2");
  EXPECT_EQ(s.run("cutKey x.a -from 6"), "1");
  key();
  EXPECT_EQ(s.run("cutKey x.a -to 5\ncutKey x.a -time 10 -to 20"), "2\n2");
  EXPECT_EQ(s.run("listConnections x"), "");
  key();
  EXPECT_EQ(s.refusal("cutKey x.a -from 10 -to 5"), "cutKey: the range begins at 10, behind its end at 5");
  EXPECT_EQ(s.refusal("cutKey x.a -time 1 -from 5"), "cutKey: -time and -from exclude each other");
  EXPECT_EQ(s.refusal("cutKey x.a -from 6 -to 9"), "cutKey: there is no key there");
}

TEST(Session, AnImportGoesIntoANamespaceOfItsOwn) {
  const TemporaryFolder folder;
  TestSession s;
  const std::string file = folder / "part.plinian", import = "import \"" + file + "\" -namespace survey";
  s.run("createNode sum -name camp\nexport \"" + file + "\" camp");
  std::vector<std::string> notes;
  s.on_note = [&](const std::string& line) { notes.push_back(line); };
  EXPECT_EQ(s.run(import), "survey:camp");
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(s.run(import), "survey1:camp");
  EXPECT_EQ(notes, std::vector<std::string>{"import: the namespace survey is there already: " + file +
                                            " goes into survey1 (-merge puts it into that one)"});
  EXPECT_EQ(s.run(import), "survey2:camp");
  EXPECT_EQ(s.run(import + " -merge"), "survey:camp1");
  EXPECT_EQ(s.run("delete survey1:*\n" + import), "survey1:camp");
  EXPECT_EQ(s.refusal("import \"" + file + "\" -setup"), "import: -setup means nothing for scenes");
}

TEST(Session, WhatIsSavedWithoutAnExtensionGetsTheScenes) {
  const TemporaryFolder folder;
  TestSession s;
  s.run("createNode sum -name x");
  EXPECT_EQ(s.run("save \"" + folder / "shot" + "\""), folder / "shot.plinian");
  s.run("export \"" + folder / "part" + "\" x");
  EXPECT_TRUE(std::filesystem::exists(folder / "part.plinian"));
}

TEST(Session, ASecondNodeOfWhichASceneHasOneIsTold) {
  TestSession s;
  s.run("createNode time\nduplicate time1");
  EXPECT_EQ(s.warnings, (std::vector<std::string>{
                            "time2 is another time, of which a scene has one: time1, the first, counts",
                            "time3 is another time, of which a scene has one: time1, the first, counts"}));
}

TEST(Session, ASceneWithTwoNodesOfWhichItHasOneSaysWhichCounts) {
  const TemporaryFolder folder;
  const std::string file = folder.write("two.plinian", "plinian scene 1.0\nnode time a\nnode time b\nend\n");
  TestSession s;
  s.run("open \"" + file + "\"");
  EXPECT_EQ(s.warnings, std::vector<std::string>{
                            file + ":3: b is another time, of which a scene has one: a, the first, counts"});
}

}  // namespace
}  // namespace plinian::graph
