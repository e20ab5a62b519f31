// What is settled once for a sequence, and stays so while its frames come and go: camera, density scale,
// orientation and lights.
//
// A command that makes the frames of a sequence is run again when more of them have arrived, or when one was
// broken. What it would settle anew by what is there by then would move the camera of frames that are done,
// and have all of them made again. So each picture says what it was made with, and while there is one of the
// same command that stands.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/media/frame_sequence.h"
#include "host/cli/scene_arguments.h"
#include "host/graph/commands/session.h"

namespace plinian::cli {

struct KeptSetup {
  std::string picture;              // that says so
  std::vector<std::string> values;  // "camera.translate.x 3", in the order of the scene
};

/// Name of the fact in a picture's metadata.
inline constexpr const char* setup_attribute = "plinian:sequence_setup";

/// What is settled in a scene that was made of the arguments, as a picture says it.
std::string setup_text(graph::Session& session, const SceneArguments& arguments);

/// What the first picture that was made with the same arguments says, among those that patterns name.
std::optional<KeptSetup> find_setup(const std::vector<FramePattern>& pictures,
                                    const SceneArguments& arguments);

/// Settles it so. Returns whether anything changed; a scene that it does not fit stays as it is.
bool restore_setup(graph::Session& session, const KeptSetup& setup);

}  // namespace plinian::cli
