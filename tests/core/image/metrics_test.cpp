#include "core/image/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/core/image/temporary_folder.h"

namespace plinian {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

void set(Image& image, int x, int y, vec3 colour) {
  const std::size_t i = std::size_t(y) * std::size_t(image.width) + std::size_t(x);
  image.find("R")->values[i] = colour.r;
  image.find("G")->values[i] = colour.g;
  image.find("B")->values[i] = colour.b;
}

// A picture with structure everywhere, values in [0, 1).
Image textured(int width, int height, int seed) {
  Image image = make_image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      set(image, x, y,
          vec3(float((x * 7 + y * 3 + seed) % 11) / 11.0f, float((x * 5 + y * y) % 13) / 13.0f,
               float((x * y + seed) % 7) / 7.0f));
  return image;
}

TEST(Metrics, AUniformDifferenceHasItsMseAndPsnr) {
  const Image a = make_image(8, 4, vec3(0.6f, 0.5f, 0.5f)), reference = make_image(8, 4, vec3(0.5f));
  const PixelMetrics metrics = pixel_metrics(pair_pictures(a, reference));
  EXPECT_NEAR(metrics.mse, 0.01 / 3.0, 1e-8);
  EXPECT_EQ(metrics.peak, 1.0);
  EXPECT_NEAR(metrics.psnr, 24.7712, 1e-4);  // 10 log10(300)
  EXPECT_NEAR(metrics.max_error, 0.1, 1e-6);
  EXPECT_NEAR(*metrics.mean_ratio, 1.6 / 1.5, 1e-6);
  EXPECT_FALSE(metrics.psnr_mask);
}

TEST(Metrics, EqualPicturesHaveInfinitePsnr) {
  const Image image = textured(16, 16, 1);
  const PixelMetrics metrics = pixel_metrics(pair_pictures(image, image));
  EXPECT_EQ(metrics.mse, 0.0);
  EXPECT_TRUE(std::isinf(metrics.psnr));
  EXPECT_EQ(metrics.max_error, 0.0);
  EXPECT_EQ(*metrics.mean_ratio, 1.0);
  EXPECT_EQ(ssim(pair_pictures(image, image), 1.0), 1.0);
}

TEST(Metrics, ThePeakIsTheNearestRankOfAllChannelsTogether) {
  // 1,000 grey pixels are 3,000 values; rank 2,997 is the last that is not among the three brightest.
  Image reference = make_image(1000, 1, vec3(2.0f));
  set(reference, 17, 0, vec3(100.0f, 100.0f, 100.0f));
  EXPECT_EQ(peak_of(pair_pictures(reference, reference)), 2.0);
  set(reference, 18, 0, vec3(2.0f, 30.0f, 2.0f));  // a fourth bright value: rank 2,997 is now it
  EXPECT_EQ(peak_of(pair_pictures(reference, reference)), 30.0);
  const Image dark = make_image(10, 10, vec3(0.01f));
  EXPECT_EQ(peak_of(pair_pictures(dark, dark)), 1.0) << "never under 1";
}

TEST(Metrics, PsnrIsMeasuredAgainstThePeakOfTheReference) {
  const Image a = make_image(8, 8, vec3(11.0f)), reference = make_image(8, 8, vec3(10.0f));
  EXPECT_NEAR(pixel_metrics(pair_pictures(a, reference)).psnr, 20.0, 1e-5);     // 10 log10(100 / 1)
  EXPECT_NEAR(pixel_metrics(pair_pictures(reference, a)).psnr, 20.8279, 1e-4);  // 10 log10(121 / 1)
}

TEST(Metrics, TheMaskKeepsABlackBackgroundFromFlatteringPsnr) {
  Image reference = make_image(10, 10), a = make_image(10, 10);
  std::vector<float>& alpha = reference.add("A").values;
  for (int x = 0; x < 10; ++x) {
    set(a, x, 0, vec3(0.1f));
    alpha[std::size_t(x)] = 0.5f;
    alpha[std::size_t(10 + x)] = 0.01f;  // not over 0.01
  }
  const PixelMetrics metrics = pixel_metrics(pair_pictures(a, reference));
  EXPECT_NEAR(metrics.psnr, 30.0, 1e-5);
  EXPECT_NEAR(*metrics.psnr_mask, 20.0, 1e-5);
  EXPECT_EQ(metrics.mask_pixels, 10u);
}

TEST(Metrics, TheLargestErrorIsFoundWithItsPlace) {
  Image a = make_image(9, 7, vec3(0.5f));
  const Image reference = a;
  set(a, 6, 2, vec3(0.5f, -0.25f, 0.5f));
  set(a, 1, 5, vec3(1.0f, 0.5f, 0.5f));
  const PixelMetrics metrics = pixel_metrics(pair_pictures(a, reference));
  EXPECT_EQ(metrics.max_error, 0.75);
  EXPECT_EQ(metrics.max_error_at, ivec2(6, 2));
}

TEST(Metrics, SsimOfFlatPicturesIsItsLuminanceTerm) {
  // Variances vanish: (2 a b + c1) / (a^2 + b^2 + c1) with c1 = 1e-4 and a, b = 0.5, 0.25 is 0.2501 / 0.3126.
  const PicturePair pair = pair_pictures(make_image(20, 20, vec3(0.5f)), make_image(20, 20, vec3(0.25f)));
  EXPECT_NEAR(ssim(pair, 1.0), 0.800064, 1e-6);
  // A peak of 10 puts c1 at 1e-2: 0.26 / 0.3225.
  EXPECT_NEAR(ssim(pair, 10.0), 0.806202, 1e-6);
}

TEST(Metrics, SsimWeighsLuminance) {
  // Only green differs: luminances 0.7152 and 0.
  const PicturePair pair = pair_pictures(make_image(20, 20, vec3(0, 1, 0)), make_image(20, 20));
  EXPECT_NEAR(ssim(pair, 1.0), 1e-4 / (0.7152 * 0.7152 + 1e-4), 1e-8);
}

TEST(Metrics, SsimOfOneWindowIsTheFormulaWrittenOut) {
  // 11 x 11 pixels hold one window, so SSIM is one evaluation of the published formula, here with a full
  // two-dimensional Gaussian.
  const Image a = textured(11, 11, 0), b = textured(11, 11, 5);
  double weight_sum = 0, ma = 0, mb = 0;
  const auto weight = [](int x, int y) {
    return std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / (2.0 * 2.25));
  };
  const auto luminance = [](const Image& image, int i) {
    const vec3 v = colour_of(image)[std::size_t(i)];
    return 0.2126 * v.r + 0.7152 * v.g + 0.0722 * v.b;
  };
  for (int i = 0; i < 121; ++i) {
    weight_sum += weight(i % 11, i / 11);
    ma += weight(i % 11, i / 11) * luminance(a, i);
    mb += weight(i % 11, i / 11) * luminance(b, i);
  }
  ma /= weight_sum, mb /= weight_sum;
  double va = 0, vb = 0, cov = 0;
  for (int i = 0; i < 121; ++i) {
    const double w = weight(i % 11, i / 11) / weight_sum, da = luminance(a, i) - ma,
                 db = luminance(b, i) - mb;
    va += w * da * da, vb += w * db * db, cov += w * da * db;
  }
  const double expected =
      (2 * ma * mb + 1e-4) * (2 * cov + 9e-4) / ((ma * ma + mb * mb + 1e-4) * (va + vb + 9e-4));
  EXPECT_LT(expected, 0.9);
  EXPECT_NEAR(ssim(pair_pictures(a, b), 1.0), expected, 1e-9);
}

TEST(Metrics, SsimFallsWhenStructureIsLostAndGoesNegativeWhenItIsInverted) {
  const Image image = textured(40, 40, 3);
  Image inverted = image;
  for (Channel& channel : inverted.channels)
    for (float& value : channel.values) value = 1.0f - value;
  EXPECT_LT(ssim(pair_pictures(inverted, image), 1.0), 0.0);
}

TEST(Metrics, SsimOfATinyPictureIsStillMeasured) {
  const PicturePair pair = pair_pictures(make_image(3, 2, vec3(0.5f)), make_image(3, 2, vec3(0.25f)));
  EXPECT_NEAR(ssim(pair, 1.0), 0.800064, 1e-6);
}

TEST(Metrics, PixelsThatAreNotFiniteAreCountedAndPoisonNothing) {
  Image a = textured(24, 24, 1), reference = textured(24, 24, 2);
  const PixelMetrics clean = pixel_metrics(pair_pictures(a, reference));
  set(a, 3, 3, vec3(nan, 0, 0));
  set(a, 4, 3, vec3(0, std::numeric_limits<float>::infinity(), 0));
  set(reference, 4, 3, vec3(nan));
  const PicturePair pair = pair_pictures(a, reference);
  EXPECT_EQ(pair.bad_a, 2u);
  EXPECT_EQ(pair.bad_reference, 1u);
  const PixelMetrics metrics = pixel_metrics(pair);
  EXPECT_NEAR(metrics.psnr, clean.psnr, 0.1);
  EXPECT_TRUE(std::isfinite(ssim(pair, metrics.peak)));
}

TEST(Metrics, APictureOfNothingButNaNIsMeasuredWithoutHarm) {
  const Image bad = make_image(12, 12, vec3(nan)), good = make_image(12, 12, vec3(0.5f));
  const PicturePair pair = pair_pictures(bad, good);
  EXPECT_EQ(pair.bad_a, 144u);
  const PixelMetrics metrics = pixel_metrics(pair);
  EXPECT_EQ(metrics.mse, 0.0);
  EXPECT_FALSE(metrics.mean_ratio);
  EXPECT_EQ(ssim(pair, metrics.peak), 1.0);
}

TEST(Metrics, PicturesOfDifferentSizesAreRefusedInOneLine) {
  EXPECT_EQ(message_of<ImageError>([] { pair_pictures(make_image(4, 5), make_image(5, 4)); }),
            "the pictures differ in size: 4x5 and 5x4; render or crop them to one size");
}

}  // namespace
}  // namespace plinian
