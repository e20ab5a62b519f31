// A number by which pictures of the same scene know each other.
#pragma once

#include <cstdint>
#include <string>

#include "core/scene/snapshot.h"

namespace plinian {

/// Hash of everything that a snapshot shows: camera, media with every voxel, lights, sky, size. Names of
/// media and the quality are left out: a fast picture and its reference have the same hash. The same on every
/// machine and in every run.
std::uint64_t scene_hash(const SceneSnapshot& scene);

/// Hash of a volume's voxels, their temperature and where they are.
std::uint64_t volume_hash(const BrickVolume& volume);

/// As 16 hexadecimal digits.
std::string scene_hash_text(const SceneSnapshot& scene);

}  // namespace plinian
