#include "core/image/compare_report.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>

#include "core/image/image_io.h"
#include "tests/core/image/temporary_folder.h"

namespace plinian {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

std::vector<std::uint8_t> from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t word = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    word = word << 6 | std::uint32_t(digits.find(c));
    bits += 6;
    if (bits >= 8) bytes.push_back(std::uint8_t(word >> (bits -= 8) & 255u));
  }
  return bytes;
}

struct Pictures {
  Image a = make_image(37, 23, vec3(0.2f, 0.4f, 0.6f)),
        reference = make_image(37, 23, vec3(0.2f, 0.4f, 0.5f));
};

TEST(CompareReport, IsOneFileThatNeedsNothingElse) {
  const Pictures p;
  const std::string html =
      compare_report(p.a, p.reference, compare_images(p.a, p.reference), {"a.exr", "b.exr", {}});
  EXPECT_EQ(html.find("http"), std::string::npos);
  EXPECT_EQ(html.find("{{"), std::string::npos);
  EXPECT_EQ(html.find("@import"), std::string::npos);
  // Two pictures and a FLIP map at two exposures each, and the error map.
  EXPECT_EQ(count(html, "src=\"data:image/png;base64,"), 7u);
  EXPECT_EQ(count(html, "src="), 7u);
  for (const char* part :
       {"PSNR", "SSIM", "FLIP at +3 stops", "Largest error", "role=\"slider\"", "aria-valuenow"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

TEST(CompareReport, ThePicturesInItAreThePicturesThroughTheView) {
  const Pictures p;
  const std::string html =
      compare_report(p.a, p.reference, compare_images(p.a, p.reference), {"a.exr", "b.exr", {}});
  const std::string marker = "alt=\"a.exr at +3 stops\" src=\"data:image/png;base64,";
  const std::size_t begin = html.find(marker) + marker.size();
  ASSERT_NE(html.find(marker), std::string::npos);
  const std::vector<std::uint8_t> png = from_base64(html.substr(begin, html.find('"', begin) - begin));
  const TemporaryFolder folder;
  write_file(folder / "a.png", png);
  const Image read = read_image(folder / "a.png");
  EXPECT_EQ(read.width, 37);
  EXPECT_EQ(read.height, 23);
  EXPECT_EQ(colour_of(read)[0], vec3(1.0f)) << "0.2 three stops up is clipped by the sRGB view";
}

TEST(CompareReport, ShowsCommandLinesAndFactsAndHidesNoMarkup) {
  Pictures p;
  p.a.metadata[attribute::command] = std::string("plinian render 'a<b>&\"c\"' --set {{x}}=1");
  p.a.metadata[attribute::preset] = std::string("<script>alert(1)</script>");
  p.a.metadata[std::string(attribute::time_prefix) + "view"] = 12.34f;
  const std::string html =
      compare_report(p.a, p.reference, compare_images(p.a, p.reference), {"<i>a</i>.exr", "b.exr", {}});
  EXPECT_NE(html.find("plinian render &#39;a&lt;b&gt;&amp;&quot;c&quot;&#39; --set {{x}}=1"),
            std::string::npos);
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_EQ(html.find("<i>a"), std::string::npos);
  EXPECT_NE(html.find("<dt>time of view</dt><dd>12.3 ms</dd>"), std::string::npos);
  EXPECT_EQ(count(html, "does not record the command line"), 1u);
}

TEST(CompareReport, SaysWhetherTheLimitsHold) {
  const Pictures p;
  const CompareResult result = compare_images(p.a, p.reference);
  EXPECT_EQ(compare_report(p.a, p.reference, result, {"a", "b", {}}).find("limits</div>"), std::string::npos);
  EXPECT_NE(compare_report(p.a, p.reference, result, {"a", "b", {{"psnr", 10.0}}}).find("Keeps its limits"),
            std::string::npos);
  const std::string failing = compare_report(p.a, p.reference, result, {"a", "b", {{"psnr", 99.0}}});
  EXPECT_NE(failing.find("Fails its limits"), std::string::npos);
  EXPECT_NE(failing.find("is under 99"), std::string::npos);
}

TEST(CompareReport, PixelsThatAreNotFiniteAreShownNotFatal) {
  Pictures p;
  p.a.find("R")->values[0] = std::numeric_limits<float>::quiet_NaN();
  p.a.find("R")->values[1] = std::numeric_limits<float>::infinity();
  const std::string html = compare_report(p.a, p.reference, compare_images(p.a, p.reference), {"a", "b", {}});
  EXPECT_NE(html.find("cyan is not finite"), std::string::npos);
  for (const char* bad : {">nan", "nan dB", "nan%", ">inf", "inf dB"})
    EXPECT_EQ(html.find(bad), std::string::npos) << bad;
}

TEST(CompareReport, IsWrittenWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const Pictures p;
  const CompareResult result = compare_images(p.a, p.reference);
  write_compare_report(folder / "r.html", p.a, p.reference, result, {"a", "b", {}});
  std::ifstream file(folder / "r.html");
  const std::string html{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(html.substr(0, 15), "<!DOCTYPE html>");
  EXPECT_EQ(html.substr(html.size() - 8), "</html>\n");
  EXPECT_THROW(write_compare_report(folder / "no/r.html", p.a, p.reference, result, {"a", "b", {}}),
               FileError);
  EXPECT_EQ(folder.entries(), 1u);
}

}  // namespace
}  // namespace plinian
