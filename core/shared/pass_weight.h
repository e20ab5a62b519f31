// How much each jittered pass counts in the mean of a picture. The first is coarse and errs the same way each
// time: it counts half, so that it fades soon, but not at once, which would be seen.
#ifndef PLINIAN_SHARED_PASS_WEIGHT_H
#define PLINIAN_SHARED_PASS_WEIGHT_H
#include "core/shared/glue.h"
PLN_BEGIN

/// pass: from 0.
PLN_FN float pass_weight(int pass) {
  return pass == 0 ? 1.0f : 2.0f;
}

/// Of the first `passes` passes together.
PLN_FN float weight_of_passes(int passes) {
  return 2.0f * float(passes) - 1.0f;
}

PLN_END
#endif
