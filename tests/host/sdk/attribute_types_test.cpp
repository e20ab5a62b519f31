// The README's table of attribute types, held to the example that declares one of each.
#include <fstream>
#include <iterator>
#include <regex>

#include "tests/host/sdk/plugin_session.h"

namespace plinian::sdk {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(AttributeTypes, AreReadAndSpelledAsTheReadmeSays) {
  const std::string readme = text_of(PLINIAN_SOURCE_DIR "/README.md");
  const std::size_t begin = readme.find("\n### Types of attributes\n"), end = readme.find("\n## ", begin);
  ASSERT_NE(begin, std::string::npos);
  const std::string chapter = readme.substr(begin, end - begin);
  PluginSession s;
  s.run("loadPlugin attributes\ncreateNode everyType -name e\ncreateNode transform -name place");
  // | `type` | `attribute` | `text` | ...
  const std::regex row("\n\\| `([a-z0-9]+)` \\| `([a-zA-Z0-9_.\\[\\]]+)` \\| `([^`]+)` \\|");
  std::set<std::string> types;
  for (std::sregex_iterator match(chapter.begin(), chapter.end(), row), none; match != none; ++match) {
    const std::string plug = "e." + (*match)[2].str(), text = (*match)[3];
    types.insert((*match)[1]);
    s.run("setAttr " + plug + " " + text);
    EXPECT_EQ(s.run("getAttr " + plug), text);
    const graph::SchemaAttribute& attribute = s.session.graph().attribute(s.session.graph().plug(plug));
    EXPECT_EQ(graph::type_name(attribute.spec.type), (*match)[1].str());
  }
  for (int i = 0; i <= int(graph::AttributeType::data); ++i)
    if (graph::AttributeType(i) != graph::AttributeType::compound) {
      EXPECT_TRUE(types.contains(std::string(graph::type_name(graph::AttributeType(i)))))
          << graph::type_name(graph::AttributeType(i)) << " is missing in the README";
    }
  EXPECT_EQ(
      s.run("getAttr e.report"),
      "\"1 -12 0.1 0.1 10 two words /show/a.vdb 1 2 0 0 1 2 3 0 1 2 3 4 1 0.5 0 0 5 0.035 90 24 0.25 2.5 "
      "wide 3:7 2\"");
  EXPECT_EQ(s.run("setAttr e.a_colour 0.5\ngetAttr e.a_colour\nsetAttr e.a_distance 35mm\n"
                  "getAttr e.a_distance\nsetAttr e.an_enum 11\ngetAttr e.an_enum\nsetAttr e.a_bool off\n"
                  "getAttr e.a_bool"),
            "0.5 0.5 0.5\n0.035\nhigh\nfalse");
}

TEST(AttributeTypes, TheReadmeNamesTheFieldsInTheOrderInWhichTheyAreDeclared) {
  const std::string readme = text_of(PLINIAN_SOURCE_DIR "/README.md"),
                    header = text_of(PLINIAN_SOURCE_DIR "/host/sdk/plugin/node.h");
  const std::string begin = "struct AttributeSpec {\n";
  const std::size_t at = header.find(begin) + begin.size();
  const std::string body =
      std::regex_replace(header.substr(at, header.find("\n};", at) - at), std::regex("//[^\n]*"), "");
  std::vector<std::string> declared, named;
  const std::regex field("(\\w+)(?: = [^,;]+|\\{\\})?[,;]"), quoted("`(\\w+)`");
  for (std::sregex_iterator match(body.begin(), body.end(), field), none; match != none; ++match)
    declared.push_back((*match)[1]);
  const std::size_t fields = readme.find("Fields of an attribute"), end = readme.find("C++ takes", fields);
  ASSERT_NE(fields, std::string::npos);
  const std::string sentence = readme.substr(readme.find(':', fields), end - readme.find(':', fields));
  for (std::sregex_iterator match(sentence.begin(), sentence.end(), quoted), none; match != none; ++match)
    named.push_back((*match)[1]);
  EXPECT_EQ(named, declared);
  EXPECT_EQ(declared.size(), 26u);
}

}  // namespace
}  // namespace plinian::sdk
