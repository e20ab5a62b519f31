// .vdb files made on the spot for tests, with OpenVDB itself.
#pragma once

#include <gtest/gtest.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "core/media/vdb_reader.h"
#include "tests/core/media/real_files.h"

namespace plinian {

/// A folder that is gone after the test.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "plinian-test-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  std::size_t files() const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_)) ++count;
    return count;
  }

 private:
  std::string path_;
};

inline void save(const std::string& path, const openvdb::GridPtrVec& grids,
                 const openvdb::MetaMap& metadata = {}) {
  openvdb::initialize();
  openvdb::io::File(path).write(grids, metadata);
}

template <class Grid = openvdb::FloatGrid>
typename Grid::Ptr make_grid(const std::string& name, typename Grid::ValueType background = {}) {
  openvdb::initialize();
  auto grid = Grid::create(background);
  grid->setName(name);
  return grid;
}

/// One active voxel of value 1 at the origin.
inline openvdb::FloatGrid::Ptr dot(const std::string& name = "density", openvdb::Coord at = {0, 0, 0},
                                   float value = 1.0f) {
  auto grid = make_grid(name);
  grid->tree().setValue(at, value);
  return grid;
}

/// Rows as OpenVDB has them: the images of the index axes, then the origin.
inline openvdb::Mat4d matrix(const std::array<double, 16>& rows) {
  return openvdb::Mat4d(rows.data());
}

inline std::string read_bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// Replaces every occurrence of a double in a file; returns how many there were.
inline int patch_double(const std::string& path, double from, double to) {
  std::string bytes = read_bytes(path);
  const std::string old(reinterpret_cast<const char*>(&from), sizeof from),
      fresh(reinterpret_cast<const char*>(&to), sizeof to);
  int count = 0;
  for (std::size_t at = bytes.find(old); at != std::string::npos; at = bytes.find(old, at + 1), ++count)
    bytes.replace(at, old.size(), fresh);
  write_bytes(path, bytes);
  return count;
}

/// The message of the VdbError that f throws; a test failure where it throws none.
inline std::string error_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const VdbError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return {};
}

/// Expects one line that starts with the file and holds every one of the words.
inline void expect_line(const std::string& line, const std::string& path,
                        const std::vector<std::string>& words) {
  EXPECT_TRUE(line.starts_with(path + ": ")) << line;
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  for (const std::string& word : words)
    EXPECT_NE(line.find(word), std::string::npos) << "\"" << word << "\" in: " << line;
}

inline std::int64_t count_of(const VdbFacts& facts, const std::string& kind) {
  for (const VdbWarning& warning : facts.warnings)
    if (warning.kind == kind) return warning.count;
  return 0;
}

inline bool says(const VdbFacts& facts, const std::string& words) {
  for (const std::string& note : facts.notes)
    if (note.find(words) != std::string::npos) return true;
  return false;
}

}  // namespace plinian
