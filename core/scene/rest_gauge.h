// When a picture that is refined pass by pass has come to rest.
//
// With M_n the mean of n passes, |M_n - M_(n/2)| estimates how far M_n still is from its limit: exactly where
// the error falls as 1/n, and in expectation where it falls as 1/sqrt(n). It is measured as a display would
// show it, where the medium is seen, so that neither exposure nor framing decides. Biased: a limit that all
// passes share an error with is not looked for.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "core/scene/frame.h"
#include "core/scene/renderer.h"

namespace plinian {

class RestGauge {
 public:
  /// Whether a look at the picture after so many passes is of use: at 1, 2, 3, 4, 6, 8, 12, 16...
  static bool looks_at(int passes);

  /// Takes the mean of the first `passes` passes. Returns the change still to come [8-bit steps of an sRGB
  /// display, root mean square over the pixels where alpha is over 0.01], as soon as the picture of half as
  /// many passes was seen. A picture whose 99.9th percentile is darker than white is lifted until it is not.
  std::optional<float> look(int passes, const Frame& mean);

 private:
  std::map<int, std::vector<vec3>> seen_;  // radiance, by number of passes
};

/// Says after each pass of a picture whether another one follows.
class Refinement {
 public:
  explicit Refinement(const Passes& passes) : passes_(passes) {}

  /// done: passes so far. mean: makes the picture of them; called only where it is looked at.
  bool wants_another(int done, const std::function<Frame()>& mean);
  /// The last estimate [8-bit steps], where there was one.
  std::optional<float> rest_change() const { return change_; }

 private:
  const Passes& passes_;
  RestGauge gauge_;
  std::optional<float> change_;
};

}  // namespace plinian
