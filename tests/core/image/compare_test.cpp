#include "core/image/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/core/image/temporary_folder.h"

namespace plinian {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

CompareResult grey_against_lighter() {
  Image a = make_image(16, 12, vec3(0.6f));
  a.find("G")->values[5 * 16 + 3] = 0.9f;
  return compare_images(a, make_image(16, 12, vec3(0.5f)));
}

TEST(Compare, TakesEveryFigureAtOnce) {
  const CompareResult result = grey_against_lighter();
  EXPECT_NEAR(result.pixels.mse, (575.0 * 0.01 + 0.16) / 576.0, 1e-7);
  EXPECT_NEAR(result.pixels.max_error, 0.4, 1e-6);
  EXPECT_EQ(result.pixels.max_error_at, ivec2(3, 5));
  ASSERT_EQ(result.flips.size(), 2u);
  EXPECT_EQ(result.flips[0].exposure, 0.0f);
  EXPECT_EQ(result.flips[1].exposure, 3.0f);
  EXPECT_GT(result.flips[0].flip.mean, 0.1f);
  EXPECT_EQ(result.flips[1].flip.mean, 0.0f) << "at +3 stops both are white";
  EXPECT_NEAR(result.error[5 * 16 + 3], 0.4f, 1e-6f);
  EXPECT_NEAR(result.error[0], 0.1f, 1e-6f);
  EXPECT_TRUE(result.notes.empty());
}

TEST(Compare, LimitsAreParsed) {
  const std::vector<Limit> limits = parse_limits("psnr=35, ssim=0.97,flip=1e-1");
  ASSERT_EQ(limits.size(), 3u);
  EXPECT_EQ(limits[0].key, "psnr");
  EXPECT_EQ(limits[0].value, 35.0);
  EXPECT_EQ(limits[1].key, "ssim");
  EXPECT_EQ(limits[2].value, 0.1);
}

TEST(Compare, BadLimitsAreErrorsThatNameTheKey) {
  EXPECT_EQ(message_of<ImageError>([] { parse_limits("psnr=35,sim=0.9"); }),
            "limits: unknown key 'sim' in 'psnr=35,sim=0.9'; known are psnr, psnr_mask, ssim, flip, flip3, "
            "max_error, "
            "mse, mean");
  EXPECT_EQ(message_of<ImageError>([] { parse_limits("psnr=high"); }),
            "limits: psnr needs a number, not 'high', as in psnr=0.5");
  for (const char* text : {"", "psnr", "psnr=", "psnr=3x", "psnr=nan", "psnr=35,", "=3"})
    EXPECT_THROW(parse_limits(text), ImageError) << text;
}

TEST(Compare, EachLimitFailsOnItsOwnSide) {
  const CompareResult result = grey_against_lighter();  // PSNR 19.89, mean ratio 1.2010
  const auto fails = [&](const char* limits) { return !failed_limits(result, parse_limits(limits)).empty(); };
  EXPECT_TRUE(fails("psnr=20"));
  EXPECT_FALSE(fails("psnr=19"));
  EXPECT_TRUE(fails("ssim=0.9999"));
  EXPECT_FALSE(fails("ssim=0.5"));
  EXPECT_TRUE(fails("flip=0.01"));
  EXPECT_FALSE(fails("flip=0.9,flip3=0"));
  EXPECT_TRUE(fails("max_error=0.3"));
  EXPECT_FALSE(fails("max_error=0.5"));
  EXPECT_TRUE(fails("mse=0.01"));
  EXPECT_FALSE(fails("mse=0.011"));
  EXPECT_TRUE(fails("mean=0.2"));
  EXPECT_FALSE(fails("mean=0.21"));
  EXPECT_TRUE(fails("psnr_mask=1")) << "there is no alpha to measure under";
  EXPECT_EQ(failed_limits(result, parse_limits("psnr=19,ssim=2,max_error=0.3")),
            (std::vector<std::string>{failed_limits(result, parse_limits("ssim=2")).at(0),
                                      "max_error 0.4 is over 0.3"}));
}

TEST(Compare, DarkerThanTheReferenceFailsTheMeanToo) {
  const CompareResult result = compare_images(make_image(12, 12, vec3(0.4f)), make_image(12, 12, vec3(0.5f)));
  EXPECT_EQ(failed_limits(result, parse_limits("mean=0.1")).size(), 1u);
}

TEST(Compare, EqualPicturesKeepEveryLimit) {
  Image image = make_image(12, 12, vec3(0.5f));
  image.add("A", 1.0f);
  const CompareResult result = compare_images(image, image);
  EXPECT_TRUE(
      failed_limits(result, parse_limits("psnr=200,psnr_mask=200,ssim=1,flip=0,flip3=0,max_error=0,mse=0,"
                                         "mean=0"))
          .empty());
  const auto json = nlohmann::json::parse(compare_json(result));
  EXPECT_TRUE(json["identical"].get<bool>());
  EXPECT_TRUE(json["psnr"].is_null());
}

TEST(Compare, PixelsThatAreNotFiniteFailALimitAndAreSaidAloud) {
  Image a = make_image(12, 12, vec3(0.5f));
  const Image reference = a;
  a.find("B")->values[7] = nan;
  const CompareResult result = compare_images(a, reference);
  EXPECT_EQ(result.bad_a, 1u);
  EXPECT_TRUE(std::isnan(result.error[7]));
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_EQ(result.notes[0],
            "pixels that are not finite: 1 in the picture, 0 in the reference; left out of every figure");
  EXPECT_EQ(failed_limits(result, parse_limits("psnr=10")),
            (std::vector<std::string>{"1 pixels are not finite"}));
  EXPECT_TRUE(failed_limits(result, {}).empty());
  EXPECT_FALSE(nlohmann::json::parse(compare_json(result))["identical"].get<bool>());
}

TEST(Compare, DisplayPicturesAreSaidAloud) {
  Image a = make_image(4, 4);
  a.display_referred = true;
  const CompareResult result = compare_images(a, make_image(4, 4));
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("the picture holds display values"), std::string::npos);
}

TEST(Compare, JsonHoldsTheFigures) {
  const CompareResult result = grey_against_lighter();
  const auto json = nlohmann::json::parse(compare_json(result, {"psnr 19 is under 35"}));
  EXPECT_EQ(json["size"], (nlohmann::json{16, 12}));
  EXPECT_DOUBLE_EQ(json["psnr"].get<double>(), result.pixels.psnr);
  EXPECT_DOUBLE_EQ(json["ssim"].get<double>(), result.ssim);
  EXPECT_TRUE(json["psnr_mask"].is_null());
  EXPECT_EQ(json["flip"][1]["exposure"].get<double>(), 3.0);
  EXPECT_FLOAT_EQ(json["flip"][0]["mean"].get<float>(), result.flips[0].flip.mean);
  EXPECT_EQ(json["max_error_at"], (nlohmann::json{3, 5}));
  EXPECT_EQ(json["failures"][0], "psnr 19 is under 35");
}

}  // namespace
}  // namespace plinian
