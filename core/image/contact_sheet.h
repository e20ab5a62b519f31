// Pictures side by side with a text under each, for figures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/image/view_transform.h"

namespace plinian {

struct SheetPicture {
  int width = 0, height = 0;      // [pixels]
  std::vector<std::uint8_t> rgb;  // width * height * 3 display values, top row first
  std::string label;              // may be empty; what is not ASCII is drawn as a dash
};

/// A picture as a view shows it.
SheetPicture sheet_picture(const Image& image, const ViewTransform& view, const std::string& label);

/// Lays pictures out in rows of `columns` (>= 1) cells, each as large as the largest picture, on neutral grey
/// with `gap` pixels between and around. Labels that are wider than a cell take several lines; they are left
/// out where the system has no font that OpenImageIO finds. The result has no label; encode_png(rgb, width,
/// height) makes a file of it. Throws ImageError without pictures, and where one does not hold width * height
/// * 3 bytes.
SheetPicture contact_sheet(const std::vector<SheetPicture>& pictures, int columns, int gap = 12);

}  // namespace plinian
