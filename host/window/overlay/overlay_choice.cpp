// One list of words for both directions.
#include "host/window/overlay/overlay_choice.h"

#include <sstream>
#include <utility>

namespace plinian::window {

namespace {

constexpr std::pair<const char*, bool OverlayChoice::*> words[] = {
    {"grid", &OverlayChoice::grid},           {"axes", &OverlayChoice::axes},
    {"scale_bar", &OverlayChoice::scale_bar}, {"bounds", &OverlayChoice::bounds},
    {"icons", &OverlayChoice::icons},         {"gate", &OverlayChoice::gate},
    {"drawings", &OverlayChoice::drawings},   {"handles", &OverlayChoice::handles}};

}  // namespace

std::string text_of(const OverlayChoice& choice) {
  std::string text;
  for (const auto& [word, on] : words)
    if (!(choice.*on)) text += std::string(word) + "\n";
  return text;
}

OverlayChoice read_overlay_choice(const std::string& text) {
  OverlayChoice choice;
  std::istringstream lines(text);
  for (std::string word; lines >> word;)
    for (const auto& [known, on] : words)
      if (word == known) choice.*on = false;
  return choice;
}

}  // namespace plinian::window
