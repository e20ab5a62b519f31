// What the scene would be in each look: small pictures, made beside the window where nothing else is to be
// done.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/renderer.h"
#include "host/scene/looks.h"
#include "host/window/platform/newest_worker.h"
#include "host/window/view/developer.h"

namespace plinian::window {

struct LookPicture {
  std::string look, problem;  // problem: why there is no picture, one line; else empty
  DevelopedPtr picture;
};

class LookPictures {
 public:
  static constexpr int height = 108;  // [pixels]

  /// make: called on a thread of its own, which lets go of the renderer when the pictures are made. wake:
  /// called there when there are new pictures; must not block.
  LookPictures(std::function<std::unique_ptr<Renderer>()> make, std::function<void()> wake);
  ~LookPictures();

  /// Asks for pictures of a scene where they would be others than those asked for last; every medium wears
  /// the look. To be called while pictures are wanted.
  void update(const SceneSnapshot& scene, const ViewSettings& view);
  /// Lets go of them and of their scene.
  void forget() {
    asked_.reset();
    worker_.forget();
  }
  /// In the order of scene::look_names(), or null before the first.
  std::shared_ptr<const std::vector<LookPicture>> pictures() const { return worker_.answer(); }

 private:
  struct Question {
    SceneSnapshot scene;  // as small as the pictures
    ViewSettings view;
    std::vector<std::string> looks;
  };
  std::vector<LookPicture> make_all(const Question& question) const;

  std::function<std::unique_ptr<Renderer>()> make_;
  std::optional<SceneSnapshot> asked_;
  std::string asked_words_;  // of the view, and of the looks there are
  std::atomic<bool> stopping_{false};
  NewestWorker<Question, std::vector<LookPicture>> worker_;  // last: it uses the rest
};

/// A scene whose media look as a look says, and by default where it says nothing. Their density stays, and so
/// do their temperatures.
SceneSnapshot in_look(SceneSnapshot scene, const MediumDescription& look);

}  // namespace plinian::window
