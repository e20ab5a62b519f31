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
  // Each edit costs its own work on a renderer, by the counters of a picture after it less those of one
  // before: maps built, volumes uploaded. `uploads`: of a changed volume.
  void expect_edits_cost_their_own_work(const std::string& renderer, const std::string& resolution,
                                        const std::string& size, int uploads) {
    const auto expect_costs = [&](const std::string& what, int maps, int volumes) {
      SCOPED_TRACE(what);
      const Ended ended = run({"render", "explosion", "--resolution", resolution, "--renderer", renderer,
                               "--size", size, "--passes", "1", "--set", "map.resolution=64", "--sheet",
                               "v.png", "--quiet", "--json", "--vary", what});
      ASSERT_EQ(ended.code, 0) << ended.err;
      const nlohmann::json report = nlohmann::json::parse(ended.out);
      const nlohmann::json &first = report["variants"][0], &second = report["variants"][1];
      EXPECT_NE(first["scene_hash"], second["scene_hash"]) << "nothing was varied";
      EXPECT_EQ(second["map_builds"].get<int>() - first["map_builds"].get<int>(), maps);
      EXPECT_EQ(second["volume_uploads"].get<int>() - first["volume_uploads"].get<int>(), volumes);
    };
    for (const char* free : {"medium.albedo=0.3,0.6", "medium.g=0.1,0.5", "key.exposure=0,1",
                             "camera.translate.x=1,2", "medium.emission_scale=1,2"})
      expect_costs(free, 0, 0);
    expect_costs("medium.density_scale=5,9", 2, 0);  // two lights
    expect_costs("key.rotate.y=10,40", 1, 0);
    expect_costs("medium_noise.seed=1,2", 2, uploads);
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
