#include "core/image/view_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "core/shared/view_curve.h"
#include "tests/core/image/temporary_folder.h"

namespace plinian {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

ViewTransform view(View kind, float exposure = 0.0f) {
  ViewSettings settings;
  settings.view = kind;
  settings.exposure = exposure;
  return ViewTransform(settings);
}

// $OCIO for the time of a test.
struct OcioVariable {
  explicit OcioVariable(const std::string& value) { ::setenv("OCIO", value.c_str(), 1); }
  ~OcioVariable() { ::unsetenv("OCIO"); }
};

TEST(ViewTransform, SrgbHasTheStandardsValues) {
  // IEC 61966-2-1: linear 0.18 is 0.46136, 0.5 is 0.73536, the straight part has slope 12.92.
  EXPECT_NEAR(shared::srgb_from_linear(0.18f), 0.461356f, 1e-5f);
  EXPECT_NEAR(shared::srgb_from_linear(0.5f), 0.735357f, 1e-5f);
  EXPECT_NEAR(shared::srgb_from_linear(0.001f), 0.01292f, 1e-6f);
  EXPECT_NEAR(shared::linear_from_srgb(0.5f), 0.214041f, 1e-5f);
  const vec3 shown = view(View::srgb)(vec3(-1.0f, 0.5f, 7.0f));
  EXPECT_EQ(shown.r, 0.0f);
  EXPECT_NEAR(shown.g, 0.735357f, 1e-5f);
  EXPECT_FLOAT_EQ(shown.b, 1.0f);
}

TEST(ViewTransform, AStopOfExposureDoublesTheRadiance) {
  EXPECT_EQ(view(View::srgb, 1.0f)(vec3(0.25f)), view(View::srgb)(vec3(0.5f)));
  EXPECT_EQ(view(View::filmic, -2.0f)(vec3(0.8f, 0.4f, 0.1f)), view(View::filmic)(vec3(0.2f, 0.1f, 0.025f)));
}

TEST(ViewTransform, GammaIsAPowerOfWhatWouldBeShown) {
  ViewSettings settings{.view = View::srgb, .gamma = 2.0f};
  const vec3 shown = ViewTransform(settings)(vec3(0.0f, 0.2f, 3.0f));
  EXPECT_EQ(shown.r, 0.0f);
  EXPECT_NEAR(shown.g, std::sqrt(view(View::srgb)(vec3(0.2f)).g), 1e-6f);
  EXPECT_FLOAT_EQ(shown.b, 1.0f);
  EXPECT_EQ(ViewTransform(settings).description(), "sRGB, gamma 2");
  for (const float bad : {0.0f, -1.0f, nan, infinity}) {
    settings.gamma = bad;
    EXPECT_THROW(ViewTransform{settings}, ImageError) << bad;
  }
}

TEST(ViewTransform, FilmicKeepsMiddleGreyAndEndsInBlackAndWhite) {
  EXPECT_NEAR(shared::filmic_curve(0.18f), shared::srgb_from_linear(0.18f), 2e-5f);
  EXPECT_EQ(shared::filmic_curve(0.0f), 0.0f);
  EXPECT_NEAR(shared::filmic_curve(0.18f * std::exp2(-10.0f)), 0.0f, 1e-5f);
  EXPECT_NEAR(shared::filmic_curve(0.18f * std::exp2(6.5f)), 1.0f, 1e-5f);
  EXPECT_EQ(shared::filmic_curve(-3.0f), 0.0f);
}

TEST(ViewTransform, FilmicHasItsStatedSlopeAtMiddleGrey) {
  const float half_stop = std::exp2(0.01f);
  const float rise = shared::filmic_curve(0.18f * half_stop) - shared::filmic_curve(0.18f / half_stop);
  EXPECT_NEAR(rise / 0.02f, 3.0f / 16.5f, 2e-3f);  // display per stop
}

TEST(ViewTransform, FilmicOnlyRisesAndHasNoJump) {
  float before = 0.0f;
  for (float stops = -12.0f; stops < 9.0f; stops += 0.01f) {
    const float shown = shared::filmic_curve(0.18f * std::exp2(stops));
    EXPECT_GE(shown, before) << stops;
    EXPECT_LT(shown - before, 0.01f * 3.0f / 16.5f + 1e-4f) << stops;
    before = shown;
  }
}

TEST(ViewTransform, FilmicLeavesGreysGrey) {
  for (const float value : {0.001f, 0.05f, 0.18f, 1.0f, 20.0f}) {
    const vec3 shown = view(View::filmic)(vec3(value));
    EXPECT_NEAR(shown.r, shared::filmic_curve(value), 1e-5f);
    EXPECT_EQ(shown.r, shown.g);
    EXPECT_EQ(shown.g, shown.b);
  }
}

TEST(ViewTransform, BrightFireStaysWarmAndNeverTurnsGreenOrPink) {
  // An orange flame, from 3 stops under to 5 stops over a radiance of 1: red leads green leads blue
  // throughout, with a real difference between red and blue up to +4 stops, where plain sRGB is a flat
  // yellow.
  const vec3 flame(1.0f, 0.35f, 0.03f);
  float before = 0.0f;
  for (float stops = -3.0f; stops <= 5.0f; stops += 0.5f) {
    const vec3 shown = view(View::filmic, stops)(flame);
    EXPECT_GE(shown.r, shown.g) << stops;
    EXPECT_GT(shown.g, shown.b) << stops;
    EXPECT_GT(shown.r - shown.b, stops <= 4.0f ? 0.1f : 0.0f) << stops;
    EXPECT_GT(shown.g, before) << stops;  // never stops brightening
    before = shown.g;
  }
}

TEST(ViewTransform, ValuesThatAreNotFiniteShowAsBlackOrWhite) {
  for (const View kind : {View::srgb, View::filmic}) {
    EXPECT_EQ(view(kind)(vec3(nan)), vec3(0.0f));
    const vec3 shown = view(kind, 10.0f)(vec3(infinity));
    EXPECT_NEAR(shown.r, 1.0f, 1e-6f);
    EXPECT_EQ(view(kind)(vec3(-infinity)), vec3(0.0f));
  }
}

TEST(ViewTransform, DitherKeepsBlackWhiteAndExactCodesAndTheMean) {
  Image image = make_image(256, 64);
  for (const float value : {0.0f, 1.0f, shared::linear_from_srgb(128.0f / 255.0f)}) {
    for (Channel& channel : image.channels) channel.values.assign(image.pixel_count(), value);
    const std::vector<std::uint8_t> bytes = to_display_bytes(image, view(View::srgb));
    for (const std::uint8_t byte : bytes) ASSERT_EQ(byte, bytes[0]) << value;
  }
  // A quarter of the way from code 10 to code 11: a quarter of the pixels are 11, and grey is grey.
  for (Channel& channel : image.channels)
    channel.values.assign(image.pixel_count(), shared::linear_from_srgb(10.25f / 255.0f));
  const std::vector<std::uint8_t> bytes = to_display_bytes(image, view(View::srgb));
  double sum = 0.0;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    ASSERT_TRUE(bytes[i] == 10 || bytes[i] == 11);
    ASSERT_TRUE(bytes[i] == bytes[i + 1] && bytes[i] == bytes[i + 2]);
    sum += bytes[i];
  }
  EXPECT_NEAR(sum / double(image.pixel_count()), 10.25, 0.02);
  for (const std::uint8_t byte : to_display_bytes(image, view(View::srgb), false)) ASSERT_EQ(byte, 10);
}

TEST(ViewTransform, NamesAreParsedAndUnknownOnesListed) {
  EXPECT_EQ(parse_view("srgb").view, View::srgb);
  EXPECT_EQ(parse_view("filmic").view, View::filmic);
  const ViewSettings settings = parse_view("ocio:sRGB - Display/ACES 1.0");
  EXPECT_EQ(settings.view, View::ocio);
  EXPECT_EQ(settings.ocio_display, "sRGB - Display");
  EXPECT_EQ(settings.ocio_view, "ACES 1.0");
  EXPECT_EQ(message_of<ImageError>([] { parse_view("aces"); }),
            "view: unknown view 'aces': use srgb, filmic, ocio or ocio:DISPLAY/VIEW");
}

const char* const small_config = R"(ocio_profile_version: 2
roles:
  scene_linear: lin
  default: lin
displays:
  Screen:
    - !<View> {name: Half, colorspace: half}
    - !<View> {name: Raw, colorspace: lin}
  Projector:
    - !<View> {name: Raw, colorspace: lin}
active_displays: [Screen, Projector]
colorspaces:
  - !<ColorSpace> {name: lin}
  - !<ColorSpace>
    name: half
    from_scene_reference: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.25, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}
)";

TEST(ViewTransform, AnOpenColorIoViewIsApplied) {
  const TemporaryFolder folder;
  std::ofstream(folder / "config.ocio") << small_config;
  const OcioVariable variable(folder / "config.ocio");
  EXPECT_EQ(default_view(), View::ocio);
  const ViewTransform transform = view(View::ocio, 1.0f);
  EXPECT_EQ(transform.description(), "Screen / Half, +1 stop");
  std::string views;
  for (const OcioView& known : ocio_views()) views += known.display + "/" + known.view + " ";
  EXPECT_EQ(views, "Screen/Half Screen/Raw Projector/Raw ") << "to choose from, the default first";
  const vec3 shown = transform(vec3(0.4f, 0.4f, 0.4f));
  EXPECT_NEAR(shown.r, 0.4f, 1e-6f);
  EXPECT_NEAR(shown.g, 0.2f, 1e-6f);
  EXPECT_NEAR(shown.b, 0.8f, 1e-6f);
  EXPECT_EQ(transform(vec3(10.0f, -1.0f, nan)), vec3(1, 0, 0));
}

TEST(ViewTransform, OpenColorIoErrorsNameTheFileAndWhatThereIs) {
  const TemporaryFolder folder;
  std::ofstream(folder / "config.ocio") << small_config;
  std::ofstream(folder / "broken.ocio") << "displays: [";
  ViewSettings settings;
  settings.view = View::ocio;
  EXPECT_NE(message_of<ImageError>([&] { ViewTransform{settings}; }).find("set $OCIO"), std::string::npos);
  EXPECT_EQ(default_view(), View::filmic);
  EXPECT_TRUE(ocio_views().empty());
  settings.ocio_config = folder / "config.ocio";
  settings.ocio_display = "Laser";
  EXPECT_NE(message_of<ImageError>([&] { ViewTransform{settings}; }).find("it has Screen, Projector"),
            std::string::npos);
  settings.ocio_display = "Screen";
  settings.ocio_view = "Film";
  EXPECT_NE(message_of<ImageError>([&] { ViewTransform{settings}; }).find("it has Half, Raw"),
            std::string::npos);
  for (const char* name : {"broken.ocio", "missing.ocio"}) {
    settings.ocio_config = folder / name;
    const std::string message = message_of<ImageError>([&] { ViewTransform{settings}; });
    EXPECT_NE(message.find(std::string(name) + ": OpenColorIO cannot use"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace plinian
