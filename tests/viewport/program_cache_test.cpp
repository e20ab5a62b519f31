// Programs of a pass: kept while they are used, and no more than so many.
#include "viewport/passes/program_cache.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "viewport/gl/egl_context.h"

namespace plinian::passes {
namespace {

gl::Defines defines_for(int coefficients) {
  return {{"MEDIA_COUNT", "1"},        {"OF_MEDIUM(fetch)", "fetch(0)"},
          {"LIGHT_COUNT", "1"},        {"MAP_COUNT", "1"},
          {"GROUP_COUNT", "1"},        {"MAP_COEFFICIENTS", std::to_string(coefficients)},
          {"MAP_WEIGHTING", "2.0"},    {"GREY_EXTINCTION", "true"},
          {"ANALYTIC_MEDIA", "false"}, {"EMISSIVE_MEDIA", "false"},
          {"VARIED_LIGHT", "false"},   {"SEVERAL_MEDIA", "false"},
          {"DEEP_TREES", "false"},     {"LIGHT_MARCH", "false"},
          {"LIGHT_ERROR", "false"},    {"LIGHT_MARCH_STEP", "1.0"},
          {"LIGHT_MARCH_DEPTH", "5.0"}};
}

TEST(ProgramCache, KeepsThoseThatAreUsedAndLetsTheOthersGo) {
  const gl::EglContext context;
  ProgramCache cache("viewport/passes/map_pass.comp", 3);
  const unsigned six = cache.get(defines_for(6)).program.name();
  EXPECT_NE(six, 0u);
  EXPECT_EQ(cache.get(defines_for(6)).program.name(), six);
  const unsigned seven = cache.get(defines_for(7)).program.name();
  for (int coefficients = 8; coefficients < 12; ++coefficients) {
    cache.get(defines_for(coefficients));
    EXPECT_EQ(cache.get(defines_for(6)).program.name(), six) << "it is used again and again";
  }
  EXPECT_EQ(cache.size(), 3u);
  EXPECT_TRUE(glIsProgram(six));
  EXPECT_FALSE(glIsProgram(seven)) << "it is not";
}

}  // namespace
}  // namespace plinian::passes
