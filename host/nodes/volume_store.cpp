// Sharing of volumes by file and by content.
#include "host/nodes/volume_store.h"

#include <sys/stat.h>

#include <algorithm>

#include "core/scene/scene_hash.h"

namespace plinian::nodes {

FileStamp stamp_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return {};
  return {std::int64_t(status.st_mtim.tv_sec) * 1'000'000'000 + status.st_mtim.tv_nsec,
          std::uint64_t(status.st_size), std::uint64_t(status.st_ino)};
}

VolumeStore::Read VolumeStore::read(const std::string& path, const VdbOptions& options,
                                    const std::string& key) {
  std::shared_ptr<Entry> entry;
  {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<Entry>& found = entries_[path + '\n' + key];
    if (!found) found = std::make_shared<Entry>();
    entry = found;
  }
  const std::lock_guard reading(entry->reading);
  const FileStamp stamp = stamp_of(path);
  if (auto held = entry->file.lock(); held && entry->stamp == stamp) return {held, entry->content};
  VdbVolume file = read_vdb(path, options);
  const std::uint64_t content = volume_hash(*file.volume);
  file.volume = shared(std::move(file.volume), content);
  const auto result = std::make_shared<const VdbVolume>(std::move(file));
  const std::lock_guard lock(mutex_);
  ++reads_;
  entry->path = path;
  entry->stamp = stamp;
  entry->file = result;
  entry->content = content;
  return {result, content};
}

std::shared_ptr<const BrickVolume> VolumeStore::shared(std::shared_ptr<const BrickVolume> volume,
                                                       std::uint64_t content) {
  const std::lock_guard lock(mutex_);
  std::erase_if(by_content_, [](const auto& entry) { return entry.second.expired(); });
  std::weak_ptr<const BrickVolume>& known = by_content_[content];
  const auto other = known.lock();
  // A hash may meet another by chance, so the voxels have the last word.
  if (other && other->density == volume->density && other->temperature == volume->temperature &&
      other->root == volume->root && other->nodes == volume->nodes && other->origin == volume->origin &&
      other->density_max == volume->density_max && other->temperature_max == volume->temperature_max &&
      other->medium_from_index == volume->medium_from_index)
    return other;
  known = volume;
  return volume;
}

std::vector<std::string> VolumeStore::changed_files() {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> changed;
  for (const auto& [key, entry] : entries_)
    if (!entry->file.expired() && stamp_of(entry->path) != entry->stamp &&
        std::find(changed.begin(), changed.end(), entry->path) == changed.end())
      changed.push_back(entry->path);
  return changed;
}

std::uint64_t VolumeStore::reads() const {
  const std::lock_guard lock(mutex_);
  return reads_;
}

}  // namespace plinian::nodes
