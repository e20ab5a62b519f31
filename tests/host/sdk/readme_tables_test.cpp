// The README's tables for authors of plug-ins, held to the headers and to what the host takes.
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "host/sdk/command_table.h"
#include "tests/host/sdk/plugin_session.h"

namespace plinian::sdk {
namespace {

using Names = std::set<std::string>;

std::string text_of(const std::string& path) {
  std::ifstream file(PLINIAN_SOURCE_DIR "/" + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string part(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin);
  EXPECT_NE(at, text.npos) << begin;
  if (at == text.npos) return "";
  return text.substr(at, text.find(end, at + begin.size()) - at);
}

Names all_of(const std::string& text, const std::regex& pattern) {
  Names names;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), none; match != none; ++match)
    names.insert((*match)[1]);
  return names;
}

// Names in the first column of the table that begins with `head`.
Names first_column(const std::string& head) {
  const std::string table = part(text_of("README.md"), "\n| " + head + " |", "\n\n");
  Names names;
  std::size_t line = table.find('\n', table.find("|---"));
  for (; line != table.npos; line = table.find('\n', line + 1)) {
    const std::size_t begin = table.find('|', line), end = table.find('|', begin + 1);
    if (begin == table.npos || end == table.npos) break;
    names.merge(all_of(table.substr(begin, end - begin), std::regex("`([^`]+)`")));
  }
  return names;
}

// Fields that a struct of a header declares.
Names declared(const std::string& header, const std::string& name) {
  std::string body = part(text_of(header), "\nstruct " + name + " {", "\n};");
  body = std::regex_replace(body, std::regex("//[^\n]*"), "");
  body = std::regex_replace(body, std::regex("\\{[^{}]*\\}|<[^<>]*>"), "");
  return all_of(body, std::regex("(\\w+)(?: = [^,;]+)?[,;]"));
}

TEST(ReadmeTables, FieldsOfContributionsAreThoseOfTheHeader) {
  for (const char* name : {"Medium", "Light", "Camera"})
    EXPECT_EQ(first_column("`" + std::string(name) + "`"), declared("host/sdk/plugin/scene.h", name)) << name;
}

TEST(ReadmeTables, FieldsThatSayHowAnAttributeIsShownAreThere) {
  const Names fields = declared("host/sdk/plugin/node.h", "AttributeSpec"), told = first_column("field");
  EXPECT_GT(told.size(), 10u);
  for (const std::string& field : told) EXPECT_TRUE(fields.contains(field)) << field;
}

TEST(ReadmeTables, KindsOfArgumentsAreThoseThatTheHostTakes) {
  Names taken;
  for (const char* kind :
       {"text", "number", "integer", "node", "plug", "path", "type", "value", "command", "file", "bool"}) {
    const PlinianArgument argument{sizeof(PlinianArgument), "word", kind, "", 0, 0};
    PlinianCommand command{};
    command.size = sizeof(command);
    command.name = "try";
    command.parameters = &argument;
    command.parameter_count = 1;
    command.run = [](void*, const PlinianCommandContext*, PlinianCall*) {};
    try {
      command_from(&command, std::make_shared<DataCount>());
      taken.insert(kind);
    } catch (const graph::GraphError&) {
    }
  }
  EXPECT_EQ(first_column("`kind` | a word is"), taken);
}

TEST(ReadmeTables, EventsAreThoseThatTheHostTells) {
  Names told;
  for (int i = 0; i <= int(EventKind::after_save); ++i) told.insert(event_name(EventKind(i)));
  EXPECT_EQ(first_column("`kind` | fields of the event"), told);
}

TEST(ReadmeTables, CallsOfAContextAreThere) {
  const std::string header = text_of("host/sdk/plugin/context.h");
  for (const char* call :
       {"Volume volume(", "Volume volume_at(", "VolumeInfo info(", "std::vector<float> voxels(",
        "Volume make_volume(", "void set(Attribute a, Volume volume)"})
    EXPECT_NE(header.find(call), header.npos) << call;
  for (const std::string field :
       {"first", "count", "object_from_index", "density_max", "temperature_max", "voxels"})
    EXPECT_TRUE(declared("host/sdk/plugin/volume.h", "VolumeInfo").contains(field)) << field;
}

}  // namespace
}  // namespace plinian::sdk
