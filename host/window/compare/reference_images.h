// Pictures from files that belong to the scene, read beside the interface: the one that the view is compared
// with, and the plate behind it. Follows the time, and what happens to the files.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "host/scene/workspace.h"
#include "host/window/compare/reference_picture.h"

namespace plinian::window {

/// A picture from a file as it was read. Immutable.
struct FilePicture {
  ReadPicture picture;
  std::string name;                 // "ref.0012.exr"
  std::string source;               // as the scene names it, and its colours; one for a whole sequence
  std::vector<std::string> layers;  // that it could show instead
};
using FilePicturePtr = std::shared_ptr<const FilePicture>;

/// One of the two.
class ReferenceImage {
 public:
  /// What there is; null before it was read, and where the scene has none.
  const FilePicturePtr& picture() const { return picture_; }
  const std::string& problem() const { return problem_; }  // why it could not be read; one line
  const std::string& node() const { return node_; }        // its name; empty where the scene has none
  bool is_reading() const { return reading_.valid(); }

 private:
  friend class ReferenceImages;
  struct Wanted {
    std::string path, source, layer, colour_space;
    float exposure = 0.0f;
    std::int64_t modified_ns = 0, bytes = -1;  // of the file
    bool operator==(const Wanted&) const = default;
  };
  struct Outcome {
    FilePicturePtr picture;
    std::string problem;
  };
  bool update(const std::string& node, const Wanted& wanted, const std::function<void()>& wake);
  void forget();

  std::string node_, problem_;
  Wanted read_;
  FilePicturePtr picture_;
  std::future<Outcome> reading_;
};

class ReferenceImages {
 public:
  /// wake: called from any thread when something was read.
  ReferenceImages(scene::Workspace& workspace, std::function<void()> wake)
      : workspace_(workspace), wake_(std::move(wake)) {}

  ReferenceImage reference, plate;
  /// To be called once a turn. Returns whether a picture is there, or gone, since the last call.
  bool update();
  /// When it has to be called again to see files change. [s]
  static constexpr double watch_seconds = 1.0;

 private:
  bool update(ReferenceImage& image, bool behind);

  scene::Workspace& workspace_;
  std::function<void()> wake_;
};

}  // namespace plinian::window
