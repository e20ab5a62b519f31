#include "tests/host/window/steps.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace plinian {

std::size_t wait_for_rest(Sitting& sitting, std::size_t since) {
  const std::size_t rest = sitting.wait_for(
      [](const std::string& line) {
        return line.find(" picture ") != line.npos && line.find(" rest ") != line.npos &&
               line.find("passes 0") == line.npos;
      },
      since);
  sitting.wait_for(" still", rest);
  return rest;
}

void command(Sitting& sitting, const std::string& line) {
  sitting.click(sitting.middle("command line"));
  sitting.wait_for_keys("keys to a field");
  const std::size_t before = sitting.now();
  sitting.type(line);
  sitting.stroke("Return");
  sitting.wait_for("ran " + line.substr(0, line.find(' ')), before);
}

void leave_fields(Sitting& sitting, ivec2 nowhere) {
  sitting.click(nowhere);
  sitting.move(nowhere + ivec2(2, 0));  // the window looks again
  sitting.wait_for_keys("keys to the window");
}

double psnr_in(const std::string& line) {
  const std::size_t at = line.find("psnr ");
  return at == line.npos ? -1.0 : std::strtod(line.c_str() + at + 5, nullptr);
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

double psnr(const Pixels& a, const std::vector<std::uint8_t>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const double d = (double(a.rgb[i]) - double(b[i])) / 255.0;
    sum += d * d;
  }
  return sum > 0.0 ? 10.0 * std::log10(double(a.rgb.size()) / sum) : INFINITY;
}

}  // namespace plinian
