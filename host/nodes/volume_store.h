// Volumes that were read and are still held by somebody: a file is parsed once, however many read it, and
// frames that hold the same voxels are one volume, so that they are uploaded once.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/media/vdb_reader.h"

namespace plinian::nodes {

/// What tells one state of a file from another.
struct FileStamp {
  std::int64_t modified_ns = 0;  // since the epoch
  std::uint64_t bytes = 0, inode = 0;
  bool operator==(const FileStamp&) const = default;
};

/// Zeros where there is no such file.
FileStamp stamp_of(const std::string& path);

/// Safe to use from several threads. Holds nothing alive.
class VolumeStore {
 public:
  struct Read {
    std::shared_ptr<const VdbVolume> file;
    std::uint64_t content = 0;  // volume_hash of its voxels
  };
  /// Reads a file, or hands out what is held of it. key: the options, as text. Throws VdbError,
  /// VdbCancelled.
  Read read(const std::string& path, const VdbOptions& options, const std::string& key);

  /// Files that are held and have changed on the disk since they were read.
  std::vector<std::string> changed_files();
  std::uint64_t reads() const;  // files parsed, ever

 private:
  struct Entry {
    std::mutex reading;  // held while the file is parsed, so that others wait for it
    std::string path;
    FileStamp stamp;
    std::weak_ptr<const VdbVolume> file;
    std::uint64_t content = 0;
  };
  std::shared_ptr<const BrickVolume> shared(std::shared_ptr<const BrickVolume> volume, std::uint64_t content);

  mutable std::mutex mutex_;  // guards what follows
  std::map<std::string, std::shared_ptr<Entry>> entries_;
  std::map<std::uint64_t, std::weak_ptr<const BrickVolume>> by_content_;
  std::uint64_t reads_ = 0;
};

}  // namespace plinian::nodes
