// The module that reads and writes picture files with OpenImageIO; see image_files.h. It links nothing of
// ours.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/image/image_files.h"

namespace plinian {
namespace {

using Metadata = std::map<std::string, Attribute>;

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

void set_metadata(OIIO::ImageSpec& spec, const Metadata& metadata) {
  for (const auto& [key, value] : metadata) {
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

Metadata get_metadata(const OIIO::ImageSpec& spec) {
  Metadata metadata;
  for (const OIIO::ParamValue& value : spec.extra_attribs) {
    std::string name = value.name().string();
    if (name.starts_with("oiio:")) continue;
    for (const AttributeName& pair : renamed)
      if (name == pair.oiio) name = pair.ours;
    if (value.type() == OIIO::TypeInt) metadata[name] = value.get_int();
    if (value.type() == OIIO::TypeFloat) metadata[name] = value.get_float();
    if (value.type() == OIIO::TypeString) metadata[name] = value.get_string();
    if (value.type() == OIIO::TypeMatrix) {
      mat4 matrix;
      std::memcpy(&matrix[0][0], value.data(), 16 * sizeof(float));
      metadata[name] = matrix;
    }
  }
  return metadata;
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
  set_metadata(spec, image.metadata);
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

PictureFile read(const std::string& path) {
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

  PictureFile file{.width = spec.width,
                   .height = spec.height,
                   .left = spec.x - spec.full_x,
                   .top = spec.y - spec.full_y,
                   .full_width = spec.full_width,
                   .full_height = spec.full_height};
  for (int c = 0; c < spec.nchannels; ++c) file.channels.push_back(spec.channel_name(c));
  file.values.resize(std::size_t(spec.image_pixels()) * file.channels.size());
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, file.values.data()))
    throw ImageError(path + ": is damaged: " + one_line(input->geterror()));
  file.metadata = get_metadata(spec);
  file.colour_space = spec.get_string_attribute("oiio:ColorSpace");
  for (char& c : file.colour_space) c = char(std::tolower(static_cast<unsigned char>(c)));
  file.gamma = spec.get_float_attribute("oiio:Gamma", 0.0f);
  file.alpha = spec.alpha_channel;
  file.integer = spec.format.basetype != OIIO::TypeDesc::HALF &&
                 spec.format.basetype != OIIO::TypeDesc::FLOAT &&
                 spec.format.basetype != OIIO::TypeDesc::DOUBLE;
  file.unassociated_alpha = spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
  return file;
}

// The first of those that common systems bring.
std::string find_font(int size) {
  for (const char* font :
       {"DejaVuSans", "NotoSans-Regular", "LiberationSans-Regular", "FreeSans", "DroidSans", "Arial"})
    if (OIIO::ImageBufAlgo::text_size("x", size, font).defined()) return font;
  OIIO::geterror();  // clears what the search left behind
  return "";
}

void draw_labels(std::vector<std::uint8_t>& rgb, int width, int height, const std::vector<Label>& labels,
                 const std::string& font, int size, float grey) {
  OIIO::ImageBuf canvas(OIIO::ImageSpec(width, height, 3, OIIO::TypeUInt8), rgb.data());
  for (const Label& label : labels)
    OIIO::ImageBufAlgo::render_text(canvas, label.x, label.y, label.text, size, font, {grey, grey, grey});
}

}  // namespace
}  // namespace plinian

extern "C" __attribute__((visibility("default")))
const plinian::ImageFiles plinian_image_files = {PLINIAN_IMAGE_FILES_VERSION, plinian::encode_exr,
                                                 plinian::read, plinian::find_font, plinian::draw_labels};
