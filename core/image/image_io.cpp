#include "core/image/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "core/shared/view_curve.h"

namespace plinian {
namespace {

constexpr std::uint64_t max_pixels = std::uint64_t(1) << 28;
constexpr int max_channels = 1024;

// OpenImageIO has names of its own for two attributes of EXR files.
struct AttributeName {
  const char *ours, *oiio;
};
constexpr AttributeName renamed[] = {{attribute::world_to_camera, "worldtocamera"},
                                     {attribute::world_to_ndc, "worldtoNDC"}};

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text.empty() ? "no reason given" : text;
}

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

void set_metadata(OIIO::ImageSpec& spec, const Image& image) {
  for (const auto& [key, value] : image.metadata) {
    std::string name = key;
    for (const AttributeName& pair : renamed)
      if (key == pair.ours) name = pair.oiio;
    if (const int* number = std::get_if<int>(&value)) spec.attribute(name, *number);
    if (const float* number = std::get_if<float>(&value)) spec.attribute(name, *number);
    if (const std::string* text = std::get_if<std::string>(&value)) spec.attribute(name, *text);
    if (const mat4* matrix = std::get_if<mat4>(&value))
      spec.attribute(name, OIIO::TypeMatrix, &(*matrix)[0][0]);
  }
}

void get_metadata(const OIIO::ImageSpec& spec, Image& image) {
  for (const OIIO::ParamValue& value : spec.extra_attribs) {
    std::string name = value.name().string();
    if (name.starts_with("oiio:")) continue;
    for (const AttributeName& pair : renamed)
      if (name == pair.oiio) name = pair.ours;
    if (value.type() == OIIO::TypeInt) image.metadata[name] = value.get_int();
    if (value.type() == OIIO::TypeFloat) image.metadata[name] = value.get_float();
    if (value.type() == OIIO::TypeString) image.metadata[name] = value.get_string();
    if (value.type() == OIIO::TypeMatrix) {
      mat4 matrix;
      std::memcpy(&matrix[0][0], value.data(), 16 * sizeof(float));
      image.metadata[name] = matrix;
    }
  }
}

// Encodes into memory: write_file then knows about every byte that a disk refuses.
std::vector<std::uint8_t> encode(const char* format, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                                 const void* pixels) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::string name = std::string("picture.") + format;
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
  if (!output)
    throw ImageError(std::string("OpenImageIO cannot write ") + format + ": " + one_line(OIIO::geterror()));
  if (!output->set_ioproxy(&memory) || !output->open(name, spec) || !output->write_image(type, pixels) ||
      !output->close())
    throw ImageError(std::string("OpenImageIO cannot write ") + format + ": " + one_line(output->geterror()));
  return bytes;
}

std::vector<std::uint8_t> encode_exr(const Image& image, const WriteOptions& options) {
  const std::size_t channels = image.channels.size(), pixels = image.pixel_count();
  OIIO::ImageSpec spec(image.width, image.height, int(channels), OIIO::TypeFloat);
  spec.channelnames.clear();
  for (std::size_t c = 0; c < channels; ++c) {
    const std::string& name = image.channels[c].name;
    const bool depth = name == "Z";
    spec.channelnames.push_back(name);
    spec.channelformats.push_back(options.exr_pixels == ExrPixels::single_float || depth ? OIIO::TypeFloat
                                                                                         : OIIO::TypeHalf);
    if (name == "A") spec.alpha_channel = int(c);
    if (depth) spec.z_channel = int(c);
  }
  if (options.exr_pixels == ExrPixels::half_float) spec.format = OIIO::TypeHalf;
  set_metadata(spec, image);
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("compression", options.exr_compression == ExrCompression::none ? std::string("none")
                                : options.exr_compression == ExrCompression::zip
                                    ? std::string("zip")
                                    : "dwaa:" + std::to_string(options.dwa_level));
  std::vector<float> interleaved(channels * pixels);
  for (std::size_t c = 0; c < channels; ++c) {
    const std::vector<float>& values = image.channels[c].values;
    const bool half = spec.channelformats[c] == OIIO::TypeHalf;
    for (std::size_t i = 0; i < pixels; ++i) {
      const float value = values[i];
      interleaved[i * channels + c] =
          half && std::isfinite(value) ? std::clamp(value, -65504.0f, 65504.0f) : value;
    }
  }
  return encode("exr", spec, OIIO::TypeFloat, interleaved.data());
}

std::vector<std::uint8_t> encode_png_with(const std::vector<std::uint8_t>& rgb, OIIO::ImageSpec& spec) {
  spec.attribute("oiio:ColorSpace", "sRGB");
  return encode("png", spec, OIIO::TypeUInt8, rgb.data());
}

// Values of a file to linear ones, by what the file says of itself.
void linearise(const OIIO::ImageSpec& spec, Image& image) {
  const bool integer = spec.format.basetype != OIIO::TypeDesc::HALF &&
                       spec.format.basetype != OIIO::TypeDesc::FLOAT &&
                       spec.format.basetype != OIIO::TypeDesc::DOUBLE;
  std::string space = spec.get_string_attribute("oiio:ColorSpace");
  for (char& c : space) c = char(std::tolower(static_cast<unsigned char>(c)));
  const float gamma = spec.get_float_attribute("oiio:Gamma", 0.0f);
  image.display_referred = integer;
  const bool encoded_by_gamma = space.starts_with("gamma") && gamma > 0.0f;
  const bool srgb = !encoded_by_gamma && (space == "srgb" || (space.empty() && integer));
  if (!srgb && !encoded_by_gamma) return;
  for (Channel& channel : image.channels) {
    if (&channel - image.channels.data() == spec.alpha_channel) continue;
    for (float& value : channel.values) {
      const float magnitude = std::abs(value);
      const float linear = srgb ? shared::linear_from_srgb(magnitude) : std::pow(magnitude, gamma);
      value = std::copysign(linear, value);
    }
  }
}

void multiply_alpha(const OIIO::ImageSpec& spec, Image& image) {
  if (spec.alpha_channel < 0 || !spec.get_int_attribute("oiio:UnassociatedAlpha")) return;
  const std::vector<float> alpha = image.channels[std::size_t(spec.alpha_channel)].values;
  for (Channel& channel : image.channels)
    if (&channel - image.channels.data() != spec.alpha_channel)
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
}

void write_image(const std::string& path, const Image& image, const WriteOptions& options) {
  check_extension(path);
  std::vector<std::uint8_t> bytes;
  try {
    bytes = lower_extension(path) == ".exr" ? encode_exr(image, options)
                                            : encode_png(image, ViewTransform(options.view), options.dither);
  } catch (const ImageError& error) {
    throw ImageError(path + ": " + error.what());
  }
  write_file(path, bytes);
}

std::vector<std::uint8_t> encode_png(const Image& image, const ViewTransform& view, bool dither) {
  OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeUInt8);
  set_metadata(spec, image);
  spec.attribute("plinian:view", view.description());
  return encode_png_with(to_display_bytes(image, view, dither), spec);
}

std::vector<std::uint8_t> encode_png(const std::vector<std::uint8_t>& rgb, int width, int height) {
  if (rgb.size() != 3 * std::size_t(width) * std::size_t(height))
    throw ImageError("picture: " + std::to_string(rgb.size()) + " bytes do not make " +
                     std::to_string(width) + "x" + std::to_string(height) + " pixels");
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt8);
  return encode_png_with(rgb, spec);
}

Image read_image(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw ImageError(path + ": no such file");
  if (!std::filesystem::is_regular_file(path, error)) throw ImageError(path + ": is not a plain file");
  OIIO::ImageSpec wishes;
  wishes["oiio:UnassociatedAlpha"] = 1;  // alpha is multiplied in after linearisation, by us
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &wishes);
  if (!input) throw ImageError(path + ": is not a readable picture: " + one_line(OIIO::geterror()));
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.deep) throw ImageError(path + ": is a deep picture: flatten it first");
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 ||
      spec.nchannels > max_channels || spec.full_width < 1 || spec.full_height < 1 ||
      spec.image_pixels() > max_pixels ||
      std::uint64_t(spec.full_width) * std::uint64_t(spec.full_height) > max_pixels)
    throw ImageError(path + ": claims a size that cannot be: " + std::to_string(spec.width) + "x" +
                     std::to_string(spec.height) + "x" + std::to_string(spec.depth) + " pixels, " +
                     std::to_string(spec.nchannels) + " channels");
  const std::size_t channels = std::size_t(spec.nchannels);
  std::vector<float> interleaved(std::size_t(spec.image_pixels()) * channels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, interleaved.data()))
    throw ImageError(path + ": is damaged: " + one_line(input->geterror()));

  Image image;
  image.width = spec.full_width;
  image.height = spec.full_height;
  for (std::size_t c = 0; c < channels; ++c) {
    std::vector<float>& values = image.add(spec.channel_name(int(c))).values;
    for (int y = 0; y < spec.height; ++y)
      for (int x = 0; x < spec.width; ++x) {
        const int u = x + spec.x - spec.full_x, v = y + spec.y - spec.full_y;
        if (u < 0 || v < 0 || u >= image.width || v >= image.height) continue;
        values[std::size_t(v) * image.width + u] =
            interleaved[(std::size_t(y) * spec.width + x) * channels + c];
      }
  }
  get_metadata(spec, image);
  linearise(spec, image);
  multiply_alpha(spec, image);
  return image;
}

}  // namespace plinian
