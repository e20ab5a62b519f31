// Sums of alpha under cards.
#include "host/window/panels/probe_place.h"

#include <algorithm>

namespace plinian::window {

namespace {

constexpr vec2 upright_size(340.0f, 312.0f), wide_size(600.0f, 146.0f);  // [points] at a scale of 1

// Alpha under the card, summed. [points^2]
double hidden(const PaneRect& card, const std::function<float(vec2)>& smoke) {
  constexpr int steps = 16;  // along each side
  double sum = 0.0;
  for (int y = 0; y < steps; ++y)
    for (int x = 0; x < steps; ++x)
      sum += double(smoke(card.begin + card.size * ((vec2(x, y) + 0.5f) / float(steps))));
  return sum / (steps * steps) * double(card.size.x) * double(card.size.y);
}

}  // namespace

bool is_better_beneath(const PaneRect& pane, const PaneRect& bottom, float scale) {
  constexpr float most = 0.25f;  // [-] of the pane, that an upright card may take
  constexpr vec2 least(240.0f, 110.0f);
  const vec2 card = upright_size * scale;
  const bool is_small = card.x * card.y > most * pane.size.x * pane.size.y || card.y > 0.6f * pane.size.y;
  return is_small && bottom.size.x >= least.x * scale && bottom.size.y >= least.y * scale;
}

std::vector<ProbeCard> probe_cards(const PaneRect& room, float scale) {
  const vec2 upright = glm::min(upright_size * scale, room.size),
             wide = glm::min(wide_size * scale, room.size * vec2(1.0f, 0.42f));
  const auto at = [&](vec2 size, vec2 share) {
    return PaneRect{room.begin + (room.size - size) * share, size};
  };
  std::vector<ProbeCard> cards;
  if (upright.x <= 0.5f * room.size.x && upright.y >= 240.0f * scale)
    for (const vec2 corner : {vec2(1, 1), vec2(0, 1), vec2(1, 0), vec2(0, 0)})
      cards.push_back({at(upright, corner), false});
  for (const vec2 edge : {vec2(0, 1), vec2(0, 0)}) cards.push_back({at(wide, edge), true});
  return cards;
}

bool leaves_free(const PaneRect& card, vec2 pixel, float reach) {
  return !holds({card.begin - reach, card.size + 2.0f * reach}, pixel);
}

std::size_t least_hiding(const std::vector<ProbeCard>& cards, vec2 pixel, float reach,
                         const std::function<float(vec2)>& smoke, std::optional<std::size_t> now) {
  std::size_t best = 0;
  double least = 0.0;
  for (std::size_t i = 0; i < cards.size(); ++i) {
    const PaneRect& card = cards[i].place;
    double cost = hidden(card, smoke);
    if (now == i) cost = 0.7 * cost - 1.0;
    // Of those that hide nothing the one that is farther away.
    cost -= 1e-3 * double(glm::length(card.begin + 0.5f * card.size - pixel));
    if (!leaves_free(card, pixel, reach)) cost += leaves_free(card, pixel, 0.0f) ? 1e8 : 1e9;
    if (i > 0 && cost >= least) continue;
    best = i;
    least = cost;
  }
  return best;
}

}  // namespace plinian::window
