// What is written is read by libpng, which checks every checksum.
#include "core/image/png_encoder.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/image/image.h"

namespace plinian {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Read {
  OIIO::ImageSpec spec;
  Bytes pixels;
};

Read read(const Bytes& file) {
  OIIO::Filesystem::IOMemReader memory(const_cast<std::uint8_t*>(file.data()), file.size());
  const auto input = OIIO::ImageInput::create("png");
  OIIO::ImageSpec spec;
  EXPECT_TRUE(input->set_ioproxy(&memory) && input->open("a.png", spec)) << input->geterror();
  Bytes pixels(std::size_t(spec.image_bytes()));
  EXPECT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeUInt8, pixels.data()))
      << input->geterror();
  return {spec, pixels};
}

// A different kind of content in each band of rows, so that every filter has rows that it packs best.
Bytes picture(int width, int height) {
  Bytes rgb;
  std::uint32_t noise = 1;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) {
        noise = noise * 1664525u + 1013904223u;
        const int smooth = int(127.0 + 120.0 * std::sin(0.11 * x + 0.07 * y + c));
        const int kinds[6] = {smooth, int(noise >> 24), 3 * x + c, x % 7 * 30 + c, x * y / 16, 200};
        rgb.push_back(std::uint8_t(kinds[y * 6 / height]));
      }
  return rgb;
}

TEST(PngEncoder, EveryPixelOfEverySizeComesBackThroughLibpng) {
  for (const auto& [width, height] :
       {std::pair(1, 1), std::pair(1, 300), std::pair(300, 1), std::pair(2, 3), std::pair(257, 190)}) {
    const Bytes rgb = picture(width, height);
    const Read back = read(png_of(rgb, width, height, {}));
    EXPECT_EQ(back.spec.width, width);
    EXPECT_EQ(back.spec.height, height);
    EXPECT_EQ(back.spec.nchannels, 3);
    EXPECT_EQ(back.spec.format, OIIO::TypeUInt8);
    EXPECT_EQ(back.spec.get_string_attribute("oiio:ColorSpace"), "sRGB");
    EXPECT_TRUE(back.pixels == rgb) << width << "x" << height;
  }
}

TEST(PngEncoder, WhatIsSmoothIsPackedAndWhatIsNoiseGrowsLittle) {
  const Bytes flat(3 * 512 * 512, 90);
  EXPECT_LT(png_of(flat, 512, 512, {}).size(), 4000u);
  Bytes ramp, noise;
  std::uint32_t random = 7;
  for (int i = 0; i < 512 * 512; ++i)
    for (int c = 0; c < 3; ++c) {
      ramp.push_back(std::uint8_t(i % 512 / 2 + c));
      noise.push_back(std::uint8_t((random = random * 1664525u + 1013904223u) >> 24));
    }
  EXPECT_LT(png_of(ramp, 512, 512, {}).size(), ramp.size() / 50);
  const Bytes file = png_of(noise, 512, 512, {});  // in a dozen chunks
  EXPECT_LT(file.size(), noise.size() + noise.size() / 100);
  EXPECT_TRUE(read(file).pixels == noise);
}

TEST(PngEncoder, TextKeepsEveryLetterAndKeysThatCannotBeStoredAreLeftOut) {
  const std::string long_text(100000, 'x'), umlaut =
                                                "Rauch \xc3\xbc"
                                                "ber \xe7\x81\xb0";
  const Read back = read(png_of(Bytes(3), 1, 1,
                                {{"plinian:command", "plinian render ash"},
                                 {"two lines", "a\nb"},
                                 {"long", long_text},
                                 {"unicode", umlaut},
                                 {"", "no key"},
                                 {std::string(80, 'k'), "too long a key"}}));
  EXPECT_EQ(back.spec.get_string_attribute("plinian:command"), "plinian render ash");
  EXPECT_EQ(back.spec.get_string_attribute("two lines"), "a\nb");
  EXPECT_EQ(back.spec.get_string_attribute("long"), long_text);
  EXPECT_EQ(back.spec.get_string_attribute("unicode"), umlaut);
  EXPECT_EQ(back.spec.get_string_attribute(std::string(80, 'k')), "");
}

TEST(PngEncoder, PixelsThatDoNotFitTheSizeAreRefused) {
  for (const auto& [bytes, width, height] :
       {std::tuple(11, 2, 2), std::tuple(0, 0, 0), std::tuple(3, -1, -1)})
    EXPECT_THROW(png_of(Bytes(std::size_t(bytes)), width, height, {}), ImageError);
}

}  // namespace
}  // namespace plinian
