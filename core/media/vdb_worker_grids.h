// What the worker says about grids, and which of them a request means.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/media/vdb_worker_file.h"

namespace plinian::vdb {

/// Facts of a grid as VdbGridInfo has them, under the same names. `with_tree`: the tree is loaded, so voxels,
/// bounds and range can be told; else they are taken from the metadata.
nlohmann::json describe(const GridEntry& entry, const openvdb::GridBase& grid, bool with_tree);

/// String metadata, made printable and cut to a sane length.
nlohmann::json describe(const openvdb::MetaMap& metadata);

/// Whether the value type is one that density or temperature can be read from.
bool is_scalar(const GridEntry& entry);

/// Why a transform cannot be used: empty, or "its transform is singular: ...". Frustums pass.
std::string transform_fault(const openvdb::math::Transform& transform);

/// The grids that `wanted` names: "name", "name[2]" or "name[*]" (all of that name). Throws BadFile with the
/// grids that there are, or the indices of an ambiguous name.
std::vector<GridEntry> pick(const VdbFile& file, const std::string& wanted);

/// The grid that is density when none is named: "density", else the only one that could be. note: what to say
/// about the choice. Throws BadFile with the grids that there are.
std::vector<GridEntry> pick_density(VdbFile& file, bool level_sets_too, std::string& note);

/// temperature, heat or flame, other than the grids of density; empty where there is none.
std::vector<GridEntry> pick_temperature(const VdbFile& file, const std::vector<GridEntry>& density);

/// Values as floats, the tree shared where they are floats already; the grid gives its tree up.
openvdb::FloatGrid::Ptr as_floats(const openvdb::GridBase::Ptr& grid);

/// "density (float), Cd (vec3s)": all grids of the file, cut where they are many.
std::string listing(const VdbFile& file);

}  // namespace plinian::vdb
