// Keeps the other picture, and renders the reference.
#include "host/window/compare/comparison.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "core/integrate/dual_march.h"

namespace plinian::window {

namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

const char* name_of(CompareMode mode) {
  switch (mode) {
    case CompareMode::wipe:
      return "wipe";
    case CompareMode::side_by_side:
      return "side by side";
    case CompareMode::flicker:
      return "flicker";
    case CompareMode::difference:
      return "difference";
    case CompareMode::flip:
      return "FLIP";
    default:
      return "off";
  }
}

Comparison::Comparison(scene::Workspace& workspace, Development& development, std::function<void()> wake)
    : developer(wake), images(workspace, wake), development_(development), wake_(std::move(wake)) {}

void Comparison::set_mode(CompareMode mode) {
  if (!other && mode != CompareMode::off) take_file();
  mode_ = other ? mode : CompareMode::off;
  development_.seen = mode_ == CompareMode::difference ? Seen::difference
                      : mode_ == CompareMode::flip     ? Seen::flip
                                                       : Seen::picture;
}

bool Comparison::is_others_turn() const {
  if (mode_ != CompareMode::flicker) return false;
  return flicker_rate > 0.0f ? std::fmod(seconds() * double(flicker_rate), 2.0) >= 1.0 : flicker_other;
}

double Comparison::until_next_turn() const {
  if (mode_ != CompareMode::flicker || flicker_rate <= 0.0f) return INFINITY;
  const double turns = seconds() * double(flicker_rate);
  return (std::floor(turns) + 1.0 - turns) / double(flicker_rate);
}

void Comparison::keep(ViewPicturePtr picture, const std::string& name_of_it, OtherKind kind_of_it) {
  other = std::move(picture);
  name = other ? name_of_it : "";
  kind = other ? kind_of_it : OtherKind::none;
  development_.against = other;
  development_.against_file = kind == OtherKind::file ? images.reference.picture() : nullptr;
  if (other) return;
  set_mode(CompareMode::off);
  developer.forget();
}

void Comparison::take_file() {
  const FilePicturePtr& file = images.reference.picture();
  if (!file) return;
  auto picture = std::make_shared<ViewPicture>();
  picture->frame = file->picture.frame;
  picture->scene.width = picture->frame.width;
  picture->scene.height = picture->frame.height;
  picture->at_rest = true;
  keep(std::move(picture), file->name, OtherKind::file);
  // What was chosen for it stays while it is the same one.
  if (file->source == matched_source_) return;
  matched_source_ = file->source;
  development_.matching = usual_matching(file->picture);
}

std::optional<ivec2> Comparison::wanted_size() const {
  if (kind != OtherKind::file) return std::nullopt;
  return ivec2(other->frame.width, other->frame.height);
}

void Comparison::render_reference(const SceneSnapshot& scene, std::uint64_t number) {
  if (!reference_)
    reference_ = std::make_unique<ViewRenderer>([] { return std::make_unique<DualMarch>(); }, wake_);
  reference_->ask({scene, number, false});
}

std::optional<double> Comparison::reference_share() const {
  if (!reference_) return std::nullopt;
  const ViewRenderer::Status status = reference_->status();
  return status.is_busy ? std::optional(status.share) : std::nullopt;
}

void Comparison::update() {
  if (images.update()) {
    const bool there = images.reference.picture() != nullptr;
    // Who loads a picture wants to see it; one that follows the time takes the place of the one before.
    const bool first = there && !file_was_there_;
    if (first || (there && kind == OtherKind::file)) take_file();
    if (first && mode_ == CompareMode::off) set_mode(CompareMode::wipe);
    if (!there && kind == OtherKind::file) keep(nullptr, "", OtherKind::none);
    file_was_there_ = there;
  }
  if (wants_file_ && !images.reference.is_reading()) {
    wants_file_ = false;
    take_file();
    if (kind == OtherKind::file && mode_ == CompareMode::off) set_mode(CompareMode::wipe);
  }
  development_.plate = images.plate.picture();
  if (!reference_) return;
  if (const ViewPicturePtr reference = reference_->picture();
      reference && reference != taken_ && !reference->quick) {
    taken_ = reference;
    keep(reference, "reference", OtherKind::rendered);
    if (mode_ == CompareMode::off) set_mode(CompareMode::wipe);
  }
  if (!taken_ || !taken_->at_rest || reference_->status().is_busy) return;
  // It is done: what made it need not hold the scene any longer.
  reference_.reset();
  taken_ = nullptr;
}

}  // namespace plinian::window
