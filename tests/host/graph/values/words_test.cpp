#include "host/graph/values/words.h"

#include "tests/host/graph/message_of.h"

namespace plinian::graph {
namespace {

std::vector<std::string> texts(std::string_view line) {
  std::vector<std::string> result;
  for (const Word& word : split_words(line)) result.push_back(word.text);
  return result;
}

TEST(Words, AreCutAtSpacesUnlessQuoted) {
  EXPECT_EQ(texts("setAttr  a.b\t1 2\r"), (std::vector<std::string>{"setAttr", "a.b", "1", "2"}));
  EXPECT_EQ(texts(R"(x "two words" "a \"b\" \\ \n\x41")"),
            (std::vector<std::string>{"x", "two words", "a \"b\" \\ \nA"}));
  EXPECT_EQ(texts("a # the rest is a comment"), std::vector<std::string>{"a"});
  EXPECT_EQ(texts("a#b \"#c\""), (std::vector<std::string>{"a#b", "#c"}));
  EXPECT_TRUE(split_words("  ").empty());
  EXPECT_TRUE(split_words("\"-x\"")[0].quoted);
}

TEST(Words, RefuseWhatIsNotClosedOrNotKnown) {
  EXPECT_EQ(message_of([] { split_words("a \"b"); }), "a quote is not closed");
  EXPECT_EQ(message_of([] { split_words("\"a\"b"); }), "a space is missing after a closing quote");
  EXPECT_NE(message_of([] { split_words("\"\\q\""); }).find("unknown escape"), std::string::npos);
}

TEST(Words, EveryByteSurvivesQuotingAndTheTextIsCleanUtf8) {
  using namespace std::string_literals;
  std::string every;
  for (int c = 1; c < 256; ++c) every += char(c);
  every += "\0 \xc3\xa4 \xe2\x82\xac \xf0\x9f\x8c\x8b \xed\xa0\x80 \xc0\x80"s;
  const std::string text = quote(every);
  EXPECT_EQ(split_words(text).at(0).text, every);
  for (const char c : text) EXPECT_GE((unsigned char)c, 0x20);
  EXPECT_EQ(quote("\xc3\xa4"), "\"\xc3\xa4\"");             // a letter stays readable
  EXPECT_EQ(quote("\xff"), "\"\\xff\"");                    // no character begins with this
  EXPECT_EQ(quote("\xed\xa0\x80"), "\"\\xed\\xa0\\x80\"");  // a surrogate is none
  EXPECT_EQ(quote_if_needed("a.b"), "a.b");
  EXPECT_EQ(quote_if_needed("-x"), "\"-x\"");
  EXPECT_EQ(quote_if_needed(""), "\"\"");
}

}  // namespace
}  // namespace plinian::graph
