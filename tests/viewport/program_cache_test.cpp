// Programs of a pass: kept while they are used, and a few beside them.
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

TEST(ProgramCache, KeepsThoseOfTheLastPictureAndAFewMore) {
  const gl::EglContext context;
  ProgramCache cache("viewport/passes/map_pass.comp", 2);
  const auto name = [&](int coefficients) { return cache.get(defines_for(coefficients)).program.name(); };
  const unsigned six = name(6), seven = name(7);
  EXPECT_NE(six, 0u);
  EXPECT_EQ(name(6), six);
  // However many one picture takes, all of them are there until it is done.
  for (int coefficients = 8; coefficients < 12; ++coefficients) name(coefficients);
  EXPECT_EQ(name(7), seven);
  EXPECT_EQ(cache.size(), 6u);
  cache.end_picture();
  EXPECT_EQ(cache.size(), 6u) << "it used them all";
  EXPECT_EQ(name(6), six);
  cache.end_picture();
  EXPECT_EQ(cache.size(), 3u);
  EXPECT_EQ(name(7), seven) << "of the others it was used last";
  EXPECT_TRUE(glIsProgram(six));
  cache.end_picture();
  cache.end_picture();
  EXPECT_EQ(cache.size(), 2u) << "a picture whose maps were there";
  EXPECT_EQ(name(7), seven);
  EXPECT_NE(name(7), 0u);
}

}  // namespace
}  // namespace plinian::passes
