// What tests of the commands share: a folder to work in, and looks at what was written.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/image/image_io.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/cli/program.h"

namespace plinian {

class Program : public testing::Test {
 protected:
  Ended run(const std::vector<std::string>& arguments, RunOptions options = {}) {
    options.folder = folder_.path().string();
    return plinian_program(arguments, options);
  }
  Ended render(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"--renderer", "cpu", "--samples", "1", "--size", "48x32"});
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended;
  }
  Image picture(const std::string& name) { return read_image(folder_ / name); }
  std::string text_fact(const Image& image, const char* name) {
    const auto found = image.metadata.find(name);
    return found == image.metadata.end() ? "(missing)" : std::get<std::string>(found->second);
  }

  TemporaryFolder folder_;
};

// Ctrl-C during the passes of a picture that would take hours; what there is gets written, and one line says
// so.
inline void expect_ctrl_c_keeps_the_picture(const Ended& ended, const Image& image) {
  EXPECT_EQ(ended.code, 130);
  const std::size_t line = ended.err.find("warning: interrupted: a.exr holds what ");
  ASSERT_NE(line, std::string::npos) << ended.err;
  EXPECT_EQ(ended.err.find("interrupted", line + 22), std::string::npos);
  EXPECT_NE(ended.err.find(" of 60000 passes gave", line), std::string::npos) << ended.err;
  const int passes = std::get<int>(image.metadata.at(attribute::passes));
  EXPECT_GE(passes, 1);
  EXPECT_LT(passes, 60000);
}

inline double mean_of(const Image& image, const std::string& channel) {
  double sum = 0.0;
  for (const float value : image.find(channel)->values) sum += value;
  return sum / double(image.pixel_count());
}

// What a variation costs, by the counters of its second picture less those of its first.
inline void expect_costs(const nlohmann::json& report, int maps, int uploads) {
  const nlohmann::json &first = report["variants"][0], &second = report["variants"][1];
  EXPECT_NE(first["scene_hash"], second["scene_hash"]) << "nothing was varied";
  EXPECT_EQ(second["map_builds"].get<int>() - first["map_builds"].get<int>(), maps);
  EXPECT_EQ(second["volume_uploads"].get<int>() - first["volume_uploads"].get<int>(), uploads);
}

// The shape that scripts rely on.
inline void expect_bench_shape(const nlohmann::json& report, const std::string& renderer) {
  for (const char* preset : {"fast", "high"})
    for (const char* key : {"map_build_ms", "orbit_frame_ms", "albedo_edit_ms", "extinction_edit_ms",
                            "light_edit_ms", "frame_change_ms", "volume_bytes", "map_bytes"})
      EXPECT_TRUE(report["renderers"][renderer][preset][key].is_number()) << preset << "." << key;
  EXPECT_TRUE(report["ratios"].is_object());
  EXPECT_EQ(report["size"], nlohmann::json({32, 32}));
  // Neither an orbit nor an albedo edit costs a map; what changes the light's way through the medium does.
  for (const char* preset : {"fast", "high"}) {
    const nlohmann::json& builds = report["map_builds"][renderer][preset];
    EXPECT_EQ(builds["orbit_frame"], 0);
    EXPECT_EQ(builds["albedo_edit"], 0);
    EXPECT_GT(builds["extinction_edit"].get<int>(), 0);
    EXPECT_GT(builds["light_edit"].get<int>(), 0);
    EXPECT_GT(builds["frame_change"].get<int>(), 0);
  }
}

}  // namespace plinian
