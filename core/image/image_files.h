// What needs OpenImageIO, as a table of functions in a module of its own, plinian-image-files.so: OpenImageIO
// brings some 250 libraries, which cost a third of a second and 120 MiB, so it is loaded when a picture file
// is first read or an EXR first written, and not when the program starts. Everybody else uses image_io.h and
// contact_sheet.h; this header is between them and the module.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/image/image_io.h"

namespace plinian {

/// A picture as a file holds it.
struct PictureFile {
  int width = 0, height = 0;                  // [pixels] of the data window
  int left = 0, top = 0;                      // [pixels] of the data window in the display window
  int full_width = 0, full_height = 0;        // [pixels] of the display window
  std::vector<std::string> channels;          // names
  std::vector<float> values;                  // height * width * channels, top row first, as encoded
  std::map<std::string, Attribute> metadata;  // under our names
  std::string colour_space;                   // as OpenImageIO calls it, in lower case; may be empty
  float gamma = 0.0f;                         // [-] where the colour space is one; else 0
  int alpha = -1;                             // the alpha channel; -1: none
  bool integer = false;                       // values were integers, here in [0, 1]
  bool unassociated_alpha = false;            // colours are not multiplied by alpha yet
};

/// Text to draw into a picture.
struct Label {
  int x = 0, y = 0;  // [pixels] left end of the base line
  std::string text;  // ASCII
};

/// The module's table. Errors are ImageError, without the path where none is given.
struct ImageFiles {
  const char* version;  // of Plinian and of this table; a module of a different one is not used

  std::vector<std::uint8_t> (*encode_exr)(const Image& image, const WriteOptions& options);
  PictureFile (*read)(const std::string& path);
  /// A font that is there, or "". size: [pixels].
  std::string (*find_font)(int size);
  /// Draws labels in one grey into rgb, width * height * 3 bytes. grey: [display] in [0, 1].
  void (*draw_labels)(std::vector<std::uint8_t>& rgb, int width, int height, const std::vector<Label>& labels,
                      const std::string& font, int size, float grey);
};

/// Where the module is, without loading it. Throws ImageError where it is missing or cannot
/// be read.
std::string image_files_path();

/// The module's table; loads it the first time. It stays loaded. Throws ImageError where it is missing,
/// cannot be loaded or is of another version.
const ImageFiles& image_files();

}  // namespace plinian
