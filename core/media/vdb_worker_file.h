// A .vdb file as the worker reads it: its table of grids, and each grid on demand.
//
// OpenVDB's own io::File leaves its stream's errors to be noticed later, which on a truncated or damaged file
// means loops of up to 2^32 turns over nothing. Here the stream throws at the first short read, and every
// offset of the table is checked before it is followed. What a grid holds is still parsed by OpenVDB, through
// io::Archive.
#pragma once

#include <openvdb/io/Archive.h>
#include <openvdb/openvdb.h>

#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace plinian::vdb {

/// Bad input, in one line without the file's name.
struct BadFile : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A line of the table of grids.
struct GridEntry {
  std::string unique_name;  // as stored: the name, and a number where the name is not unique
  std::string name;         // without that number
  int index = 0;            // among the grids of that name
  int siblings = 1;         // how many have that name
  std::string type;         // OpenVDB's: "Tree_float_5_4_3"
  bool half = false;        // floats are stored as halves
  std::string parent;       // unique name of the grid whose tree it shares, or empty
  std::int64_t grid_at = 0, blocks_at = 0, end_at = 0;  // [bytes] from the start of the file

  /// As a user picks it: "density", or "density[1]" where several have that name.
  std::string label() const { return siblings > 1 ? name + "[" + std::to_string(index) + "]" : name; }
  /// "float", "half", "vec3s", ... : the value type in the tree's name.
  std::string value_type() const;
};

class VdbFile : private openvdb::io::Archive {
 public:
  /// progress: called now and then with the share of the file that has been read.
  VdbFile(const std::string& path, std::function<void(double)> progress);
  ~VdbFile() override;

  const std::vector<GridEntry>& entries() const { return entries_; }
  const openvdb::MetaMap& metadata() const { return metadata_; }
  using Archive::fileVersion;
  using Archive::libraryVersion;

  /// The grid with its tree.
  openvdb::GridBase::Ptr read(const GridEntry& entry);
  /// The grid with its metadata and transform, and an empty tree.
  openvdb::GridBase::Ptr read_header(const GridEntry& entry);

 private:
  class Buffer;
  void read_table();
  GridEntry read_entry();
  openvdb::GridBase::Ptr create(const GridEntry& entry) const;
  openvdb::GridBase::Ptr read_tree(const GridEntry& entry);
  /// Runs f, turning what it throws into a BadFile that says where.
  template <class F>
  auto guarded(const std::string& where, F&& f);

  std::unique_ptr<Buffer> buffer_;
  std::istream stream_;
  std::int64_t size_ = 0;
  openvdb::io::StreamMetadata::Ptr stream_metadata_;
  openvdb::MetaMap metadata_;
  std::vector<GridEntry> entries_;
  std::map<std::string, openvdb::GridBase::Ptr> sequential_;  // of a file without offsets: all its grids
};

}  // namespace plinian::vdb
