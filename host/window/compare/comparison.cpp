// Keeps the other picture, and renders the reference.
#include "host/window/compare/comparison.h"

#include <utility>

#include "core/integrate/dual_march.h"

namespace plinian::window {

Comparison::Comparison(Development& development, std::function<void()> wake)
    : developer(wake), development_(development), wake_(std::move(wake)) {}

void Comparison::keep(ViewPicturePtr picture, const std::string& name_of_it) {
  other = std::move(picture);
  name = name_of_it;
  development_.against = other;
  if (!other) development_.difference = wipes = false;
}

void Comparison::render_reference(const SceneSnapshot& scene, std::uint64_t number) {
  if (!reference_)
    reference_ = std::make_unique<ViewRenderer>([] { return std::make_unique<DualMarch>(); }, wake_);
  reference_->ask({scene, number, false});
  if (!development_.difference) wipes = true;
}

std::optional<double> Comparison::reference_share() const {
  if (!reference_) return std::nullopt;
  const ViewRenderer::Status status = reference_->status();
  return status.is_busy ? std::optional(status.share) : std::nullopt;
}

void Comparison::update() {
  if (!reference_) return;
  if (const ViewPicturePtr reference = reference_->picture();
      reference && reference != other && !reference->quick)
    keep(reference, "reference");
}

}  // namespace plinian::window
