// The quality sets of renderSettings, written.
#pragma once

#include <string>

#include "core/scene/quality.h"
#include "host/graph/commands/session.h"

namespace plinian::scene {

/// Sets a quality set (fast, high) to values, by commands, and notes the preset's name. Attributes that are
/// connected or locked are left alone. Makes a renderSettings where the scene has none.
void write_quality(graph::Session& session, const std::string& set, const Quality& quality);

}  // namespace plinian::scene
