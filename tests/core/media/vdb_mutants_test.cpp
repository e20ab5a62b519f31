// Damaged copies of real files: each ends in a volume or one error line, soon, and the program that reads
// lives.
#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <random>
#include <thread>

#include "core/media/density_scale.h"
#include "core/media/vdb_reader.h"
#include "tests/core/media/vdb_test_files.h"

namespace plinian {
namespace {

constexpr int mutant_count = 500;

/// Cut at a random place, or 1 to 64 bits flipped: half of the time near the start, where the structure is.
std::string mutate(std::string bytes, std::mt19937& random) {
  if (random() % 3 == 0) {
    bytes.resize(random() % bytes.size());
    return bytes;
  }
  const std::size_t region = random() % 2 ? std::min<std::size_t>(bytes.size(), 4096) : bytes.size();
  for (int flips = 1 << random() % 7; flips > 0; --flips) bytes[random() % region] ^= char(1 << random() % 8);
  return bytes;
}

/// [MiB] the most memory that this process has had.
long peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::atol(line.c_str() + 6) / 1024;
  return -1;
}

TEST(VdbMutants, EndWithAVolumeOrOneLineAndNeverTakeTheProgramDown) {
  PLINIAN_NEEDS_REAL_FILES();
  std::vector<std::string> originals;
  for (const auto& entry : std::filesystem::directory_iterator(real_file("")))
    if (entry.path().extension() == ".vdb") originals.push_back(entry.path().filename().string());
  std::sort(originals.begin(), originals.end());
  std::vector<std::string> contents;
  for (const std::string& name : originals) contents.push_back(read_bytes(real_file(name)));

  Folder folder;
  std::mutex mutex;
  int next = 0, volumes = 0, lines = 0;
  double longest = 0.0;
  const auto work = [&] {
    for (;;) {
      int number;
      {
        const std::lock_guard lock(mutex);
        if (next == mutant_count) return;
        number = next++;
      }
      const std::size_t which = std::size_t(number) % originals.size();
      std::mt19937 random(unsigned(number) + 1);
      const std::string path = folder / (std::to_string(number) + ".vdb");
      write_bytes(path, mutate(contents[which], random));
      VdbOptions
          options;  // limits are the automatic ones; a choice makes as many files as can be go all the way
      if (originals[which] == "grids.vdb") options.grid = "density[*]";
      options.level_set = LevelSetMode::fog;
      options.frustum = FrustumMode::resample;
      const auto begin = std::chrono::steady_clock::now();
      std::string line;
      try {
        const VdbVolume read = read_vdb(path, options);
        const float scale = automatic_density_scale(*read.volume, dmat4(1.0));
        EXPECT_TRUE(std::isfinite(scale) && scale > 0.0f) << path;
        EXPECT_TRUE(std::isfinite(read.volume->density_max)) << path;
      } catch (const VdbError& error) {
        line = error.what();
      }
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      if (!line.empty()) expect_line(line, path, {});
      EXPECT_LT(seconds, 15.0) << originals[which] << " " << number << " " << line;
      std::filesystem::remove(path);
      const std::lock_guard lock(mutex);
      ++(line.empty() ? volumes : lines);
      longest = std::max(longest, seconds);
    }
  };
  std::thread first(work), second(work);
  first.join();
  second.join();
  EXPECT_EQ(volumes + lines, mutant_count);
  EXPECT_GT(volumes, mutant_count / 20);  // flips in voxels still give a picture
  EXPECT_GT(lines, mutant_count / 4);
  EXPECT_LT(peak_memory(), 1024);
  RecordProperty("longest_seconds", std::to_string(longest));
  std::printf("%d volumes, %d error lines; longest %.1f s, peak memory %ld MiB\n", volumes, lines, longest,
              peak_memory());
}

}  // namespace
}  // namespace plinian
