// Pictures as files: linear OpenEXR with metadata, PNG through a view transform, and reading whatever
// OpenImageIO knows. Leaves out deep pictures, further parts and mip levels.
#pragma once

#include <string>
#include <vector>

#include "core/files/atomic_file.h"
#include "core/image/image.h"
#include "core/image/view_transform.h"

namespace plinian {

enum class ExrPixels {
  half_float,  // 11 significant bits; finite values are kept under 65504. Z stays single
  single_float,
};
enum class ExrCompression {
  none,
  zip,   // lossless
  dwaa,  // lossy, small
};

struct WriteOptions {
  ExrPixels exr_pixels = ExrPixels::half_float;
  ExrCompression exr_compression = ExrCompression::zip;
  float dwa_level = 45.0f;  // [-] >= 0: larger is smaller and worse; 45 is visually lossless
  ViewSettings view;        // of a PNG
  bool dither = true;       // of a PNG: see to_display_bytes
};

/// The extensions that can be written, with their dot: .exr, .png.
std::vector<std::string> writable_extensions();

/// Everything about an output that can be known before anything is rendered: a known extension, a folder that
/// exists and takes files, a target that may be replaced, and for a PNG a view that works. Throws ImageError
/// or FileError.
void check_output(const std::string& path, const WriteOptions& options = {});

/// Writes a picture by the path's extension, whole or not at all: every channel and all metadata to an EXR;
/// colour, as seen through the view, and metadata as text to a PNG. Throws ImageError or FileError.
void write_image(const std::string& path, const Image& image, const WriteOptions& options = {});

/// A PNG file in memory, as write_image writes it.
std::vector<std::uint8_t> encode_png(const Image& image, const ViewTransform& view, bool dither = true);

/// A PNG file in memory from 8-bit display values. rgb: width * height * 3 bytes, top row first.
std::vector<std::uint8_t> encode_png(const std::vector<std::uint8_t>& rgb, int width, int height);

/// Reads a picture, linear. sRGB and gamma-encoded files are linearised, unassociated alpha is multiplied in,
/// and an EXR's data window is placed into its display window. Throws ImageError: no such file, not a
/// picture, damaged, deep, or more than 2^28 pixels or 1,024 channels.
Image read_image(const std::string& path);

}  // namespace plinian
