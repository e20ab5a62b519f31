// Reads .vdb files: what is in one (inspect_vdb), and one of its grids, or a sum of them, as a BrickVolume.
//
// Nothing of OpenVDB is linked here: a file is parsed by a worker process (vdb_process.h), so that a damaged
// or hostile file costs an error line and never the program. Whatever is done to the data beyond reading it
// is told in `notes` and `warnings`, to be said aloud.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/media/brick_volume.h"

namespace plinian {

enum class LevelSetMode {
  refuse,
  fog,  // inside 1, outside 0, with a ramp over the inner half of the narrow band
};
enum class FrustumMode {
  refuse,
  resample,  // onto a grid of equal voxels, as large as the frustum's in the middle of its data
};

struct VdbOptions {
  std::string grid;              // "": chosen; "name"; "name[2]": that one of a name's; "name[*]": their sum
  std::string temperature_grid;  // "": temperature, heat or flame if there; "none": none; else as `grid`
  LevelSetMode level_set = LevelSetMode::refuse;
  FrustumMode frustum = FrustumMode::refuse;
  double time_limit_s = 0.0;  // [s] that reading may take; 0: 10 s and 1 s per 4 MB of file
  std::uint64_t memory_limit_bytes =
      0;  // [bytes] that reading may take, and half of it the voxels;
          // 0: 384 MiB and 96 times the file, within 3/4 of the machine's memory
  std::function<bool(double)> progress;  // called with a share in [0, 1]; returning false cancels
};

/// One clear line: file, grid, reason, what to do.
struct VdbError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Thrown when `progress` returned false.
struct VdbCancelled : std::runtime_error {
  VdbCancelled() : std::runtime_error("cancelled") {}
};

/// What a grid of a file is, as stored.
struct VdbGridInfo {
  std::string name;        // as VdbOptions::grid takes it: "density", or "density[1]" of several
  std::string value_type;  // "float", "half", "double", "int32", "int64", "bool", "vec3s", ...
  std::string grid_class;  // "fog volume", "level set", "staggered" or "unknown"
  std::string transform;   // "uniform", "anisotropic", "affine" (turned, sheared), "frustum" or "singular"
  std::string refusal;     // why it cannot be density as things stand; empty where it can
  std::string error;       // why it cannot be read at all; empty where it can
  dmat4 medium_from_index{1.0};             // affine; identity for a frustum or a singular one
  dvec3 voxel_size{0.0};                    // [file unit] lengths of the index axes
  std::array<std::int64_t, 3> index_min{};  // lowest active voxel
  std::array<std::int64_t, 3> dims{};       // [voxels] of the active bounding box; 0 where empty
  std::int64_t active_voxels = 0;           // tiles counted as the voxels they stand for
  std::uint64_t leaves = 0;                 // 8^3 blocks that hold voxels; 0 where only metadata was read
  std::uint64_t memory_bytes = 0;           // as OpenVDB holds it
  std::uint64_t stored_bytes = 0;           // in the file; 0 where that does not tell, or it is not listed
  std::optional<double> minimum, maximum;   // of active values; absent for vectors, points and empty grids
  double background = 0.0;                  // scalar grids
  std::map<std::string, std::string> metadata;
};

/// Size and orientation of a file's unit, as good a guess as its metadata allows.
struct VdbOrientation {
  double file_unit = 1.0;    // [m] length of one unit of the file
  char up_axis = 'y';        // 'y' or 'z', of the file's space
  bool unit_assumed = true;  // nothing in the file speaks for file_unit
  bool up_assumed = true;    // nothing in the file speaks for up_axis
  std::string reason;  // a sentence: "z is up and a unit is a metre, as in Blender (creator: Blender/Smoke)"
  /// Turns the file's space into the scene's: metres, y up.
  dmat4 world_from_medium() const;
};

/// Something about the voxels that a user should know, counted.
struct VdbWarning {
  std::string kind;        // not_a_number, infinite, negative, empty, sparse_box, background, temperature
  std::int64_t count = 1;  // voxels (or grids) that it is about
  std::string text;        // the sentence
};

struct VdbFacts {
  std::string path;
  std::uint64_t file_bytes = 0;
  std::string format;                           // "224, written by OpenVDB 11.0"
  std::map<std::string, std::string> metadata;  // of the file
  VdbOrientation orientation;
  std::vector<VdbGridInfo> density;      // the grid read, or the grids summed
  std::vector<VdbGridInfo> temperature;  // empty, or the grid (or grids: their maximum) read beside it
  double temperature_gain = 1.0;         // [K / unit of the grid]
  double temperature_peak = 0.0;         // [unit of the grid] largest finite value
  std::vector<std::string> notes;        // sentences: choices made, conversions done
  std::vector<VdbWarning> warnings;
};

struct VdbVolume {
  std::shared_ptr<const BrickVolume> volume;  // never null
  VdbFacts facts;
};

/// Reads a file's density and, where there is one, its temperature [K] (a grid that peaks under 100 is taken
/// as normalised and scaled to a peak of 1800 K). Throws VdbError, VdbCancelled.
VdbVolume read_vdb(const std::string& path, const VdbOptions& options = {});

struct VdbInfo {
  std::string path;
  std::uint64_t file_bytes = 0;
  std::string format;                           // as in VdbFacts
  std::map<std::string, std::string> metadata;  // of the file
  VdbOrientation orientation;
  std::vector<VdbGridInfo> grids;  // in the file's order
};

/// Lists every grid of a file. Of `options` only the limits and progress are used. Throws VdbError,
/// VdbCancelled.
VdbInfo inspect_vdb(const std::string& path, const VdbOptions& options = {});

/// As above by what stands before the voxels, which are not parsed: quick however large the file is, but
/// sizes are those that whoever wrote it noted, and there are no ranges.
VdbInfo list_vdb(const std::string& path, const VdbOptions& options = {});

}  // namespace plinian
