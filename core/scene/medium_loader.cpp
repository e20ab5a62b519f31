// Media from their descriptions.
#include "core/scene/medium_loader.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "core/media/density_scale.h"
#include "core/media/frame_sequence.h"
#include "core/media/procedural.h"
#include "core/media/vdb_reader.h"
#include "core/scene/medium_optics.h"
#include "core/scene/nearest_word.h"
#include "core/scene/placement.h"
#include "core/scene/scene_file.h"

namespace plinian {

namespace fs = std::filesystem;

namespace {

using Source = MediumSource;

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Options of one kind of source must not be ignored silently with another.
void refuse_foreign_options(const MediumDescription& d, Source source) {
  const auto refuse = [&](bool given, const char* key, const char* whose) {
    if (given) throw std::runtime_error(fmt::format("{}: {}: only {} has one", d.volume, key, whose));
  };
  if (source != Source::file) {
    refuse(d.grid.has_value(), "grid", "a .vdb file");
    refuse(d.temperature_grid.has_value(), "temperature_grid", "a .vdb file");
    refuse(d.level_set.has_value(), "level_set", "a .vdb file");
    refuse(d.frustum.has_value(), "frustum", "a .vdb file");
    refuse(d.up_axis.has_value(), "up_axis", "a .vdb file");
    refuse(d.file_unit.has_value(), "file_unit", "a .vdb file");
  }
  if (source != Source::procedural) {
    refuse(d.resolution.has_value(), "resolution", "a procedural medium");
    refuse(d.seed.has_value(), "seed", "a procedural medium");
    refuse(!d.shape.empty(), "shape", "a procedural medium");
  }
}

void refuse_unknown_input(const MediumDescription& d) {
  const fs::path path = medium_path(d);
  std::error_code error;
  if (fs::exists(path, error)) return;
  if (const auto pattern = FramePattern::parse(path.string())) {
    if (!pattern->frames_on_disk().empty()) return;
    throw std::runtime_error(path.string() + ": no file of that sequence is there");
  }
  std::vector<std::string> known = procedural_kinds();
  known.insert(known.end(), analytic_media.begin(), analytic_media.end());
  const bool plain_word = d.volume.find_first_of("./") == std::string::npos;
  throw std::runtime_error(fmt::format("{}: no such file{}", path.string(),
                                       plain_word
                                           ? fmt::format(", and no medium of that name{}; there are: {}",
                                                         did_you_mean(d.volume, known), join(known))
                                           : ""));
}

void refuse_flat(const MediumDescription& d) {
  const dvec3 scale = d.scale.value_or(dvec3(1.0));
  if (scale.x * scale.y * scale.z == 0.0)
    throw std::runtime_error(
        fmt::format("{}: scale: no axis may be 0, or the volume has no inside", d.volume));
}

// What the voxels of a medium mean to an eye: how far one sees into it.
std::string free_path_text(const Medium& medium, float typical_density) {
  const vec3 path = mean_free_path(medium, typical_density);
  return fmt::format("mean free path {:.3g} m at its typical density", std::min({path.x, path.y, path.z}));
}

// What a file says beside its voxels.
void take_facts(const MediumDescription& d, const VdbFacts& facts, Medium& medium, LoadedScene& told) {
  const std::string name = fs::path(facts.path).filename().string();
  for (const std::string& line : facts.notes) told.notes.push_back(name + ": " + line);
  for (const VdbWarning& warning : facts.warnings) told.warnings.push_back(name + ": " + warning.text);
  const VdbOrientation orientation = medium_orientation(d, facts);
  medium.world_from_medium = orientation.world_from_medium();
  if (d.guess_orientation && !d.up_axis && !d.file_unit)
    told.notes.push_back(fmt::format("{}: {} (--up-axis, --file-unit)", name, facts.orientation.reason));
  else if (d.guess_orientation && !(d.up_axis && d.file_unit))
    told.notes.push_back(fmt::format("{}: {} is up and a unit is {:.6g} m; the file's own guess: {}", name,
                                     orientation.up_axis, orientation.file_unit, facts.orientation.reason));
  if (facts.temperature.empty()) return;
  medium.emission.scale = 1.0f;
  if (!d.emission_scale)
    told.notes.push_back(fmt::format("{}: '{}' makes it glow ({}.emission_scale=0 turns that off)", name,
                                     facts.temperature.front().name, d.name.empty() ? "medium" : d.name));
  // Voxels hold kelvin already; a scale per unit of the file is one on top of what they were multiplied by.
  if (d.temperature_scale)
    medium.emission.temperature_scale = float(*d.temperature_scale / facts.temperature_gain);
}

}  // namespace

MediumSource medium_source(const MediumDescription& description) {
  const std::string& name = description.volume;
  if (contains(analytic_media, name)) return Source::analytic;
  if (contains(procedural_kinds(), name)) return Source::procedural;
  return Source::file;
}

std::string medium_path(const MediumDescription& description) {
  const fs::path path(description.volume);
  return path.is_absolute() || description.folder.empty() ? path.string()
                                                          : (fs::path(description.folder) / path).string();
}

VdbOptions medium_vdb_options(const MediumDescription& d) {
  VdbOptions vdb;
  vdb.grid = d.grid.value_or("");
  // In a scene of other programs a temperature that nobody mentions would be light that nobody expects.
  const bool emits = d.guess_orientation || d.temperature_grid || d.emission_scale;
  vdb.temperature_grid = emits ? d.temperature_grid.value_or("") : "none";
  vdb.level_set = d.level_set.value_or(LevelSetMode::refuse);
  vdb.frustum = d.frustum.value_or(FrustumMode::refuse);
  return vdb;
}

VdbOrientation medium_orientation(const MediumDescription& d, const VdbFacts& facts) {
  VdbOrientation orientation = d.guess_orientation ? facts.orientation : VdbOrientation{};
  if (d.up_axis) orientation.up_axis = *d.up_axis == UpAxis::z ? 'z' : 'y';
  if (d.file_unit) orientation.file_unit = *d.file_unit;
  return orientation;
}

ProceduralSettings medium_procedural(const MediumDescription& d) {
  ProceduralSettings settings;
  settings.kind = d.volume;
  if (d.resolution) settings.resolution = *d.resolution;
  if (d.seed) settings.seed = std::uint32_t(*d.seed);
  settings.shape = d.shape;
  return settings;
}

Placement medium_placement(const MediumDescription& d) {
  return {.translate = d.translate.value_or(dvec3(0.0)),
          .rotate = d.rotate.value_or(dvec3(0.0)),
          .scale = d.scale.value_or(dvec3(1.0))};
}

void check_medium(const MediumDescription& d) {
  const Source source = medium_source(d);
  refuse_foreign_options(d, source);
  refuse_flat(d);
  if (source == Source::file) refuse_unknown_input(d);
}

Medium finish_medium(const MediumDescription& d, std::shared_ptr<const BrickVolume> volume,
                     const VdbFacts* facts, LoadedScene& told) {
  const Source source = medium_source(d);
  const dmat4 placed = matrix_of(medium_placement(d));
  Medium medium;
  medium.volume = std::move(volume);
  if (source == Source::file) take_facts(d, *facts, medium, told);
  if (source == Source::procedural) {
    wear_look(procedural_look(d.volume), medium);
    if (!told.seed) told.seed = int(medium_procedural(d).seed);
  }
  if (source == Source::analytic) medium.shape = d.volume == "box" ? MediumShape::box : MediumShape::sphere;
  medium.name = d.name.empty() ? "medium" : d.name;
  medium.world_from_medium = placed * medium.world_from_medium;

  set_optics(d, medium);
  if (d.temperature_offset) medium.emission.temperature_offset = *d.temperature_offset;
  if (d.temperature_scale && source == Source::procedural)
    medium.emission.temperature_scale = *d.temperature_scale;

  const double size_factor = std::cbrt(std::abs(determinant(dmat3(placed)))) *
                             (source == Source::file ? double(d.file_unit.value_or(1.0f)) : 1.0);
  if (d.density_scale) medium.density_scale = *d.density_scale;
  if (source == Source::file && !d.density_scale) {
    medium.density_scale = automatic_density_scale(*medium.volume, medium.world_from_medium);
    if (!medium.volume->empty()) {
      const DensityFacts density = measure_density(*medium.volume, medium.world_from_medium);
      told.notes.push_back(
          fmt::format("{}: density scale {:.4g}, for a median optical depth of 12; {} (--density-scale)",
                      fs::path(facts->path).filename().string(), medium.density_scale,
                      free_path_text(medium, density.typical_density)));
    }
  } else if (d.rescale == Keep::optical_depth) {
    medium.density_scale = float(medium.density_scale / size_factor);
  }
  return medium;
}

Medium load_medium(const MediumDescription& d, const SceneLoadOptions& options, LoadedScene& told) {
  check_medium(d);
  const Source source = medium_source(d);
  if (source == Source::analytic) return finish_medium(d, nullptr, nullptr, told);
  try {
    if (source == Source::procedural)
      return finish_medium(d, make_procedural(medium_procedural(d), options.progress), nullptr, told);
    VdbOptions vdb = medium_vdb_options(d);
    vdb.time_limit_s = options.vdb_time_limit_s;
    vdb.memory_limit_bytes = options.vdb_memory_limit_bytes;
    vdb.progress = options.progress;
    const VdbVolume file = read_vdb(medium_path(d), vdb);
    return finish_medium(d, file.volume, &file.facts, told);
  } catch (const ProceduralCancelled&) {
    throw SceneLoadCancelled();
  } catch (const VdbCancelled&) {
    throw SceneLoadCancelled();
  }
}

}  // namespace plinian
