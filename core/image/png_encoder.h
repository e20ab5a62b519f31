// PNG files of 8-bit sRGB colour [W3C Portable Network Graphics, second edition]. Written here, with zlib
// alone, so that a picture costs neither the time nor the memory that loading OpenImageIO does. Leaves out
// palettes, alpha, 16 bits and interlacing.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace plinian {

/// A PNG file. rgb: width * height * 3 bytes, top row first; width, height >= 1. text: keys of 1 to 79 bytes;
/// others are left out, for PNG has no place for them. ASCII is stored as tEXt, the rest as UTF-8 in iTXt.
/// Throws ImageError where the sizes do not agree.
std::vector<std::uint8_t> png_of(const std::vector<std::uint8_t>& rgb, int width, int height,
                                 const std::map<std::string, std::string>& text);

}  // namespace plinian
