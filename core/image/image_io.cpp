#include "core/image/image_io.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/image/image_files.h"
#include "core/image/png_encoder.h"
#include "core/shared/view_curve.h"

namespace plinian {
namespace {

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

void check_extension(const std::string& path) {
  const std::string extension = lower_extension(path);
  std::string known;
  for (const std::string& candidate : writable_extensions()) {
    if (candidate == extension) return;
    known += (known.empty() ? "" : ", ") + candidate;
  }
  throw ImageError(path + ": cannot be written: " +
                   (extension.empty() ? "no extension" : "unknown extension " + extension) + "; use one of " +
                   known);
}

// Values of a file to linear ones, by what the file says of itself.
void linearise(const PictureFile& file, Image& image) {
  image.display_referred = file.integer;
  const std::string& space = file.colour_space;
  const bool encoded_by_gamma = space.starts_with("gamma") && file.gamma > 0.0f;
  const bool srgb = !encoded_by_gamma && (space == "srgb" || (space.empty() && file.integer));
  if (!srgb && !encoded_by_gamma) return;
  for (Channel& channel : image.channels) {
    if (&channel - image.channels.data() == file.alpha) continue;
    for (float& value : channel.values) {
      const float magnitude = std::abs(value);
      const float linear = srgb ? shared::linear_from_srgb(magnitude) : std::pow(magnitude, file.gamma);
      value = std::copysign(linear, value);
    }
  }
}

void multiply_alpha(const PictureFile& file, Image& image) {
  if (file.alpha < 0 || !file.unassociated_alpha) return;
  const std::vector<float> alpha = image.channels[std::size_t(file.alpha)].values;
  for (Channel& channel : image.channels)
    if (&channel - image.channels.data() != file.alpha)
      for (std::size_t i = 0; i < alpha.size(); ++i) channel.values[i] *= alpha[i];
}

}  // namespace

std::vector<std::string> writable_extensions() {
  return {".exr", ".png"};
}

void check_output(const std::string& path, const WriteOptions& options) {
  check_extension(path);
  if (lower_extension(path) == ".png") ViewTransform{options.view};
  check_writable(path);
  if (lower_extension(path) == ".exr") image_files_path();
}

void write_image(const std::string& path, const Image& image, const WriteOptions& options) {
  check_extension(path);
  std::vector<std::uint8_t> bytes;
  try {
    bytes = lower_extension(path) == ".exr" ? image_files().encode_exr(image, options)
                                            : encode_png(image, ViewTransform(options.view), options.dither);
  } catch (const ImageError& error) {
    throw ImageError(path + ": " + error.what());
  }
  write_file(path, bytes);
}

std::vector<std::uint8_t> encode_png(const Image& image, const ViewTransform& view, bool dither) {
  std::map<std::string, std::string> text;
  for (const auto& [key, value] : image.metadata)
    if (const std::string* words = std::get_if<std::string>(&value)) text[key] = *words;
  text["plinian:view"] = view.description();
  return png_of(to_display_bytes(image, view, dither), image.width, image.height, text);
}

std::vector<std::uint8_t> encode_png(const std::vector<std::uint8_t>& rgb, int width, int height) {
  return png_of(rgb, width, height, {});
}

Image read_image(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw ImageError(path + ": no such file");
  if (!std::filesystem::is_regular_file(path, error)) throw ImageError(path + ": is not a plain file");
  const auto refuse = [&](const char* extension, const char* what) {
    if (path.ends_with(extension))
      throw ImageError(path + ": is " + what + ", not a picture: render it first");
  };
  refuse(".plinian", "a scene");
  refuse(".json", "a scene");
  refuse(".vdb", "a volume");
  const PictureFile file = image_files().read(path);
  const std::size_t channels = file.channels.size();
  Image image;
  image.width = file.full_width;
  image.height = file.full_height;
  image.metadata = file.metadata;
  for (std::size_t c = 0; c < channels; ++c) {
    std::vector<float>& values = image.add(file.channels[c]).values;
    for (int y = 0; y < file.height; ++y)
      for (int x = 0; x < file.width; ++x) {
        const int u = x + file.left, v = y + file.top;
        if (u < 0 || v < 0 || u >= image.width || v >= image.height) continue;
        values[std::size_t(v) * image.width + u] =
            file.values[(std::size_t(y) * file.width + x) * channels + c];
      }
  }
  linearise(file, image);
  multiply_alpha(file, image);
  return image;
}

}  // namespace plinian
