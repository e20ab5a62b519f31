// What the picture is compared with, and how: a snapshot, the offline reference, rendered beside everything
// else, or a picture from a file.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "host/window/compare/reference_images.h"
#include "host/window/compare/wipe.h"
#include "host/window/view/developer.h"
#include "host/window/view/view_renderer.h"

namespace plinian::window {

enum class CompareMode { off, wipe, side_by_side, flicker, difference, flip };
inline constexpr CompareMode compare_modes[] = {CompareMode::off,          CompareMode::wipe,
                                                CompareMode::side_by_side, CompareMode::flicker,
                                                CompareMode::difference,   CompareMode::flip};
/// "off", "wipe", "side by side", "flicker", "difference", "FLIP".
const char* name_of(CompareMode mode);

/// Where the other picture comes from.
enum class OtherKind { none, snapshot, rendered, file };

class Comparison {
 public:
  /// development: of the picture that is compared; told what it is measured against. wake: as the renderer's.
  Comparison(scene::Workspace& workspace, Development& development, std::function<void()> wake);

  Developer developer;   // of the other picture
  ViewPicturePtr other;  // null: nothing to compare with
  OtherKind kind = OtherKind::none;
  std::string name;  // of the other: "snapshot 2", "reference", "ref.0012.exr"
  ReferenceImages images;

  CompareMode mode() const { return mode_; }
  /// Whether there is something to compare with, if only a file that was left.
  bool has_other() const { return other || images.reference.picture(); }
  /// Compares with the file where nothing else was chosen. Does nothing but to `off` where there is neither.
  void set_mode(CompareMode mode);
  void toggle(CompareMode mode) { set_mode(mode_ == mode ? CompareMode::off : mode); }
  Wipe wipe;
  float flicker_rate = 2.0f;   // [1/s] changes, > 0; 0: by hand
  bool flicker_other = false;  // by hand: which is up
  /// Whether it is the other's turn, and how long until that changes [s].
  bool is_others_turn() const;
  double until_next_turn() const;

  /// picture: null forgets.
  void keep(ViewPicturePtr picture, const std::string& name, OtherKind kind);
  /// Compares with the picture from a file that the scene has, as soon as it is read; does nothing where
  /// there is none.
  void want_file() { wants_file_ = true; }
  /// Whether the other shows another scene or view than pictures of that number.
  bool is_old(std::uint64_t number) const {
    return other && kind != OtherKind::file && other->number != number;
  }
  /// The size [pixels] that pictures must have to be measured; none where any will do.
  std::optional<ivec2> wanted_size() const;

  /// Renders the offline reference of a scene.
  void render_reference(const SceneSnapshot& scene, std::uint64_t number);
  /// What there was of it is kept only where it is compared with.
  void stop_reference() {
    reference_.reset();
    taken_ = nullptr;
  }
  /// How far that is [0, 1]; none where none is being rendered.
  std::optional<double> reference_share() const;
  /// Takes over what there is of the reference and of files. To be called once a turn.
  void update();

 private:
  void take_file();

  Development& development_;
  std::function<void()> wake_;
  CompareMode mode_ = CompareMode::off;
  std::unique_ptr<ViewRenderer> reference_;
  ViewPicturePtr taken_;  // of the reference
  bool file_was_there_ = false, wants_file_ = false;
  std::string matched_source_;  // of the file that the matching was chosen for
};

}  // namespace plinian::window
