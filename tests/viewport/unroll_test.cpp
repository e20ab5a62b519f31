#include "viewport/gl/unroll.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace plinian::gl {
namespace {

std::string tight(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  return text;
}

TEST(Unroll, WritesAStatementOnceForEachIndex) {
  EXPECT_EQ(tight(unroll("#unroll EACH i N\nEACH a += b[i];\n", {{"N", "2"}})),
            "{{constinti=0;a+=b[i];}{constinti=1;a+=b[i];}}");
}

TEST(Unroll, KnowsBlocksByTheirLastBrace) {
  EXPECT_EQ(tight(unroll("#unroll EACH i 1\nEACH { f(i); if (x) { g(); } }\nrest();", {})),
            "{{constinti=0;{f(i);if(x){g();}}}}rest();");
}

TEST(Unroll, WritesNothingForNone) {
  EXPECT_EQ(tight(unroll("#unroll EACH i N\nEACH f(i);\nrest();", {{"N", "0"}})), "{}rest();");
}

TEST(Unroll, NestsInEitherOrder) {
  const std::string body = "A { B f(i, j); }\n";
  const std::string first = tight(unroll("#unroll A i 2\n#unroll B j 2\n" + body, {}));
  EXPECT_EQ(first, tight(unroll("#unroll B j 2\n#unroll A i 2\n" + body, {})));
  std::size_t calls = 0;
  for (std::size_t at = 0; (at = first.find("f(i,j)", at)) != first.npos; ++at) ++calls;
  EXPECT_EQ(calls, 4u);
}

TEST(Unroll, LeavesAloneWhatStandsBeforeAndOtherNamesAndThePreprocessor) {
  const std::string before = "EACH early();\n";
  const std::string after = "#define EACH_ONE EACH\nEACHES f();\nNO_EACH g();\n";
  EXPECT_EQ(unroll(before + "#unroll EACH i 3" + "\n" + after, {}), before + "\n" + after);
}

TEST(Unroll, RefusesWhatIsNoCount) {
  for (const char* count : {"oops", "-1", "65", "", "2x"})
    EXPECT_THROW(unroll("#unroll EACH i " + std::string(count) + "\n", {}), std::runtime_error) << count;
}

TEST(Unroll, RefusesAStatementWithoutAnEnd) {
  EXPECT_THROW(unroll("#unroll EACH i 1\nEACH { f(i);", {}), std::runtime_error);
}

}  // namespace
}  // namespace plinian::gl
