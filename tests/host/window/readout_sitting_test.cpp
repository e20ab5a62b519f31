// Two pictures read out under one pointer, by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "core/image/image_io.h"
#include "tests/host/cli/program.h"
#include "tests/host/window/steps.h"

namespace plinian {
namespace {

constexpr const char* ball_scene = R"({"volume": "sphere", "density_scale": 3.0, "size": [200, 150],
  "albedo": [0.9, 0.6, 0.3],
  "camera": {"eye": [0, 0, 4], "target": [0, 0, 0], "fov_y_degrees": 40},
  "lights": [{"type": "directional", "toward": [0.3, 0.5, 1], "irradiance": [9, 9, 9]}]})";

// "pixel X Y R G B a A ... | NAME R G B ... matched by +E EV | difference R G B ..."
struct Read {
  ivec2 pixel{0};
  vec3 picture{0.0f}, other{0.0f}, difference{0.0f};
  std::optional<float> stops;  // none: it is not matched
};

Read read_in(const std::string& line, const std::string& name) {
  const auto words_after = [&](const std::string& word) {
    const std::size_t at = line.find(word);
    if (at == line.npos) throw std::runtime_error("no '" + word + "' in " + line);
    return std::istringstream(line.substr(at + word.size()));
  };
  Read read;
  std::istringstream words = words_after(" pixel ");
  words >> read.pixel.x >> read.pixel.y >> read.picture.x >> read.picture.y >> read.picture.z;
  words = words_after(name);
  words >> read.other.x >> read.other.y >> read.other.z;
  words = words_after("difference");
  words >> read.difference.x >> read.difference.y >> read.difference.z;
  if (line.find(" matched by ") != line.npos) words_after(" matched by ") >> read.stops.emplace();
  return read;
}

vec3 pixel_of(const Image& image, ivec2 at) {
  const std::size_t i = std::size_t(at.y) * std::size_t(image.width) + std::size_t(at.x);
  return {image.find("R")->values[i], image.find("G")->values[i], image.find("B")->values[i]};
}

// What is read of either half is what files have there, the reference's as it was matched, where it was.
TEST(ReadoutSitting, BothPicturesAreReadWhicheverIsPointedAt) {
  if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  TemporaryFolder files;
  const std::string scene = files.write("ball.json", ball_scene);
  const auto render = [&](const std::string& to, const std::vector<std::string>& more) {
    std::vector<std::string> words = {"render", scene, "-o", files / to, "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = plinian_program(words);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return read_image(files / to);
  };
  const Image picture = render("picture.exr", {}),
              reference = render("ref.exr", {"--set", "medium.albedo=0.5,0.3,0.1"});

  Sitting sitting({scene}, {1000, 700});
  wait_for_rest(sitting, 0);
  std::size_t since = sitting.now();
  command(sitting, "loadReference " + (files / "ref.exr"));
  sitting.wait_for(
      [](const std::string& line) { return line.find(" rest ") != line.npos && psnr_in(line) > 0.0; }, since);
  const ivec4 whole = sitting.item("picture");
  leave_fields(sitting, {whole.x + 3, whole.y + whole.w - 3});
  since = sitting.now();
  sitting.stroke("Shift_L+s");
  sitting.wait_for("item \"other picture\"", since);
  const auto read_at = [&](const char* half, vec2 share) {
    const ivec4 place = sitting.item(half);
    const std::size_t before = sitting.now();
    sitting.move({place.x + int(share.x * float(place.z)), place.y + int(share.y * float(place.w))});
    return read_in(sitting.line(sitting.wait_for(" pixel ", before)), "ref.exr");
  };
  const auto check = [&](const Read& read, const char* half) {
    SCOPED_TRACE(half);
    const vec3 truth = pixel_of(picture, read.pixel), other = pixel_of(reference, read.pixel);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(read.picture[c], truth[c], 1e-4f) << c;
      EXPECT_GT(read.picture[c], 0.01f) << "the ball is pointed at";
      EXPECT_NEAR(read.other[c], other[c] * std::exp2(read.stops.value_or(0.0f)),
                  0.01f * read.other[c] + 2e-4f)
          << c;
      EXPECT_NEAR(read.difference[c], read.picture[c] - read.other[c], 2e-4f) << c;
    }
  };
  const Read as_it_came = read_at("other picture", {0.5f, 0.4f});
  EXPECT_FALSE(as_it_came.stops) << "it is scene-linear, and a light may be what is looked for";
  check(as_it_came, "as it came");
  sitting.keep("readout-0-as-it-came.png");
  sitting.stroke("Control_L+Shift_L+p");
  sitting.type("match exposure");
  since = sitting.now();
  sitting.stroke("Return");
  sitting.wait_for(" still", sitting.wait_for("psnr", since));
  const Read right = read_at("other picture", {0.55f, 0.45f});
  EXPECT_NEAR(right.pixel.x, 0.55f * 200.0f, 1.5f);
  EXPECT_NEAR(right.pixel.y, 0.45f * 150.0f, 1.5f);
  check(right, "right");
  EXPECT_GT(right.stops.value_or(0.0f), 0.1f);
  const Read left = read_at("picture", {0.42f, 0.6f});
  EXPECT_NEAR(left.pixel.x, 0.42f * 200.0f, 1.5f);
  check(left, "left");
  EXPECT_EQ(left.stops, right.stops);
  sitting.wait_for(" still", sitting.now() - 1);
  sitting.keep("readout-1-side-by-side.png");
  // Close up it is still the pixel under the pointer, in either half.
  const ivec4 place = sitting.item("other picture");
  const ivec2 at(place.x + place.z / 2, place.y + place.w / 2);
  sitting.move(at);
  sitting.wait_for_mouse(at, 0);
  since = sitting.now();
  sitting.key_down("z");
  for (int i = 0; i < 8; ++i) {
    sitting.press(4);
    sitting.release(4);
  }
  sitting.wait_for(" zoom 16x", since);
  sitting.key_up("z");
  since = sitting.now();
  sitting.move(at + ivec2(26, -18));
  const Read close = read_in(sitting.line(sitting.wait_for(" pixel ", since)), "ref.exr");
  const ivec4 large = sitting.item("other picture");
  EXPECT_EQ(close.pixel.x, int(200.0f * (float(at.x + 26 - large.x) + 0.25f) / float(large.z)));
  EXPECT_EQ(close.pixel.y, int(150.0f * (float(at.y - 18 - large.y) + 0.25f) / float(large.w)));
  check(close, "close up");
  sitting.wait_for(" still", since);
  sitting.keep("readout-2-close-up.png");
  since = sitting.now();
  sitting.stroke("Shift_L+w");
  sitting.wait_for(" still", sitting.wait_for("wipe line", since));
  sitting.keep("readout-3-wipe.png");
}

}  // namespace
}  // namespace plinian
