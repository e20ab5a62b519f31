#include "core/image/contact_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/image/temporary_folder.h"

namespace plinian {
namespace {

SheetPicture flat(int width, int height, std::uint8_t level, const std::string& label = "") {
  return {width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 3, level),
          label};
}

std::uint8_t at(const SheetPicture& sheet, int x, int y) {
  return sheet.rgb[(std::size_t(y) * std::size_t(sheet.width) + std::size_t(x)) * 3];
}

TEST(ContactSheet, PicturesLieInRowsOfCells) {
  const SheetPicture sheet = contact_sheet({flat(10, 8, 200), flat(6, 8, 100), flat(10, 4, 50)}, 2, 3);
  EXPECT_EQ(sheet.width, 3 + 2 * 13);
  EXPECT_EQ(sheet.height, 3 + 2 * 11);
  EXPECT_EQ(at(sheet, 3, 3), 200);
  EXPECT_EQ(at(sheet, 12, 10), 200);
  EXPECT_EQ(at(sheet, 13, 10), 43) << "the gap";
  EXPECT_EQ(at(sheet, 16, 3), 100);
  EXPECT_EQ(at(sheet, 22, 3), 43) << "right of a narrower picture";
  EXPECT_EQ(at(sheet, 3, 14), 50);
  EXPECT_EQ(at(sheet, 16, 14), 43) << "an empty cell";
}

TEST(ContactSheet, LabelsAreWrittenUnderThePictures) {
  const SheetPicture plain = contact_sheet({flat(120, 20, 0)}, 1, 4);
  const SheetPicture sheet = contact_sheet({flat(120, 20, 0, "ATFM 6 · 38.2 dB")}, 1, 4);
  if (sheet.height == plain.height) GTEST_SKIP() << "no font that OpenImageIO finds on this system";
  const auto first_label_row = sheet.rgb.begin() + 3 * 24 * sheet.width;
  EXPECT_GT(*std::max_element(first_label_row, sheet.rgb.end()), 180) << "bright text";
  EXPECT_TRUE(std::equal(plain.rgb.begin(), plain.rgb.begin() + 3 * 24 * plain.width, sheet.rgb.begin()));
}

TEST(ContactSheet, ALabelThatIsTooWideTakesAsManyLinesAsItNeeds) {
  const std::string label = "albedo 0.3, emission_exposure 2, colour 1 0.2 0.3";
  const SheetPicture one = contact_sheet({flat(600, 20, 0, label)}, 1, 4);
  if (one.height == 28) GTEST_SKIP() << "no font that OpenImageIO finds on this system";
  const SheetPicture many = contact_sheet({flat(128, 20, 0, label)}, 1, 4);
  EXPECT_EQ(many.height - one.height, 4 * 22) << "at most 13 letters a line";
  // Nothing is lost: there is as much ink.
  const auto ink = [](const SheetPicture& sheet) {
    double sum = 0.0;
    for (int y = 24; y < sheet.height; ++y)
      for (int x = 0; x < sheet.width; ++x) sum += at(sheet, x, y) - 43.0;
    return sum;
  };
  EXPECT_NEAR(ink(many) / ink(one), 1.0, 0.1);
}

TEST(ContactSheet, APictureIsShownThroughItsView) {
  ViewSettings settings;
  settings.view = View::srgb;
  settings.exposure = 1.0f;
  const SheetPicture picture = sheet_picture(make_image(2, 2, vec3(0.25f)), ViewTransform(settings), "half");
  EXPECT_NEAR(picture.rgb[0], 188, 1);  // sRGB of 0.5 is 187.5
  EXPECT_EQ(picture.label, "half");
}

TEST(ContactSheet, BadInputIsAnError) {
  EXPECT_THROW(contact_sheet({}, 2), ImageError);
  EXPECT_THROW(contact_sheet({flat(2, 2, 0)}, 0), ImageError);
  SheetPicture broken = flat(2, 2, 0, "broken");
  broken.rgb.pop_back();
  EXPECT_NE(
      message_of<ImageError>([&] { contact_sheet({broken}, 1); }).find("'broken' does not hold its pixels"),
      std::string::npos);
}

}  // namespace
}  // namespace plinian
