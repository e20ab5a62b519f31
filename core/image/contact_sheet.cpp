#include "core/image/contact_sheet.h"

#include <algorithm>

#include "core/image/image_files.h"

namespace plinian {
namespace {

constexpr int font_size = 17;        // [pixels]
constexpr int line_height = 22;      // [pixels] from one line of a label to the next
constexpr std::uint8_t ground = 43;  // [display] the neutral grey of the comparison report

// OpenImageIO 2.4 draws every byte of a UTF-8 character as a letter of its own.
std::string ascii(const std::string& text) {
  std::string plain;
  for (const unsigned char c : text) {
    if (c < 0x80) plain += char(c);
    if (c >= 0xc0) plain += '-';  // the first byte of a longer character
  }
  return plain;
}

// A label in lines that do not run into the next one: broken at spaces, and within a word where it is too
// long for a line. A letter is about 0.55 of the font's size wide.
std::vector<std::string> wrapped(const std::string& label, int width) {
  const auto room = std::size_t(std::max(1.0, width / (0.55 * font_size)));
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < label.size();) {
    std::size_t end = std::min(begin + room, label.size());
    if (end < label.size() && label[end] != ' ')
      if (const std::size_t space = label.rfind(' ', end); space != label.npos && space > begin) end = space;
    lines.push_back(label.substr(begin, end - begin));
    begin = label.find_first_not_of(' ', end);
    if (begin == label.npos) break;
  }
  return lines;
}

}  // namespace

SheetPicture sheet_picture(const Image& image, const ViewTransform& view, const std::string& label) {
  return {image.width, image.height, to_display_bytes(image, view), label};
}

SheetPicture contact_sheet(const std::vector<SheetPicture>& pictures, int columns, int gap) {
  if (pictures.empty() || columns < 1)
    throw ImageError("contact sheet: at least one picture and column is needed");
  int cell_width = 1, cell_height = 1;
  std::size_t lines = 0;
  for (const SheetPicture& picture : pictures) {
    if (picture.width < 1 || picture.height < 1 ||
        picture.rgb.size() != 3 * std::size_t(picture.width) * std::size_t(picture.height))
      throw ImageError("contact sheet: the picture '" + picture.label + "' does not hold its pixels");
    cell_width = std::max(cell_width, picture.width);
    cell_height = std::max(cell_height, picture.height);
  }
  std::vector<std::vector<std::string>> texts;
  for (const SheetPicture& picture : pictures) {
    texts.push_back(wrapped(ascii(picture.label), cell_width + gap / 2));
    lines = std::max(lines, texts.back().size());
  }
  const std::string font = lines > 0 ? image_files().find_font(font_size) : "";
  const int label_height = font.empty() ? 0 : 2 * font_size + int(lines - 1) * line_height;
  columns = std::min(columns, int(pictures.size()));
  const int rows = (int(pictures.size()) + columns - 1) / columns;

  SheetPicture sheet;
  sheet.width = gap + columns * (cell_width + gap);
  sheet.height = gap + rows * (cell_height + label_height + gap);
  sheet.rgb.assign(3 * std::size_t(sheet.width) * std::size_t(sheet.height), ground);
  std::vector<Label> labels;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const SheetPicture& picture = pictures[i];
    const int left = gap + int(i) % columns * (cell_width + gap);
    const int top = gap + int(i) / columns * (cell_height + label_height + gap);
    for (int y = 0; y < picture.height; ++y)
      std::copy_n(picture.rgb.begin() + std::ptrdiff_t(y) * picture.width * 3, picture.width * 3,
                  sheet.rgb.begin() + (std::ptrdiff_t(top + y) * sheet.width + left) * 3);
    if (font.empty()) continue;
    for (std::size_t line = 0; line < texts[i].size(); ++line)
      labels.push_back(
          {left, top + cell_height + font_size + font_size / 3 + int(line) * line_height, texts[i][line]});
  }
  if (!labels.empty())
    image_files().draw_labels(sheet.rgb, sheet.width, sheet.height, labels, font, font_size, 0.87f);
  return sheet;
}

}  // namespace plinian
