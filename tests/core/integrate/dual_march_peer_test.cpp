// The offline reference against Blender Cycles, a path tracer that is told to stop after one scattering
// event: the same quantity, computed by other people in another way. Runs where `blender` and ../shared are,
// skips elsewhere.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

#include "core/image/image_io.h"
#include "core/image/metrics.h"
#include "core/integrate/dual_march.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_loader.h"

namespace plinian {
namespace {

namespace fs = std::filesystem;

const fs::path peers = fs::path(PLINIAN_SOURCE_DIR) / ".." / "shared" / "peers";

/// A folder that is gone afterwards.
struct ScratchFolder {
  fs::path path;
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "plinian-peer-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("cannot make " + name);
    path = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

bool blender_is_installed() {
  return std::system("command -v blender > /dev/null 2>&1") == 0;
}

/// Single scattering by Cycles, in linear radiance. Blender may die without an exit code: the picture
/// decides.
Image render_with_cycles(const fs::path& scene, const fs::path& folder) {
  const fs::path picture = folder / "cycles.exr";
  const std::string command = "blender -b --python '" + (peers / "cycles.py").string() + "' -- '" +
                              scene.string() + "' '" + picture.string() +
                              "' --engine CYCLES --samples 256 --bounces 0 > '" +
                              (folder / "cycles.log").string() + "' 2>&1 < /dev/null";
  const int status = std::system(command.c_str());
  if (!fs::exists(picture))
    throw std::runtime_error("blender wrote no picture (status " + std::to_string(status) + "): " + command);
  return read_image(picture.string());
}

struct Agreement {
  double mean_ratio;  // [-] ours over theirs
  double psnr;        // [dB] after averaging 8 x 8 pixels, peak 1
  double mirrored;    // [dB] likewise, of our picture seen in a mirror
};

Image mirrored(const Image& image) {
  Image result = image;
  for (Channel& channel : result.channels)
    for (int y = 0; y < image.height; ++y)
      std::reverse(channel.values.begin() + std::ptrdiff_t(y) * image.width,
                   channel.values.begin() + std::ptrdiff_t(y + 1) * image.width);
  return result;
}

Agreement compare(const Frame& frame, const Image& theirs) {
  const Image ours = frame_to_image(frame);
  const auto psnr = [&](const Image& image) {
    return psnr_of(pixel_metrics(pair_pictures(box_downsample(image, 8), box_downsample(theirs, 8))).mse,
                   1.0);
  };
  return {pixel_metrics(pair_pictures(ours, theirs)).mean_ratio.value(), psnr(ours), psnr(mirrored(ours))};
}

void expect_agreement(const std::string& name) {
  const fs::path scene = peers / "scenes" / (name + ".json");
  if (!fs::exists(scene)) GTEST_SKIP() << "no " << scene;
  if (!blender_is_installed()) GTEST_SKIP() << "blender is not installed (tools/packages-peers.txt)";
  const ScratchFolder scratch;
  const Image cycles = render_with_cycles(scene, scratch.path);

  SceneSnapshot snapshot = load_scene(read_scene_file(scene.string())).snapshot;
  ASSERT_EQ(snapshot.media.size(), 1u);
  const Agreement as_is = compare(DualMarch().render(snapshot), cycles);
  EXPECT_NEAR(as_is.mean_ratio, 1.0, 0.01);
  EXPECT_GE(as_is.psnr, 40.0);
  EXPECT_LT(as_is.mirrored, 30.0);

  // What is left is where voxels stand. OpenVDB's voxels have their centres at whole index coordinates;
  // Cycles takes these for their corners and so shows every volume half a voxel further along all three axes.
  // Done as Cycles does it, both programs see the same medium, and agree down to the noise and to Cycles' own
  // ray-marching steps.
  Medium& medium = snapshot.media[0];
  const dmat4 medium_from_index = medium.volume->medium_from_index;
  medium.world_from_medium = medium.world_from_medium * medium_from_index *
                             glm::translate(dmat4(1.0), dvec3(0.5)) * glm::inverse(medium_from_index);
  const Agreement shifted = compare(DualMarch().render(snapshot), cycles);
  EXPECT_NEAR(shifted.mean_ratio, 1.0, 0.005);
  EXPECT_GE(shifted.psnr, 50.0);
  std::printf("%s: mean %.5f, %.2f dB; with voxels where Cycles puts them %.5f, %.2f dB; mirrored %.2f dB\n",
              name.c_str(), as_is.mean_ratio, as_is.psnr, shifted.mean_ratio, shifted.psnr, as_is.mirrored);
}

TEST(DualMarchAgainstCycles, DenseSmokeAgrees) {
  expect_agreement("smoke-dense");
}
TEST(DualMarchAgainstCycles, ThinSmokeAgrees) {
  expect_agreement("smoke-thin");
}

}  // namespace
}  // namespace plinian
