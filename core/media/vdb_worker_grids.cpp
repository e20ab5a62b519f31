// Facts and choice of grids. See vdb_worker_grids.h.
#include "core/media/vdb_worker_grids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace plinian::vdb {
namespace {

using Json = nlohmann::json;

/// Text of a file, fit for a terminal: no control characters, no endless lines.
std::string printable(std::string text) {
  constexpr std::size_t longest = 1000;
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::string class_name(openvdb::GridClass grid_class) {
  switch (grid_class) {
    case openvdb::GRID_LEVEL_SET:
      return "level set";
    case openvdb::GRID_FOG_VOLUME:
      return "fog volume";
    case openvdb::GRID_STAGGERED:
      return "staggered";
    default:
      return "unknown";
  }
}

/// Finite range of the active values, tiles included.
template <class Grid>
std::optional<std::array<double, 2>> range_of(const Grid& grid) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto widen = [&](double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  };
  auto tile = grid.tree().cbeginValueOn();
  tile.setMaxDepth(tile.getLeafDepth() - 1);
  for (; tile; ++tile) widen(static_cast<double>(tile.getValue()));
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf)
    for (auto value = leaf->cbeginValueOn(); value; ++value) widen(static_cast<double>(value.getValue()));
  if (low > high) return std::nullopt;
  return std::array{low, high};
}

/// Calls f with the grid as what it is, where it is a scalar one; returns whether it was.
template <class F>
bool with_scalar(const openvdb::GridBase& grid, F&& f) {
  using Scalars = openvdb::TypeList<openvdb::FloatGrid, openvdb::DoubleGrid, openvdb::Int32Grid,
                                    openvdb::Int64Grid, openvdb::BoolGrid>;
  return grid.apply<Scalars>(f);
}

bool is_level_set(const openvdb::GridBase& grid) {
  return grid.getGridClass() == openvdb::GRID_LEVEL_SET;
}

constexpr std::array temperature_names = {"temperature", "heat", "flame"};

bool is_temperature_name(const std::string& name) {
  return std::find(temperature_names.begin(), temperature_names.end(), name) != temperature_names.end();
}

std::vector<GridEntry> named(const VdbFile& file, const std::string& name) {
  std::vector<GridEntry> found;
  std::copy_if(file.entries().begin(), file.entries().end(), std::back_inserter(found),
               [&](const GridEntry& e) { return e.name == name; });
  return found;
}

}  // namespace

bool is_scalar(const GridEntry& entry) {
  constexpr std::array scalars = {"float", "half", "double", "int32", "int64", "bool"};
  return std::find(scalars.begin(), scalars.end(), entry.value_type()) != scalars.end();
}

nlohmann::json describe(const openvdb::MetaMap& metadata) {
  Json result = Json::object();
  for (auto item = metadata.beginMeta(); item != metadata.endMeta(); ++item) {
    if (result.size() >= 200) break;
    if (item->second) result[printable(item->first)] = printable(item->second->str());
  }
  return result;
}

nlohmann::json describe(const GridEntry& entry, const openvdb::GridBase& grid, bool with_tree) {
  const openvdb::math::Transform& transform = grid.transform();
  Json info{{"name", printable(entry.label())},
            {"value_type", printable(entry.value_type())},
            {"grid_class", class_name(grid.getGridClass())},
            {"metadata", describe(static_cast<const openvdb::MetaMap&>(grid))}};
  std::string refusal = transform_fault(transform);
  openvdb::Vec3d size(0.0);
  if (!refusal.empty()) {
    info["transform"] = "singular";
  } else if (transform.isLinear()) {
    size = transform.voxelSize();
    const openvdb::Mat4d m = transform.baseMap()->getAffineMap()->getMat4();
    Json matrix = Json::array();  // columns, one after the other
    bool diagonal = true;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        matrix.push_back(m(i, j));
        diagonal = diagonal && (i == j || i == 3 || j == 3 || m(i, j) == 0.0);
      }
    info["medium_from_index"] = matrix;
    const double spread = std::max({size[0], size[1], size[2]}) - std::min({size[0], size[1], size[2]});
    info["transform"] = !diagonal ? "affine" : spread <= 1e-6 * std::abs(size[0]) ? "uniform" : "anisotropic";
  } else {
    size = transform.voxelSize(openvdb::Vec3d(0));
    info["transform"] = "frustum";
  }
  info["voxel_size"] = {number(size[0]), number(size[1]), number(size[2])};

  if (!is_scalar(entry))
    refusal = entry.type.find("ptdata") != std::string::npos
                  ? "it holds points, not voxels of density"
                  : "its voxels are " + entry.value_type() + ", not numbers";
  else if (is_level_set(grid))
    refusal = "it is a level set; --level-set fog converts it";
  else if (!transform.isLinear())
    refusal = "its transform is a frustum; --frustum resample converts it";
  info["refusal"] = refusal;

  openvdb::CoordBBox box;
  std::int64_t active = 0;
  if (with_tree) {
    active = static_cast<std::int64_t>(grid.activeVoxelCount());
    box = grid.evalActiveVoxelBoundingBox();
    info["memory_bytes"] = grid.memUsage();
    with_scalar(grid, [&](const auto& scalar) {
      info["leaves"] = std::uint64_t(scalar.tree().leafCount());
      info["background"] = number(static_cast<double>(scalar.background()));
      if (const auto range = range_of(scalar)) {
        info["minimum"] = (*range)[0];
        info["maximum"] = (*range)[1];
      }
    });
  } else {
    if (const auto count = grid.getMetadata<openvdb::Int64Metadata>("file_voxel_count"))
      active = count->value();
    const auto low = grid.getMetadata<openvdb::Vec3IMetadata>("file_bbox_min"),
               high = grid.getMetadata<openvdb::Vec3IMetadata>("file_bbox_max");
    if (low && high) box = openvdb::CoordBBox(openvdb::Coord(low->value()), openvdb::Coord(high->value()));
    if (const auto bytes = grid.getMetadata<openvdb::Int64Metadata>("file_mem_bytes"))
      info["memory_bytes"] = std::max<std::int64_t>(0, bytes->value());
  }
  info["active_voxels"] = active;
  info["index_min"] = Json::array();
  info["dims"] = Json::array();
  const bool empty = active <= 0 || box.empty();
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t low = box.min()[axis], high = box.max()[axis];
    info["index_min"].push_back(empty ? 0 : low);
    info["dims"].push_back(empty ? 0 : high - low + 1);
  }
  return info;
}

std::string transform_fault(const openvdb::math::Transform& transform) {
  const std::string singular = "its transform is singular: a voxel has no size along an axis, or no end";
  if (!transform.isLinear()) return {};
  openvdb::Mat4d m;
  try {
    m = transform.baseMap()->getAffineMap()->getMat4();
  } catch (const openvdb::ArithmeticError&) {
    return singular;
  }
  double lengths = 1.0;
  for (int i = 0; i < 4; ++i) {
    double squared = 0.0;
    for (int j = 0; j < 3; ++j) {
      if (!std::isfinite(m(i, j))) return "its transform is not finite";
      squared += m(i, j) * m(i, j);
    }
    if (i == 3) {
      if (!(squared < 1e36)) return "its transform lies too far out";
    } else if (!(squared > 1e-36 && squared < 1e36)) {
      return singular;
    } else {
      lengths *= std::sqrt(squared);
    }
  }
  if (!(std::abs(m.det()) > 1e-7 * lengths)) return "its transform is singular: it flattens space";
  return {};
}

std::string listing(const VdbFile& file) {
  constexpr std::size_t most = 20;
  std::string text;
  for (std::size_t i = 0; i < file.entries().size() && i < most; ++i)
    text += (i ? ", " : "") + printable(file.entries()[i].label()) + " (" +
            printable(file.entries()[i].value_type()) + ")";
  if (file.entries().size() > most) text += " and " + std::to_string(file.entries().size() - most) + " more";
  return text;
}

std::vector<GridEntry> pick(const VdbFile& file, const std::string& wanted) {
  // A grid may really be called "density[1]".
  if (auto exact = named(file, wanted); exact.size() == 1) return exact;
  std::string name = wanted, index;
  if (const auto bracket = wanted.rfind('['); bracket != std::string::npos && wanted.ends_with(']')) {
    name = wanted.substr(0, bracket);
    index = wanted.substr(bracket + 1, wanted.size() - bracket - 2);
  }
  std::vector<GridEntry> found = named(file, name);
  if (found.empty())
    throw BadFile("there is no grid \"" + printable(wanted) + "\"; the file has " + listing(file));
  if (index == "*") return found;
  for (const GridEntry& entry : found)
    if (index == std::to_string(entry.index)) return {entry};
  std::string choices;
  for (const GridEntry& entry : found) {
    if (entry.index == 20) {
      choices += ", ...";
      break;
    }
    choices += (choices.empty() ? "" : ", ") + printable(name) + "[" + std::to_string(entry.index) + "]";
  }
  if (!index.empty())
    throw BadFile("there is no grid \"" + printable(wanted) + "\"; the file has " + choices);
  throw BadFile(std::to_string(found.size()) + " grids are named \"" + printable(name) + "\"; pick one of " +
                choices + ", or " + printable(name) + "[*] for their sum");
}

std::vector<GridEntry> pick_density(VdbFile& file, bool level_sets_too, std::string& note) {
  if (file.entries().empty()) throw BadFile("the file has no grids");
  if (!named(file, "density").empty()) return pick(file, "density");
  std::vector<GridEntry> usable, hot;
  std::string reasons;
  for (const GridEntry& entry : file.entries()) {
    if (!is_scalar(entry) || (!level_sets_too && is_level_set(*file.read_header(entry)))) continue;
    (is_temperature_name(entry.name) ? hot : usable).push_back(entry);
  }
  if (usable.empty()) usable = hot;
  if (usable.size() == 1) {
    note = "there is no grid \"density\"; \"" + printable(usable.front().label()) +
           "\", the only grid that can be it, is read";
    return usable;
  }
  if (!usable.empty())
    throw BadFile("no grid is named \"density\" and several could be it; pick one with --grid: " +
                  listing(file));
  // A file with one grid gets that grid's own refusal, which says what to do.
  if (file.entries().size() == 1) return {file.entries().front()};
  throw BadFile("none of its grids can be density: " + listing(file));
}

std::vector<GridEntry> pick_temperature(const VdbFile& file, const std::vector<GridEntry>& density) {
  for (const char* name : temperature_names) {
    std::vector<GridEntry> found = named(file, name);
    std::erase_if(found, [&](const GridEntry& e) {
      return !is_scalar(e) || std::any_of(density.begin(), density.end(), [&](const GridEntry& d) {
        return d.unique_name == e.unique_name && d.grid_at == e.grid_at;
      });
    });
    if (!found.empty()) return found;
  }
  return {};
}

openvdb::FloatGrid::Ptr as_floats(const openvdb::GridBase::Ptr& grid) {
  if (auto floats = openvdb::gridPtrCast<openvdb::FloatGrid>(grid)) return floats;
  openvdb::FloatGrid::Ptr result;
  with_scalar(*grid, [&](const auto& scalar) {
    result = openvdb::FloatGrid::create(std::make_shared<openvdb::FloatTree>(scalar.tree()));
    result->setTransform(scalar.transform().copy());
    result->setGridClass(scalar.getGridClass());
  });
  grid->newTree();
  return result;
}

}  // namespace plinian::vdb
