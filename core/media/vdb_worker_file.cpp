// Parsing of a .vdb file's frame. See vdb_worker_file.h.
#include "core/media/vdb_worker_file.h"

#include <algorithm>
#include <cstring>

namespace plinian::vdb {
namespace {

constexpr std::int64_t magic = 0x56444220;
constexpr std::uint32_t version_of_instancing = 216;  // file format since which grids may share trees
constexpr const char* half_suffix = "_HalfFloat";

/// What is wrong with the bytes at hand; guarded() says where.
struct Damage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class T>
T read_number(std::istream& stream) {
  T value{};
  stream.read(reinterpret_cast<char*>(&value), sizeof value);
  return value;
}

std::string read_string(std::istream& stream) {
  const auto length = read_number<std::uint32_t>(stream);
  if (length > 1u << 16) throw Damage("a name of " + std::to_string(length) + " bytes");
  std::string text(length, '\0');
  stream.read(text.data(), length);
  return text;
}

/// OpenVDB's own words, without the class of the exception in front.
std::string plain(const char* what) {
  std::string text = what;
  if (const auto colon = text.find("Error: "); colon != std::string::npos && colon < 20)
    text.erase(0, colon + 7);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

std::string GridEntry::value_type() const {
  std::string value = type;
  if (value.starts_with("Tree_")) value.erase(0, 5);
  // "float_5_4_3": what follows the first underscore and a digit is the shape of the tree.
  for (std::size_t i = 0; i + 1 < value.size(); ++i)
    if (value[i] == '_' && value[i + 1] >= '0' && value[i + 1] <= '9') {
      value.erase(i);
      break;
    }
  return half && value == "float" ? "half" : value;
}

/// A file buffer that tells how far it has been read, and refuses reads of impossible length: OpenVDB reads
/// as many bytes as a damaged chunk says and only then compares with the room that it has.
class VdbFile::Buffer : public std::filebuf {
 public:
  explicit Buffer(std::function<void(double)> progress) : progress_(std::move(progress)), chunk_(1 << 18) {
    pubsetbuf(chunk_.data(), static_cast<std::streamsize>(chunk_.size()));
  }
  void set_size(std::int64_t size) { size_ = size; }
  bool refused() const { return refused_; }

 protected:
  std::streamsize xsgetn(char* to, std::streamsize count) override {
    // The values of an internal node of vectors of doubles are the longest honest read, 768 KiB.
    if (count > std::min<std::int64_t>(size_, 4 << 20)) {
      refused_ = true;
      return 0;
    }
    read_ += count;
    if (progress_ && size_ > 0 && read_ >= next_) {
      next_ = read_ + size_ / 64 + 1;
      progress_(std::min(1.0, double(read_) / double(size_)));
    }
    return std::filebuf::xsgetn(to, count);
  }

 private:
  std::function<void(double)> progress_;
  std::vector<char> chunk_;
  std::int64_t size_ = 0, read_ = 0, next_ = 0;
  bool refused_ = false;
};

template <class F>
auto VdbFile::guarded(const std::string& where, F&& f) {
  try {
    return f();
  } catch (const std::ios_base::failure&) {
    throw BadFile(buffer_->refused() ? "the file is damaged: " + where + ": an impossible length"
                                     : "the file is damaged: it ends in the middle of " + where);
  } catch (const Damage& error) {
    throw BadFile("the file is damaged: " + where + ": " + error.what());
  } catch (const openvdb::ArithmeticError&) {
    throw BadFile(where + " cannot be placed: its transform is singular, it cannot be inverted");
  } catch (const openvdb::Exception& error) {
    throw BadFile("the file is damaged: " + where + ": " + plain(error.what()));
  } catch (const std::length_error&) {
    throw BadFile("the file is damaged: " + where + ": an impossible length");
  }
}

VdbFile::VdbFile(const std::string& path, std::function<void(double)> progress)
    : buffer_(std::make_unique<Buffer>(std::move(progress))), stream_(buffer_.get()) {
  if (!buffer_->open(path, std::ios::in | std::ios::binary))
    throw BadFile(std::string("cannot be opened: ") + std::strerror(errno));
  size_ = static_cast<std::int64_t>(stream_.seekg(0, std::ios::end).tellg());
  stream_.seekg(0);
  buffer_->set_size(size_);
  stream_.exceptions(std::ios::failbit | std::ios::badbit);
  stream_metadata_ = std::make_shared<openvdb::io::StreamMetadata>();
  openvdb::io::setStreamMetadataPtr(stream_, stream_metadata_, /*transfer=*/false);

  guarded("its header", [&] {
    if (size_ < 8 || read_number<std::int64_t>(stream_) != magic) throw Damage("not a .vdb file");
    stream_.seekg(0);
    readHeader(stream_);
    // OpenVDB would try; what it does not know it cannot find the end of.
    if (fileVersion() > openvdb::OPENVDB_FILE_VERSION)
      throw BadFile("it is of file format " + std::to_string(fileVersion()) + ", newer than the " +
                    std::to_string(openvdb::OPENVDB_FILE_VERSION) + " that can be read");
    setFormatVersion(stream_);
    setLibraryVersion(stream_);
    setDataCompression(stream_);
    metadata_.readMeta(stream_);
  });
  guarded("its table of grids", [&] { read_table(); });
}

VdbFile::~VdbFile() = default;

GridEntry VdbFile::read_entry() {
  GridEntry entry;
  entry.unique_name = read_string(stream_);
  entry.name = openvdb::io::GridDescriptor::stripSuffix(entry.unique_name);
  entry.type = read_string(stream_);
  if (entry.type.ends_with(half_suffix)) {
    entry.half = true;
    entry.type.resize(entry.type.size() - std::strlen(half_suffix));
  }
  if (fileVersion() >= version_of_instancing) entry.parent = read_string(stream_);
  entry.grid_at = read_number<std::int64_t>(stream_);
  entry.blocks_at = read_number<std::int64_t>(stream_);
  entry.end_at = read_number<std::int64_t>(stream_);
  return entry;
}

void VdbFile::read_table() {
  const std::int32_t count = readGridCount(stream_);
  if (count < 0) throw Damage("it counts " + std::to_string(count) + " grids");
  for (std::int32_t i = 0; i < count; ++i) {
    GridEntry entry = read_entry();
    if (inputHasGridOffsets()) {
      const auto at = static_cast<std::int64_t>(stream_.tellg());
      if (entry.end_at > size_)
        throw Damage("\"" + entry.name + "\" should end at byte " + std::to_string(entry.end_at) +
                     ", the file has " + std::to_string(size_));
      // Grids follow each other, so the table moves forward: a loop in it cannot hold us.
      if (entry.grid_at < at || entry.end_at < entry.grid_at || entry.blocks_at < 0)
        throw Damage("\"" + entry.name + "\" lies at an impossible place");
      stream_.seekg(entry.end_at);
    } else {
      sequential_[entry.unique_name] = read_tree(entry);
    }
    entries_.push_back(std::move(entry));
  }
  // Grids are numbered as they lie in the file, which is how OpenVDB numbers them when it writes.
  std::map<std::string, int> count_of;
  for (GridEntry& entry : entries_) entry.index = count_of[entry.name]++;
  for (GridEntry& entry : entries_) entry.siblings = count_of[entry.name];
}

openvdb::GridBase::Ptr VdbFile::create(const GridEntry& entry) const {
  if (!openvdb::GridBase::isRegistered(entry.type))
    throw BadFile("grid \"" + entry.label() + "\" is of a type that is not known here, " +
                  entry.value_type());
  openvdb::GridBase::Ptr grid = openvdb::GridBase::createGrid(entry.type);
  grid->setSaveFloatAsHalf(entry.half);
  return grid;
}

openvdb::GridBase::Ptr VdbFile::read_tree(const GridEntry& entry) {
  openvdb::GridBase::Ptr grid = create(entry);
  openvdb::io::GridDescriptor descriptor(entry.unique_name, entry.type, entry.half);
  descriptor.setInstanceParentName(entry.parent);
  descriptor.setGridPos(entry.grid_at);
  descriptor.setBlockPos(entry.blocks_at);
  descriptor.setEndPos(entry.end_at);
  readGrid(grid, descriptor, stream_);
  return grid;
}

openvdb::GridBase::Ptr VdbFile::read(const GridEntry& entry) {
  const std::string where = "grid \"" + entry.label() + "\"";
  const auto read_one = [&](const GridEntry& one) {
    if (const auto found = sequential_.find(one.unique_name); found != sequential_.end())
      return found->second;
    return guarded(where, [&] {
      stream_.seekg(one.grid_at);
      return read_tree(one);
    });
  };
  openvdb::GridBase::Ptr grid = read_one(entry);
  if (entry.parent.empty()) return grid;
  for (const GridEntry& other : entries_)
    if (other.unique_name == entry.parent && other.parent.empty()) {
      guarded(where, [&] { grid->setTree(read_one(other)->baseTreePtr()); });
      return grid;
    }
  throw BadFile("the file is damaged: " + where + " shares the voxels of a grid that is not there");
}

openvdb::GridBase::Ptr VdbFile::read_header(const GridEntry& entry) {
  // Files older than instancing keep the transform behind the voxels.
  if (fileVersion() < version_of_instancing || !inputHasGridOffsets()) return read(entry);
  return guarded("grid \"" + entry.label() + "\"", [&] {
    openvdb::GridBase::Ptr grid = create(entry);
    stream_.seekg(entry.grid_at);
    readGridCompression(stream_);
    grid->readMeta(stream_);
    grid->readTransform(stream_);
    return grid;
  });
}

}  // namespace plinian::vdb
