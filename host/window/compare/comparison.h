// What the picture is compared with: one that was kept, or the offline reference, rendered beside everything
// else.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "host/window/view/developer.h"
#include "host/window/view/view_renderer.h"

namespace plinian::window {

class Comparison {
 public:
  /// development: of the picture that is compared; told what it is measured against. wake: as the renderer's.
  Comparison(Development& development, std::function<void()> wake);

  Developer developer;   // of the other picture
  ViewPicturePtr other;  // null: nothing to compare with
  std::string name;      // of the other: "kept", "reference"
  bool wipes = false;
  float wipe = 0.5f;  // [-] of the picture's width: left of it the other one is seen

  /// picture: null forgets.
  void keep(ViewPicturePtr picture, const std::string& name);
  /// Whether the other shows another scene or view than pictures of that number.
  bool is_old(std::uint64_t number) const { return other && other->number != number; }

  /// Renders the offline reference of a scene.
  void render_reference(const SceneSnapshot& scene, std::uint64_t number);
  void stop_reference() { reference_.reset(); }
  /// How far that is [0, 1]; none where none is being rendered.
  std::optional<double> reference_share() const;
  /// Takes over what there is of the reference. To be called once a turn.
  void update();

 private:
  Development& development_;
  std::function<void()> wake_;
  std::unique_ptr<ViewRenderer> reference_;
};

}  // namespace plinian::window
