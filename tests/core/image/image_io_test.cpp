#include "core/image/image_io.h"

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "tests/core/image/temporary_folder.h"

namespace plinian {
namespace {

Image sample() {
  Image image = make_image(5, 3);
  for (int i = 0; i < 15; ++i) {
    image.find("R")->values[i] = 0.1f * float(i);
    image.find("G")->values[i] = float(i * i);
    image.find("B")->values[i] = 1.0f / float(i + 1);
  }
  image.add("A", 0.5f);
  image.add("Z", 12345.678f).values[4] = std::numeric_limits<float>::infinity();
  image.add("key.R", 3.0f);
  return image;
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ImageIo, FloatExrKeepsEveryBit) {
  const TemporaryFolder folder;
  WriteOptions options;
  options.exr_pixels = ExrPixels::single_float;
  const Image written = sample();
  write_image(folder / "a.exr", written, options);
  EXPECT_EQ(folder.entries(), 1u);
  const Image read = read_image(folder / "a.exr");
  EXPECT_EQ(read.width, 5);
  EXPECT_EQ(read.height, 3);
  EXPECT_FALSE(read.display_referred);
  ASSERT_EQ(read.channels.size(), written.channels.size());
  for (const Channel& channel : written.channels) {
    ASSERT_TRUE(read.find(channel.name)) << channel.name;
    EXPECT_EQ(read.find(channel.name)->values, channel.values) << channel.name;
  }
}

TEST(ImageIo, HalfExrRoundsToHalfButKeepsDepthAndNeverOverflows) {
  const TemporaryFolder folder;
  Image image = sample();
  image.find("R")->values[0] = 1e6f;
  image.find("R")->values[1] = 1.0f + 1.0f / 4096.0f;  // half way between halves is 1 + 1/2048
  write_image(folder / "a.exr", image);
  const Image read = read_image(folder / "a.exr");
  EXPECT_EQ(read.find("R")->values[0], 65504.0f);
  EXPECT_EQ(read.find("R")->values[1], 1.0f);
  EXPECT_EQ(read.find("Z")->values[0], 12345.678f);
  EXPECT_TRUE(std::isinf(read.find("Z")->values[4]));
}

TEST(ImageIo, MetadataComesBack) {
  const TemporaryFolder folder;
  Image image = sample();
  const Camera camera = look_at(dvec3(1, 2, 3), dvec3(0), dvec3(0, 1, 0), 40.0);
  add_camera_metadata(image, camera);
  image.metadata[attribute::command] = std::string("plinian render ash -o a.exr");
  image.metadata[attribute::seed] = 7;
  image.metadata[std::string(attribute::time_prefix) + "map"] = 12.5f;
  write_image(folder / "a.exr", image);
  const Image read = read_image(folder / "a.exr");
  for (const auto& [name, value] : image.metadata) {
    ASSERT_TRUE(read.metadata.count(name)) << name;
    EXPECT_TRUE(read.metadata.at(name) == value) << name;
  }
}

TEST(ImageIo, CameraMatrixIsStoredAsOpenExrWritesRowVectors) {
  const TemporaryFolder folder;
  Image image = make_image(2, 2);
  Camera camera;
  camera.world_from_camera[3] = dvec4(10, 20, 30, 1);
  add_camera_metadata(image, camera);
  write_image(folder / "a.exr", image);
  // The file's name for it, and 16 floats whose last row is the translation into the camera.
  const std::string bytes = bytes_of(folder / "a.exr");
  const std::size_t at = bytes.find(std::string("worldToCamera\0m44f\0", 19));
  ASSERT_NE(at, std::string::npos);
  float matrix[16];
  std::memcpy(matrix, bytes.data() + at + 19 + 4, sizeof matrix);
  EXPECT_EQ(matrix[0], 1.0f);
  EXPECT_EQ(matrix[12], -10.0f);
  EXPECT_EQ(matrix[13], -20.0f);
  EXPECT_EQ(matrix[14], -30.0f);
  EXPECT_EQ(matrix[15], 1.0f);
}

TEST(ImageIo, CompressionsDifferInSizeAndDwaaStaysClose) {
  const TemporaryFolder folder;
  Image image = make_image(256, 256);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x)
      for (Channel& channel : image.channels)
        channel.values[std::size_t(y) * 256 + x] =
            0.5f + 0.4f * std::sin(0.05f * float(x)) * std::cos(0.07f * float(y));
  WriteOptions options;
  std::map<ExrCompression, std::size_t> sizes;
  for (const ExrCompression compression : {ExrCompression::none, ExrCompression::zip, ExrCompression::dwaa}) {
    options.exr_compression = compression;
    write_image(folder / "a.exr", image, options);
    sizes[compression] = bytes_of(folder / "a.exr").size();
    const Image read = read_image(folder / "a.exr");
    for (std::size_t i = 0; i < image.pixel_count(); ++i)
      ASSERT_NEAR(read.find("G")->values[i], image.find("G")->values[i], 0.01f);
  }
  EXPECT_GT(sizes[ExrCompression::none], 3u * 2u * 65536u);
  EXPECT_LT(sizes[ExrCompression::zip], sizes[ExrCompression::none]);
  EXPECT_LT(2 * sizes[ExrCompression::dwaa], sizes[ExrCompression::zip]);
}

TEST(ImageIo, PngShowsThePictureThroughTheViewAndReadsBackLinear) {
  const TemporaryFolder folder;
  WriteOptions options;
  options.view.view = View::srgb;
  options.view.exposure = 1.0f;
  options.dither = false;
  Image image = make_image(2, 1, vec3(0.25f, 0.0f, 4.0f));
  image.metadata[attribute::command] = std::string("plinian render ash");
  write_image(folder / "a.PNG", image, options);
  const std::string bytes = bytes_of(folder / "a.PNG");
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  const Image read = read_image(folder / "a.PNG");
  EXPECT_TRUE(read.display_referred);
  const vec3 pixel = colour_of(read)[1];
  EXPECT_NEAR(pixel.r, 0.502886f, 1e-5f);  // linear 0.5 is 187.5 of 255, code 188, which is linear 0.502886
  EXPECT_EQ(pixel.g, 0.0f);
  EXPECT_EQ(pixel.b, 1.0f);
  EXPECT_EQ(std::get<std::string>(read.metadata.at(attribute::command)), "plinian render ash");
  EXPECT_EQ(std::get<std::string>(read.metadata.at("plinian:view")), "sRGB, +1 stop");
}

TEST(ImageIo, ADataWindowIsPlacedIntoItsDisplayWindow) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(2, 2, 1, OIIO::TypeFloat);
  spec.channelnames = {"Y"};
  spec.x = 3, spec.y = 1;
  spec.full_x = spec.full_y = 0;
  spec.full_width = 4, spec.full_height = 3;
  const float pixels[4] = {1, 2, 3, 4};  // the right half lies outside the display window
  const auto out = OIIO::ImageOutput::create("exr");
  ASSERT_TRUE(out->open(folder / "a.exr", spec) && out->write_image(OIIO::TypeFloat, pixels) && out->close());
  const Image read = read_image(folder / "a.exr");
  EXPECT_EQ(read.width, 4);
  EXPECT_EQ(read.height, 3);
  EXPECT_EQ(read.channels[0].values, (std::vector<float>{0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 3}));
}

TEST(ImageIo, UnassociatedAlphaIsMultipliedInAfterLinearisation) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeUInt8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  const std::uint8_t pixel[4] = {188, 255, 0, 51};
  const auto out = OIIO::ImageOutput::create("png");
  ASSERT_TRUE(out->open(folder / "a.png", spec) && out->write_image(OIIO::TypeUInt8, pixel) && out->close());
  const Image read = read_image(folder / "a.png");
  EXPECT_NEAR(read.find("R")->values[0], 0.502886f * 0.2f, 1e-5f);
  EXPECT_NEAR(read.find("G")->values[0], 0.2f, 1e-6f);
  EXPECT_NEAR(read.find("A")->values[0], 0.2f, 1e-6f);
}

TEST(ImageIo, UnknownExtensionsAreRefusedWithTheKnownOnes) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.bmp";
  EXPECT_EQ(message_of<ImageError>([&] { check_output(path); }),
            path + ": cannot be written: unknown extension .bmp; use one of .exr, .png");
  EXPECT_EQ(message_of<ImageError>([&] { write_image(folder / "a", sample()); }),
            (folder / "a") + ": cannot be written: no extension; use one of .exr, .png");
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(ImageIo, AnOutputIsCheckedBeforeAnythingIsRendered) {
  const TemporaryFolder folder;
  check_output(folder / "a.exr");
  EXPECT_THROW(check_output(folder / "nowhere/a.png"), FileError);
  WriteOptions options;
  options.view.view = View::ocio;
  options.view.ocio_config = folder / "missing.ocio";
  check_output(folder / "a.exr", options);
  EXPECT_THROW(check_output(folder / "a.png", options), ImageError);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(ImageIo, FilesThatAreNoPicturesAreErrorsInOneLine) {
  const TemporaryFolder folder;
  EXPECT_EQ(message_of<ImageError>([&] { read_image(folder / "none.exr"); }),
            (folder / "none.exr") + ": no such file");
  EXPECT_EQ(message_of<ImageError>([&] { read_image(folder.path().string()); }),
            folder.path().string() + ": is not a plain file");
  std::ofstream(folder / "text.exr") << "not a picture";
  std::ofstream(folder / "empty.png");
  for (const char* name : {"text.exr", "empty.png"}) {
    const std::string message = message_of<ImageError>([&] { read_image(folder / name); });
    EXPECT_NE(message.find(std::string(name) + ": is not a readable picture"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(ImageIo, TruncatedAndFlippedFilesAreErrorsOrPicturesNeverCrashes) {
#ifdef __SANITIZE_ADDRESS__
  // OpenImageIO 2.4 loses 31 bytes of a message when libpng jumps out of it at the end of a truncated file.
  const __lsan::ScopedDisabler not_our_leak;
#endif
  const TemporaryFolder folder;
  Image image = make_image(64, 64);
  for (Channel& channel : image.channels)
    for (std::size_t i = 0; i < channel.values.size(); ++i)
      channel.values[i] = float((i * 2654435761u) % 1000u);
  for (const char* name : {"a.exr", "a.png"}) {
    write_image(folder / name, image);
    const std::string whole = bytes_of(folder / name);
    int refused = 0;
    for (int mutant = 0; mutant < 60; ++mutant) {
      std::string bytes = whole;
      if (mutant < 30)
        bytes.resize(whole.size() * std::size_t(mutant) / 30);
      else
        bytes[(std::size_t(mutant) * 7919u * 31u) % (mutant % 2 ? 400 : whole.size())] ^=
            char(1 << (mutant % 8));
      std::ofstream(folder / (std::string("m_") + name), std::ios::binary) << bytes;
      try {
        const Image read = read_image(folder / (std::string("m_") + name));
        EXPECT_LE(read.pixel_count(), std::size_t(1) << 28);
      } catch (const ImageError&) {
        ++refused;
      }
    }
    EXPECT_GE(refused, 15) << name << ": files cut in half must be noticed";
  }
}

}  // namespace
}  // namespace plinian
