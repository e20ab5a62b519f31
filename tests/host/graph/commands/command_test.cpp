#include "host/graph/commands/command.h"

#include "tests/host/graph/message_of.h"

namespace plinian::graph {
namespace {

const CommandSpec spec = {.name = "move",
                          .help = "Moves nodes.",
                          .parameters = {{"nodes", ArgumentKind::node, "names", false, true},
                                         {"to", ArgumentKind::text, "where"},
                                         {"count", ArgumentKind::integer, "how often", true}},
                          .flags = {{"time", "when", ArgumentKind::number}, {"fast", "hurry", {}}}};

Arguments parse(const std::string& line) {
  return parse_arguments(spec, split_words(line));
}

TEST(Command, TakesWordsForParametersAndFlagsAnywhere) {
  const Arguments arguments = parse("a -time -2.5 b c -fast");
  EXPECT_EQ(arguments.texts("nodes"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(arguments.text("to"), "c");
  EXPECT_EQ(arguments.number("time"), -2.5);
  EXPECT_TRUE(arguments.has("fast"));
  EXPECT_FALSE(arguments.has("count"));
  EXPECT_EQ(parse("-5 \"-fast\"").text("to"), "-fast");  // numbers and quoted words are no flags
  EXPECT_FALSE(parse("-5 \"-fast\"").has("fast"));
}

TEST(Command, ItsEchoParsesToTheSame) {
  for (const char* line : {"a -time -2.5 b \"c d\" -fast", "\"-x\" -7", "a \"\""}) {
    const std::string echo = write_call(spec, parse(line));
    EXPECT_TRUE(echo.starts_with("move "));
    EXPECT_EQ(write_call(spec, parse(echo.substr(5))), echo);
  }
  EXPECT_EQ(write_call(spec, parse("a -fast b")), "move -fast a b");
}

TEST(Command, EachMistakeHasItsLine) {
  const auto refusal = [](const std::string& line) { return message_of([&] { parse(line); }); };
  EXPECT_EQ(refusal("a b -tiem 3"), "move: unknown flag '-tiem' (did you mean '-time'?)");
  EXPECT_EQ(refusal("a b -time"), "move: -time needs a word behind it");
  EXPECT_EQ(refusal("a b -time soon"), "move: -time expects a number, not 'soon'");
  EXPECT_EQ(refusal("a b -fast -fast"), "move: -fast is given twice");
  EXPECT_EQ(refusal("a"), "move: TO is missing: move NODES... TO [COUNT]");
  EXPECT_EQ(refusal(""), "move: NODES is missing: move NODES... TO [COUNT]");
}

TEST(Command, HelpSaysWhatItTakes) {
  EXPECT_EQ(help_lines(spec), (std::vector<std::string>{
                                  "move NODES... TO [COUNT]", "  Moves nodes.", "    NODES             names",
                                  "    TO                where", "    COUNT             how often",
                                  "    -time TIME        when", "    -fast             hurry"}));
}

TEST(Command, TheRegistryNamesTheNearest) {
  CommandRegistry registry;
  registry.add(spec);
  EXPECT_EQ(registry.get("move").name, "move");
  EXPECT_EQ(message_of([&] { registry.get("mvoe"); }), "unknown command 'mvoe' (did you mean 'move'?)");
  EXPECT_EQ(message_of([&] { registry.add(spec); }), "the command 'move' is already registered");
}

}  // namespace
}  // namespace plinian::graph
