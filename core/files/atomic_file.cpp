#include "core/files/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace plinian {
namespace {

namespace fs = std::filesystem;

// A file of its own beside the target; gone when it goes out of scope, unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    std::string stem = ".";
    stem += target.filename().string().substr(0, 200) + "." + std::to_string(::getpid()) + ".";
    do {
      path_ =
          target.parent_path() / (stem + std::to_string(counter++) + ".tmp" + target.extension().string());
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) path_.clear();
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  bool is_open() const { return descriptor_ >= 0; }
  const fs::path& path() const { return path_; }
  // These return false with errno set.
  bool write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes = bytes.subspan(std::size_t(written));
    }
    return true;
  }
  bool sync() { return ::fsync(descriptor_) == 0; }
  bool rename_over(const fs::path& target) {
    struct stat existing;
    if (::stat(target.c_str(), &existing) == 0) ::fchmod(descriptor_, existing.st_mode & 07777);
    // Some file systems report a full disk only here.
    const bool closed = ::close(descriptor_) == 0;
    descriptor_ = -1;
    if (!closed || ::rename(path_.c_str(), target.c_str()) != 0) return false;
    path_.clear();
    return true;
  }

 private:
  fs::path path_;
  int descriptor_ = -1;
};

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw FileError(path + ": cannot be written: " + reason);
}

// Where the bytes go in the end: a link is followed, so that it stays one.
fs::path resolve_target(const std::string& path) {
  if (path.empty()) throw FileError("output: the file name is empty");
  std::error_code error;
  fs::path target = fs::absolute(path, error);
  if (!target.has_filename() || fs::is_directory(target, error)) fail(path, "it is a folder");
  for (int links = 0; fs::is_symlink(target, error); ++links) {
    if (links == 40) fail(path, "its links go in a circle");
    const fs::path next = fs::read_symlink(target, error);
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status)) {
    if (!fs::is_regular_file(status)) fail(path, "it is not a plain file");
    if (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) fail(path, std::strerror(errno));
  }
  const fs::path folder = target.parent_path();
  if (!fs::exists(folder, error)) fail(path, "the folder " + folder.string() + " does not exist");
  if (!fs::is_directory(folder, error)) fail(path, folder.string() + " is not a folder");
  return target;
}

}  // namespace

void check_writable(const std::string& path) {
  const fs::path target = resolve_target(path);
  // Asking for permissions misses read-only and virtual file systems; trying does not.
  if (!TemporaryFile(target).is_open())
    fail(path, "no file can be made in " + target.parent_path().string() + ": " + std::strerror(errno));
}

namespace {

// write: fills the temporary file; false with errno set where it could not.
template <class Write>
void write_whole(const std::string& path, Write write) {
  const fs::path target = resolve_target(path);
  TemporaryFile file(target);
  if (!file.is_open())
    fail(path, "no file can be made in " + target.parent_path().string() + ": " + std::strerror(errno));
  if (!write(file) || !file.rename_over(target)) fail(path, std::strerror(errno));
}

}  // namespace

void write_file(const std::string& path, std::span<const std::uint8_t> bytes) {
  write_whole(path, [&](TemporaryFile& file) { return file.write(bytes); });
}

void write_file(const std::string& path, const std::function<void(const std::string&)>& fill) {
  write_whole(path, [&](TemporaryFile& file) {
    fill(file.path().string());
    return true;
  });
}

namespace {

// Gives the file a second name, `path`.bak, without a moment in which there is neither an old nor a new
// backup.
void keep_backup(const fs::path& target) {
  if (::access(target.c_str(), F_OK) != 0) return;
  const fs::path backup = target.string() + ".bak";
  std::string name = ".";
  name += target.filename().string().substr(0, 200) + "." + std::to_string(::getpid()) + ".bak.tmp";
  const fs::path link = target.parent_path() / name;
  ::unlink(link.c_str());
  std::error_code error;
  if (::link(target.c_str(), link.c_str()) != 0)  // a file system without links
    fs::copy_file(target, link, fs::copy_options::overwrite_existing, error);
  if (error || ::rename(link.c_str(), backup.c_str()) != 0) {
    const std::string reason = error ? error.message() : std::strerror(errno);
    ::unlink(link.c_str());
    fail(backup.string(), reason);
  }
  ::unlink(link.c_str());  // still there where it was the backup already
}

}  // namespace

void write_file_durably(const std::string& path, std::string_view text) {
  fs::path folder;
  write_whole(path, [&](TemporaryFile& file) {
    folder = file.path().parent_path();
    if (!file.write(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size())) ||
        !file.sync())
      return false;
    keep_backup(resolve_target(path));
    return true;
  });
  // The new name is on the disk once the folder is.
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

void write_file(const std::string& path, std::string_view text) {
  write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

}  // namespace plinian
