// One medium of a scene, from its description: read from a file, made, or analytic, and placed in the world.
// The steps stand alone, so that whoever reads volumes by other means fills in the rest in the same way.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/media/medium.h"
#include "core/media/procedural.h"
#include "core/scene/placement.h"
#include "core/scene/scene_loader.h"

namespace plinian {

enum class MediumSource { file, procedural, analytic };

MediumSource medium_source(const MediumDescription& description);

/// What is wrong with a description before anything is read. Throws std::runtime_error (one line): no such
/// file or kind, an option of another kind of source, a scale of 0.
void check_medium(const MediumDescription& description);

/// The file, taken from the description's folder where it is relative; may be a pattern (frame_sequence.h).
std::string medium_path(const MediumDescription& description);
/// Which grids are read, and how; without limits and progress.
VdbOptions medium_vdb_options(const MediumDescription& description);
/// The file's space: as described, else as the file's own guess where one is asked for.
VdbOrientation medium_orientation(const MediumDescription& description, const VdbFacts& facts);
ProceduralSettings medium_procedural(const MediumDescription& description);
Placement medium_placement(const MediumDescription& description);

/// The medium with everything that its description leaves open. volume: null for an analytic one; facts: of
/// a file, else null. Appends to notes and warnings of `told`.
Medium finish_medium(const MediumDescription& description, std::shared_ptr<const BrickVolume> volume,
                     const VdbFacts* facts, LoadedScene& told);

/// Appends to notes and warnings of `told`. Throws std::runtime_error (one line), SceneLoadCancelled.
Medium load_medium(const MediumDescription& description, const SceneLoadOptions& options, LoadedScene& told);

}  // namespace plinian
