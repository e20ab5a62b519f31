// Evaluates something smooth over a block of voxels at every second or fourth voxel alone, where its waves
// are long enough, and interpolates. Blocks share the lattice points of their faces, so no seam shows.
#pragma once

#include "core/shared/glue.h"

namespace plinian::procedural {

/// f: of a position [object]; wavelength: [object] its shortest. corner: [object] centre of the block's first
/// voxel; voxel: [object]. Calls use(i, value) for every voxel i of the 8^3, x fastest.
template <class F, class Use>
void for_each_interpolated(vec3 corner, float voxel, float wavelength, F f, Use use) {
  using Value = decltype(f(corner));
  const int step = voxel * 10.0f < wavelength ? 4 : voxel * 5.0f < wavelength ? 2 : 1;
  if (step == 1) {
    for (int i = 0; i < 512; ++i) use(i, f(corner + voxel * vec3(i & 7, (i >> 3) & 7, i >> 6)));
    return;
  }
  const int side = 8 / step + 1;
  Value lattice[5 * 5 * 5];
  for (int z = 0, i = 0; z < side; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x, ++i)
        lattice[i] = f(corner + (voxel * static_cast<float>(step)) * vec3(x, y, z));
  const int dy = side, dz = side * side;
  for (int i = 0; i < 512; ++i) {
    const ivec3 v(i & 7, (i >> 3) & 7, i >> 6);
    const ivec3 cell = v / step;
    const vec3 t = vec3(v - cell * step) / static_cast<float>(step);
    const Value* c = lattice + cell.z * dz + cell.y * dy + cell.x;
    const auto row = [&](int at) { return c[at] + t.x * (c[at + 1] - c[at]); };
    const Value near = row(0) + t.y * (row(dy) - row(0));
    const Value far = row(dz) + t.y * (row(dz + dy) - row(dz));
    use(i, near + t.z * (far - near));
  }
}

}  // namespace plinian::procedural
