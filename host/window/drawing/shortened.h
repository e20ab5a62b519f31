// A text that is too long for its place.
#pragma once

#include <string>

namespace plinian::window {

/// The text, or as much of its beginning as leaves room for the dots behind it. width_of: of a text, growing
/// with it. room: in the same unit.
template <class WidthOf>
std::string shortened(const std::string& text, float room, const WidthOf& width_of) {
  if (width_of(text) <= room) return text;
  const std::string dots = "...";
  std::size_t least = 0, most = text.size();  // letters that have room, and that have not
  while (least + 1 < most) {
    const std::size_t middle = (least + most) / 2;
    (width_of(text.substr(0, middle) + dots) <= room ? least : most) = middle;
  }
  // Not within a letter of several bytes.
  while (least > 0 && (static_cast<unsigned char>(text[least]) & 0xc0) == 0x80) --least;
  return text.substr(0, least) + dots;
}

}  // namespace plinian::window
