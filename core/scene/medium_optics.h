// What says how a medium looks, from a description of it.
#pragma once

#include "core/scene/scene_description.h"
#include "core/scene/snapshot.h"

namespace plinian {

/// Scattering, absorption, phase function and emission as described; what is left open stays. Temperatures
/// are those of the volume: they are no part of it.
void set_optics(const MediumDescription& description, Medium& medium);

}  // namespace plinian
