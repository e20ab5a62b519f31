#include "core/image/png_encoder.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <new>

#include "core/image/image.h"

namespace plinian {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::size_t pixel_bytes = 3;

void append_u32(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(std::uint8_t(value >> shift));
}

// Length, type, content, and a checksum of type and content [PNG 5.3].
void append_chunk(Bytes& file, const char (&type)[5], const std::uint8_t* content, std::size_t size) {
  append_u32(file, std::uint32_t(size));
  const std::size_t start = file.size();
  file.insert(file.end(), type, type + 4);
  file.insert(file.end(), content, content + size);
  append_u32(file, std::uint32_t(::crc32_z(0, file.data() + start, file.size() - start)));
}

void append_chunk(Bytes& file, const char (&type)[5], const Bytes& content) {
  append_chunk(file, type, content.data(), content.size());
}

// sRGB, and for readers that do not know it the same in numbers [PNG 11.3.3.5].
void append_colour_space(Bytes& file) {
  append_chunk(file, "sRGB", {0});  // perceptual
  Bytes gamma, primaries;
  append_u32(gamma, 45455);
  for (const std::uint32_t xy : {31270u, 32900u, 64000u, 33000u, 30000u, 60000u, 15000u, 6000u})
    append_u32(primaries, xy);
  append_chunk(file, "gAMA", gamma);
  append_chunk(file, "cHRM", primaries);
}

void append_text(Bytes& file, const std::string& key, const std::string& text) {
  const auto ascii = [](unsigned char c) { return c == '\n' || (c >= 0x20 && c < 0x7f); };
  if (key.empty() || key.size() > 79 || !std::all_of(key.begin(), key.end(), ascii)) return;
  Bytes content(key.begin(), key.end());
  const bool plain = std::all_of(text.begin(), text.end(), ascii);
  content.insert(content.end(), plain ? 1 : 5, 0);  // iTXt: not compressed, no language, no translated key
  // A zero would end the text.
  std::copy_if(text.begin(), text.end(), std::back_inserter(content), [](char c) { return c != 0; });
  plain ? append_chunk(file, "tEXt", content) : append_chunk(file, "iTXt", content);
}

int paeth(int left, int above, int corner) {
  const int estimate = left + above - corner;
  const int a = std::abs(estimate - left), b = std::abs(estimate - above), c = std::abs(estimate - corner);
  return a <= b && a <= c ? left : b <= c ? above : corner;
}

/// Turns rows into what deflate packs well: differences by one of five filters, the one with the smallest sum
/// of absolute differences [PNG 9.2, 12.8].
class RowFilter {
 public:
  explicit RowFilter(std::size_t row_bytes) : above_(row_bytes, 0) {
    for (Bytes& candidate : candidates_) candidate.resize(1 + row_bytes);
  }
  /// The filter's number and the filtered bytes; valid until the next call.
  const Bytes& operator()(const std::uint8_t* row) {
    std::array<std::uint64_t, 5> sums = {};
    for (std::size_t f = 0; f < 5; ++f) candidates_[f][0] = std::uint8_t(f);
    for (std::size_t i = 0; i < above_.size(); ++i) {
      const bool first = i < pixel_bytes;
      const int left = first ? 0 : row[i - pixel_bytes], corner = first ? 0 : above_[i - pixel_bytes];
      const int above = above_[i];
      const int predicted[5] = {0, left, above, (left + above) / 2, paeth(left, above, corner)};
      for (std::size_t f = 0; f < 5; ++f) {
        const auto difference = std::uint8_t(row[i] - predicted[f]);
        candidates_[f][1 + i] = difference;
        sums[f] += std::uint64_t(std::abs(int(std::int8_t(difference))));
      }
    }
    std::copy_n(row, above_.size(), above_.begin());
    return candidates_[std::size_t(std::min_element(sums.begin(), sums.end()) - sums.begin())];
  }

 private:
  Bytes above_;                      // the row before, unfiltered
  std::array<Bytes, 5> candidates_;  // none, sub, up, average, Paeth
};

class Deflate {
 public:
  Deflate() {
    if (::deflateInit(&stream_, 6) != Z_OK) throw std::bad_alloc();
  }
  Deflate(const Deflate&) = delete;
  Deflate& operator=(const Deflate&) = delete;
  ~Deflate() { ::deflateEnd(&stream_); }
  /// Packs bytes; whenever a buffer is full, and at the last call for what is left, it becomes a chunk.
  void operator()(const Bytes& bytes, bool last, Bytes& file) {
    stream_.next_in = const_cast<Bytef*>(bytes.data());
    stream_.avail_in = uInt(bytes.size());
    int state = Z_OK;
    do {
      stream_.next_out = packed_.data() + filled_;
      stream_.avail_out = uInt(packed_.size() - filled_);
      state = ::deflate(&stream_, last ? Z_FINISH : Z_NO_FLUSH);
      filled_ = packed_.size() - stream_.avail_out;
      if (filled_ == packed_.size() || state == Z_STREAM_END) {
        append_chunk(file, "IDAT", packed_.data(), filled_);
        filled_ = 0;
      }
    } while (last ? state != Z_STREAM_END : stream_.avail_in > 0);
  }

 private:
  z_stream stream_ = {};
  Bytes packed_ = Bytes(1 << 16);
  std::size_t filled_ = 0;
};

}  // namespace

std::vector<std::uint8_t> png_of(const std::vector<std::uint8_t>& rgb, int width, int height,
                                 const std::map<std::string, std::string>& text) {
  const std::size_t row_bytes = pixel_bytes * std::size_t(std::max(width, 0));
  if (width < 1 || height < 1 || rgb.size() != row_bytes * std::size_t(height))
    throw ImageError("picture: " + std::to_string(rgb.size()) + " bytes do not make " +
                     std::to_string(width) + "x" + std::to_string(height) + " pixels");
  Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  Bytes header;
  append_u32(header, std::uint32_t(width));
  append_u32(header, std::uint32_t(height));
  header.insert(header.end(), {8, 2, 0, 0, 0});  // 8 bits, colour, deflate, the five filters, not interlaced
  append_chunk(file, "IHDR", header);
  append_colour_space(file);
  for (const auto& [key, value] : text) append_text(file, key, value);
  RowFilter filtered(row_bytes);
  Deflate deflate;
  for (int y = 0; y < height; ++y)
    deflate(filtered(rgb.data() + std::size_t(y) * row_bytes), y + 1 == height, file);
  append_chunk(file, "IEND", {});
  return file;
}

}  // namespace plinian
