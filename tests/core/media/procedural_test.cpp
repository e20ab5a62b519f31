#include "core/media/procedural.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/media/procedural/kinds.h"

namespace plinian {
namespace {

/// FNV-1a over everything that a volume stores.
std::uint64_t fingerprint(const BrickVolume& volume) {
  std::uint64_t hash = 1469598103934665603ull;
  const auto add = [&hash](const auto& values) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    for (std::size_t i = 0; i < values.size() * sizeof(values[0]); ++i)
      hash = (hash ^ bytes[i]) * 1099511628211ull;
  };
  add(volume.root);
  add(volume.nodes);
  add(volume.density);
  add(volume.temperature);
  return hash;
}

/// Every voxel of the cube, x fastest.
std::vector<float> dense(const BrickVolume& volume, int n) {
  std::vector<float> voxels(std::size_t(n) * n * n);
  for (int z = 0, i = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x, ++i) voxels[std::size_t(i)] = volume.voxel_density({x, y, z});
  return voxels;
}

std::string error_of(const ProceduralSettings& settings) {
  try {
    make_procedural(settings);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

class EveryKind : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Procedural, EveryKind, testing::ValuesIn(procedural_kinds()),
                         [](const auto& info) { return info.param; });

TEST_P(EveryKind, HasTheSameBytesOnEveryRunAndThreadCount) {
  const ProceduralSettings settings{GetParam(), 64};
  const std::uint64_t first = fingerprint(*make_procedural(settings));
  EXPECT_EQ(fingerprint(*make_procedural(settings)), first);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(fingerprint(*make_procedural(settings)), first);
}

TEST_P(EveryKind, DiffersFromSeedToSeedButNotInSize) {
  const auto one = make_procedural({GetParam(), 64, 1}), two = make_procedural({GetParam(), 64, 2});
  EXPECT_NE(fingerprint(*one), fingerprint(*two));
  EXPECT_NEAR(double(two->active_voxels) / double(one->active_voxels), 1.0, 0.35);
}

TEST_P(EveryKind, LooksTheSameAtEveryResolution) {
  const int n = 64;
  const std::vector<float> coarse = dense(*make_procedural({GetParam(), n}), n);
  const std::vector<float> fine = dense(*make_procedural({GetParam(), 2 * n}), 2 * n);
  double sum_a = 0, sum_b = 0, aa = 0, bb = 0, ab = 0;
  for (int z = 0, i = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x, ++i) {
        double b = 0.0;
        for (int c = 0; c < 8; ++c)
          b += 0.125 * fine[(std::size_t(2 * z + (c >> 2)) * 2 * n + 2 * y + ((c >> 1) & 1)) * 2 * n + 2 * x +
                            (c & 1)];
        const double a = coarse[std::size_t(i)];
        sum_a += a, sum_b += b, aa += a * a, bb += b * b, ab += a * b;
      }
  EXPECT_NEAR(sum_a / sum_b, 1.0, 0.05);
  EXPECT_GT(ab / std::sqrt(aa * bb), 0.97) << sum_a / sum_b;
}

TEST_P(EveryKind, StandsOnTheGroundInsideTheCubeWithCubicVoxels) {
  const int n = 128;
  const auto volume = make_procedural({GetParam(), n});
  // Nothing is cut off at a face but the ground: the outermost voxels are empty.
  EXPECT_GE(volume->bounds_min.x, 0);
  EXPECT_GE(volume->bounds_min.z, 0);
  EXPECT_LE(volume->bounds_max.x, n - 1);
  EXPECT_LE(volume->bounds_max.y, n - 1);
  EXPECT_LE(volume->bounds_max.z, n - 1);
  EXPECT_LE(volume->bounds_min.y, n / 16);
  const dmat4 m = volume->medium_from_index;
  EXPECT_DOUBLE_EQ(m[0][0], 10.0 / n);
  EXPECT_DOUBLE_EQ(m[1][1], 10.0 / n);
  EXPECT_DOUBLE_EQ(m[2][2], 10.0 / n);
  const dvec4 middle = m * dvec4(0.5 * n - 0.5, -0.5, 0.5 * n - 0.5, 1.0);
  EXPECT_NEAR(middle.x, 0.0, 1e-12);
  EXPECT_NEAR(middle.y, 0.0, 1e-12);
  EXPECT_NEAR(middle.z, 0.0, 1e-12);
}

TEST_P(EveryKind, FillsALargePartOfTheCube) {
  const auto volume = make_procedural({GetParam(), 64});
  const ivec3 size = volume->bounds_max - volume->bounds_min;
  EXPECT_GT(std::max({size.x, size.y, size.z}), 52);
  EXPECT_GT(volume->active_voxels, 64 * 64 * 64 / 30);
  EXPECT_LE(volume->density_max, 1.0f);
  EXPECT_GT(volume->density_max, 0.8f);
}

TEST_P(EveryKind, HasTemperatureExactlyWhereItsLookEmits) {
  const auto volume = make_procedural({GetParam(), 64});
  const bool emits = procedural_look(GetParam()).emission.scale > 0.0f;
  EXPECT_EQ(volume->hot_brick_count() > 0, emits);
  EXPECT_EQ(emits, GetParam() == "ash" || GetParam() == "explosion");
  if (emits) {
    EXPECT_GT(volume->temperature_max, 1000.0f);
    EXPECT_LT(volume->temperature_max, 2500.0f);
  }
}

TEST_P(EveryKind, ChangesWithEachOfItsParameters) {
  const std::uint64_t usual = fingerprint(*make_procedural({GetParam(), 48}));
  for (const ProceduralParameter& parameter : procedural_parameters(GetParam())) {
    SCOPED_TRACE(parameter.name);
    EXPECT_GE(parameter.default_value, parameter.low);
    EXPECT_LE(parameter.default_value, parameter.high);
    EXPECT_FALSE(parameter.help.empty());
    for (const float value : {parameter.low, parameter.high}) {
      const auto volume = make_procedural({GetParam(), 48, 1, {{parameter.name, value}}});
      EXPECT_FALSE(volume->empty());
      EXPECT_NE(fingerprint(*volume), usual);
      EXPECT_LE(volume->bounds_max.x, 48) << value;
    }
    EXPECT_EQ(fingerprint(*make_procedural({GetParam(), 48, 1, {{parameter.name, parameter.default_value}}})),
              usual);
  }
}

TEST_P(EveryKind, HasALookWhoseCoefficientsAddUpToOne) {
  const ProceduralLook look = procedural_look(GetParam());
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(look.sigma_s[c] + look.sigma_a[c], 1.0f, 1e-6f);
    EXPECT_GE(look.sigma_a[c], 0.0f);
  }
  const Medium medium = procedural_medium({GetParam(), 32});
  EXPECT_EQ(medium.name, GetParam());
  EXPECT_EQ(medium.density_scale, look.density_scale);
  EXPECT_EQ(medium.sigma_s, look.sigma_s);
  EXPECT_FALSE(medium.volume->empty());
}

// Optical depths of the default look along parallel rays through index space, one per pixel of a grid, that
// meet any density.
std::vector<double> optical_depths(const Medium& medium, dvec3 toward, int rays) {
  const BrickVolume& volume = *medium.volume;
  const double voxel = volume.medium_from_index[0][0];
  const dvec3 side = glm::normalize(glm::cross(toward, dvec3(0, 1, 0))), up = glm::cross(side, toward);
  const dvec3 centre = 0.5 * dvec3(volume.bounds_min + volume.bounds_max);
  const double radius = 0.5 * glm::length(dvec3(volume.bounds_max - volume.bounds_min));
  std::vector<double> depths;
  for (int j = 0; j < rays; ++j)
    for (int i = 0; i < rays; ++i) {
      const dvec3 start = centre + radius * (toward + ((2.0 * i + 1.0) / rays - 1.0) * side +
                                             ((2.0 * j + 1.0) / rays - 1.0) * up);
      double sum = 0.0;
      for (double t = 0.0; t < 2.0 * radius; t += 1.0) sum += volume.sample_density(vec3(start - t * toward));
      if (sum > 0.0) depths.push_back(sum * voxel * medium.density_scale);
    }
  return depths;
}

TEST(Ash, IsReallyDense) {
  const Medium ash = procedural_medium({"ash", 256});
  const BrickVolume& volume = *ash.volume;
  // Half of the light rays that meet anything at all, veils included, cross an optical depth over 100.
  for (const dvec3 toward :
       {dvec3(0.63, 0.67, 0.39), dvec3(1, 0, 0), dvec3(0, 0.1, 1), dvec3(-0.6, 0.5, -0.6)}) {
    std::vector<double> depths = optical_depths(ash, glm::normalize(toward), 96);
    ASSERT_GT(depths.size(), 500u);
    std::ranges::nth_element(depths, depths.begin() + std::ptrdiff_t(depths.size() / 2));
    EXPECT_GT(depths[depths.size() / 2], 100.0) << toward.x << " " << toward.y << " " << toward.z;
  }
  // And what is not edge or veil has at least 0.7 in every voxel.
  const float per_voxel = float(volume.medium_from_index[0][0]) * ash.density_scale;
  std::int64_t core = 0, edge = 0, veil = 0;
  for (int z = 0; z < 256; ++z)
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x) {
        const float density = volume.voxel_density({x, y, z});
        if (density <= 0.0f) continue;
        (density * per_voxel >= 0.7f ? core : density < 0.06f ? veil : edge)++;
      }
  EXPECT_GT(core, 8 * edge);
  EXPECT_GT(veil, volume.active_voxels / 200);
}

TEST(Ash, ReadsAsCauliflower) {
  // A smooth column of these proportions has about 1.3 times the surface of a ball of its volume.
  const int n = 128;
  const std::vector<float> voxels = dense(*make_procedural({"ash", n}), n);
  double volume = 0.0, surface = 0.0;
  for (int z = 1; z < n; ++z)
    for (int y = 1; y < n; ++y)
      for (int x = 1; x < n; ++x) {
        const auto at = [&](int dx, int dy, int dz) {
          return voxels[(std::size_t(z - dz) * n + y - dy) * n + x - dx];
        };
        const float here = at(0, 0, 0);
        volume += here;
        const vec3 gradient(here - at(1, 0, 0), here - at(0, 1, 0), here - at(0, 0, 1));
        surface += glm::length(gradient);
      }
  const double ball = std::cbrt(36.0 * 3.14159265358979) * std::pow(volume, 2.0 / 3.0);
  EXPECT_GT(surface / ball, 2.0);
}

TEST(Ash, GlowsInTheLowerPartOnly) {
  const auto volume = make_procedural({"ash", 128});
  float low = 0.0f, high = 0.0f;
  for (int z = 0; z < 128; z += 2)
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; x += 2) {
        const float kelvin = volume->sample_temperature(vec3(x, y, z));
        (y < 40 ? low : high) = std::max(y < 40 ? low : high, kelvin);
      }
  EXPECT_GT(low, 1200.0f);
  EXPECT_LT(high, 900.0f);
  EXPECT_LT(volume->hot_brick_count(), volume->brick_count() / 8);
}

TEST(Ash, TakesMemoryByItsSurfaceAndVolumeNotByTheCube) {
  const auto volume = make_procedural({"ash", 128});
  EXPECT_LT(volume->leaf_count, 16 * 16 * 16 / 3);
  // On the GPU the atlas adds what its edge wastes; all of it together may take 1.8.
  EXPECT_LT(double(volume->bytes()), 1.72 * 512 * 2 * double(volume->leaf_count));
}

TEST(Voxelise, LooksAtFewBlocksThatTurnOutEmptyAndAtFewLobesForEach) {
  procedural::ShapeSettings settings;
  settings.resolution = 128;
  const auto shape = procedural::make_ash(settings);
  BrickVolumeBuilder builder;
  const procedural::VoxeliseStats stats = procedural::voxelise(*shape, settings.resolution, builder);
  const BrickVolume volume = builder.build(dmat4(1.0));
  EXPECT_FALSE(stats.cancelled);
  EXPECT_LT(double(stats.shaded_blocks), 1.8 * double(volume.leaf_count));
  const double lobes = double(shape->family().lobes.size());
  EXPECT_LT(double(stats.lobe_visits), 0.05 * lobes * double(stats.shaded_blocks));
}

TEST(Lobes, StayWhereTheyAreWhenFinerOnesAreAdded) {
  using namespace procedural;
  const auto family = [](float least) {
    LobeFamily grown = found_family({{{0.5f, 0.5f, 0.5f}, 0.2f}, {{0.6f, 0.3f, 0.5f}, 0.15f}});
    for (std::uint32_t g = 0; g < 3; ++g) grow(grown, {}, g, least);
    return grown.lobes;
  };
  const std::vector<Lobe> coarse = family(0.02f), fine = family(0.008f);
  EXPECT_GT(coarse.size(), 50u);
  EXPECT_GT(fine.size(), 2 * coarse.size());
  std::size_t found = 0;
  for (const Lobe& lobe : coarse)
    found += std::ranges::any_of(
        fine, [&](const Lobe& o) { return o.centre == lobe.centre && o.radius == lobe.radius; });
  EXPECT_EQ(found, coarse.size());
}

TEST(Lobes, KeepTheirDistanceFromEachOther) {
  using namespace procedural;
  LobeFamily family = found_family({{{0.5f, 0.5f, 0.5f}, 0.2f}});
  const Growth growth;
  grow(family, growth, 3, 0.0f);
  EXPECT_GT(family.lobes.size(), 10u);
  for (std::size_t i = 1; i < family.lobes.size(); ++i)
    for (std::size_t j = 1; j < i; ++j) {
      const Lobe &a = family.lobes[i], &b = family.lobes[j];
      EXPECT_GE(glm::length(a.centre - b.centre), 0.999f * growth.spacing * (a.radius + b.radius));
    }
}

TEST(Procedural, RefusesWhatItDoesNotKnowInOneClearLine) {
  EXPECT_EQ(error_of({"fog"}), "fog: no such procedural medium; there are: ash, cloud, sandstorm, explosion");
  EXPECT_EQ(error_of({"ash", 4}), "ash: resolution 4 is not in [16, 1024]");
  EXPECT_EQ(error_of({"ash", 4096}), "ash: resolution 4096 is not in [16, 1024]");
  EXPECT_EQ(error_of({"cloud", 64, 1, {{"heat", 1.0f}}}),
            "cloud: no parameter 'heat'; there are: billow_size, displacement, sharpness, spread, veils");
  EXPECT_EQ(error_of({"ash", 64, 1, {{"veils", -1.0f}}}), "ash: veils -1 is not in [0, 4]");
  EXPECT_EQ(error_of({"ash", 64, 1, {{"veils", std::numeric_limits<float>::quiet_NaN()}}}),
            "ash: veils nan is not in [0, 4]");
  EXPECT_THROW(procedural_look("fog"), std::runtime_error);
  EXPECT_THROW(procedural_parameters("fog"), std::runtime_error);
}

TEST(Procedural, TellsItsProgressAndStopsWhenAsked) {
  double last = 0.0;
  int calls = 0;
  make_procedural({"ash", 64}, [&](double share) {
    EXPECT_GE(share, last);
    last = share;
    ++calls;
    return true;
  });
  EXPECT_DOUBLE_EQ(last, 1.0);
  EXPECT_GT(calls, 10);
  EXPECT_THROW(make_procedural({"ash", 64}, [](double share) { return share < 0.3; }), ProceduralCancelled);
}

TEST(Procedural, WorksAtResolutionsThatAreNoMultipleOfABrick) {
  const auto volume = make_procedural({"cloud", 45});
  EXPECT_FALSE(volume->empty());
  EXPECT_LE(volume->bounds_max.x, 45);
  const auto even = make_procedural({"cloud", 48});
  EXPECT_NEAR(
      double(volume->active_voxels) / (45.0 * 45 * 45) / (double(even->active_voxels) / (48.0 * 48 * 48)),
      1.0, 0.05);
}

}  // namespace
}  // namespace plinian
