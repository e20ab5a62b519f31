// Volumes: read from inputs, made of a plug-in's own voxels, handed on.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "host/sdk/abi.h"

namespace plinian {
namespace PLINIAN_HIDDEN sdk {

using Voxel = std::array<std::int32_t, 3>;  // an index along x, y and z
using Matrix = std::array<double, 16>;      // column by column
inline constexpr Matrix identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/// A volume of the host's; good until the function returns that was given it.
struct Volume {
  const PlinianVolume* handle = nullptr;
  explicit operator bool() const { return handle != nullptr; }
};

struct VolumeInfo {
  Voxel first{}, count{};  // box of the voxels that hold any density
  Matrix object_from_index = identity;
  float density_max = 0.0f, temperature_max = 0.0f;  // [unit of the source], [K]
  std::int64_t voxels = 0;                           // with any density
};

/// A volume to be made.
struct VolumeSource {
  Voxel first{}, count{};  // box of voxels; outside it there is nothing
  Matrix object_from_index = identity;
  /// Fills the 8^3 voxels, x fastest, from `first` on, a multiple of 8: density >= 0 and, where the volume
  /// has temperatures (else null), kelvins. Both are zero beforehand. Returns false for an empty block.
  std::function<bool(const Voxel& first, float* density, float* temperature)> fill{};
  bool temperatures = false, concurrent = false;  // concurrent: fill may run on several threads at a time
  std::uint64_t content = 0;                      // equal for equal content; 0: not known

  /// Of values that are there already: of a box, x fastest. temperatures: empty for none.
  static VolumeSource dense(const Voxel& first, const Voxel& count, const Matrix& object_from_index,
                            std::vector<float> densities, std::vector<float> temperatures = {}) {
    VolumeSource source;
    source.first = first;
    source.count = count;
    source.object_from_index = object_from_index;
    source.temperatures = !temperatures.empty();
    source.concurrent = true;
    source.fill = [=, densities = std::move(densities), temperatures = std::move(temperatures)](
                      const Voxel& block, float* density, float* temperature) {
      bool any = false;
      for (std::int32_t z = 0; z < 8; ++z)
        for (std::int32_t y = 0; y < 8; ++y)
          for (std::int32_t x = 0; x < 8; ++x) {
            const std::int32_t i = block[0] + x - first[0], j = block[1] + y - first[1],
                               k = block[2] + z - first[2];
            if (i < 0 || j < 0 || k < 0 || i >= count[0] || j >= count[1] || k >= count[2]) continue;
            const auto from =
                (std::size_t(k) * std::size_t(count[1]) + std::size_t(j)) * std::size_t(count[0]) +
                std::size_t(i);
            const auto to = std::size_t(z * 64 + y * 8 + x);
            density[to] = densities.at(from);
            if (temperature) temperature[to] = temperatures.at(from);
            any = any || density[to] != 0.0f;
          }
      return any;
    };
    return source;
  }
};

/// A matrix that scales by `size` and moves the voxel 0 to `origin`.
inline Matrix scaled(double size, double x = 0.0, double y = 0.0, double z = 0.0) {
  return {size, 0, 0, 0, 0, size, 0, 0, 0, 0, size, 0, x, y, z, 1};
}

}  // namespace sdk
}  // namespace plinian
