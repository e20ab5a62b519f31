// Writing of .vdb files in the worker. See vdb_worker_write.h.
#include "core/media/vdb_worker_write.h"

#include <openvdb/io/Archive.h>
#include <openvdb/openvdb.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "core/media/vdb_worker_file.h"

namespace plinian::vdb {
namespace {

using openvdb::Coord;
using openvdb::FloatGrid;

/// Archive's own writing, onto a stream that throws when the disk is full; io::File does not look.
class Writer : public openvdb::io::Archive {
 public:
  void write_to(std::ostream& stream, const openvdb::GridCPtrVec& grids, const openvdb::MetaMap& metadata) {
    Archive::write(stream, grids, /*seekable=*/true, metadata);
  }
};

/// Sets an 8^3 block; voxels of value 0 stay inactive.
void set_block(FloatGrid& grid, ivec3 block, const float* values) {
  bool any = false;
  for (int i = 0; i < block_voxels && !any; ++i) any = values[i] != 0.0f;
  if (!any) return;
  auto* leaf = grid.tree().touchLeaf(Coord(block.x * 8, block.y * 8, block.z * 8));
  for (int i = 0; i < block_voxels; ++i) {
    // OpenVDB's leaves run z fastest.
    const auto offset = static_cast<openvdb::Index>(((i & 7) << 6) | (((i >> 3) & 7) << 3) | (i >> 6));
    if (values[i] != 0.0f) leaf->setValueOn(offset, values[i]);
  }
}

FloatGrid::Ptr make_grid(const nlohmann::json& request, const std::string& name) {
  FloatGrid::Ptr grid = FloatGrid::create(0.0f);
  grid->setName(name);
  grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  grid->setSaveFloatAsHalf(request.at("half").get<bool>());
  openvdb::Mat4d matrix;
  for (int i = 0; i < 16; ++i) matrix(i / 4, i % 4) = request.at("medium_from_index").at(i).get<double>();
  grid->setTransform(openvdb::math::Transform::createLinearTransform(matrix));
  return grid;
}

}  // namespace

void write_file(const nlohmann::json& request, Inlet& inlet, const Outlet& outlet) {
  const FloatGrid::Ptr density = make_grid(request, request.at("density_grid").get<std::string>());
  const FloatGrid::Ptr heat = make_grid(request, request.at("temperature_grid").get<std::string>());
  BlockReader reader;
  for (auto payload = inlet.blocks(); !payload.empty(); payload = inlet.blocks())
    reader.read(payload, [&](ivec3 block, const float* values, const float* kelvin) {
      set_block(*density, block, values);
      if (kelvin) set_block(*heat, block, kelvin);
    });
  openvdb::GridCPtrVec grids{density};
  if (!heat->empty()) grids.push_back(heat);
  openvdb::MetaMap metadata;
  for (const auto& [key, value] : request.at("metadata").items())
    metadata.insertMeta(key, openvdb::StringMetadata(value.get<std::string>()));

  std::ofstream stream(path_of(request), std::ios::binary);
  try {
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    Writer().write_to(stream, grids, metadata);
    stream.close();
  } catch (const std::ios_base::failure&) {
    throw BadFile(std::string("it cannot be written: ") + std::strerror(errno));
  }
  outlet.result(
      {{"density_voxels", density->activeVoxelCount()}, {"temperature_voxels", heat->activeVoxelCount()}});
}

}  // namespace plinian::vdb
