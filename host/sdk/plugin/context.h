// What a compute function sees of the world.
#pragma once

#include <algorithm>
#include <array>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "host/sdk/abi.h"
#include "host/sdk/plugin/support.h"
#include "host/sdk/plugin/volume.h"

namespace plinian {
namespace PLINIAN_HIDDEN sdk {

/// An attribute of the node type that declared it.
struct Attribute {
  std::int32_t index = -1;
  bool operator==(const Attribute& other) const { return index == other.index; }
};

/// What a compute function sees of the world. Throws Error where an input failed or is of another type.
class Context {
 public:
  Context(const PlinianCompute& table, PlinianContext* context) : table_(table), context_(context) {}

  /// Of a bool 0 or 1, of an enum the number of its choice (not its place among them), of a distance metres,
  /// of an angle degrees, of a time frames.
  double number(Attribute a, std::int32_t element = -1) const { return read_number(a, element, nullptr); }
  std::array<float, 4> vector(Attribute a, std::int32_t element = -1) const {
    return read_vector(a, element, nullptr);
  }
  std::array<double, 16> matrix(Attribute a, std::int32_t element = -1) const {
    return read_matrix(a, element, nullptr);
  }
  std::string text(Attribute a, std::int32_t element = -1) const { return read_text(a, element, nullptr); }
  /// Null where there are none yet; good until the function returns.
  const void* data(Attribute a, std::int32_t element = -1) const { return read_data(a, element, nullptr); }

  /// As they are at another time [frames]. What is read so must affect the output like any input.
  double number_at(double time, Attribute a, std::int32_t element = -1) const {
    return read_number(a, element, &time);
  }
  std::array<float, 4> vector_at(double time, Attribute a, std::int32_t element = -1) const {
    return read_vector(a, element, &time);
  }
  std::array<double, 16> matrix_at(double time, Attribute a, std::int32_t element = -1) const {
    return read_matrix(a, element, &time);
  }
  std::string text_at(double time, Attribute a, std::int32_t element = -1) const {
    return read_text(a, element, &time);
  }
  const void* data_at(double time, Attribute a, std::int32_t element = -1) const {
    return read_data(a, element, &time);
  }

  std::vector<std::int32_t> elements(Attribute array) const {
    const std::int32_t* found = nullptr;
    const std::size_t count = table_.elements(context_, array.index, &found);
    return std::vector<std::int32_t>(found, found + count);
  }

  void set(Attribute a, double value) { check(table_.write_number(context_, a.index, value)); }
  void set(Attribute a, std::initializer_list<float> value) {
    check(table_.write_vector(context_, a.index, value.begin(), std::int32_t(value.size())));
  }
  void set(Attribute a, const std::array<double, 16>& matrix) {
    check(table_.write_matrix(context_, a.index, matrix.data()));
  }
  void set(Attribute a, const std::string& text) {
    check(table_.write_text(context_, a.index, text.c_str()));
  }
  /// Hands an object on. bytes: that it holds; content: as in PlinianData.
  template <class T>
  void set_data(Attribute a, const char* type, std::unique_ptr<const T> object, std::size_t bytes,
                std::uint64_t content = 0) {
    const PlinianData data{sizeof(PlinianData), type, object.release(), bytes, content, [](const void* p) {
                             delete static_cast<const T*>(p);
                           }};
    check(table_.write_data(context_, a.index, &data));
  }

  /// A ramp at a position, held constant beyond its first and last point; 0 where it has none, as it is
  /// without a default.
  std::array<float, 3> sample_ramp(Attribute a, float position, std::int32_t element = -1) const {
    std::array<float, 3> value{};
    check(table_.sample_ramp(context_, a.index, element, nullptr, position, value.data()));
    return value;
  }

  /// A volume that an input holds; empty where there is none yet.
  Volume volume(Attribute a, std::int32_t element = -1) const { return read_volume(a, element, nullptr); }
  Volume volume_at(double time, Attribute a, std::int32_t element = -1) const {
    return read_volume(a, element, &time);
  }
  /// Makes a volume of the plug-in's own voxels, for outputs and for media.
  Volume make_volume(const VolumeSource& source) const {
    if (!source.fill) throw Error("a volume needs a function that fills it: VolumeSource::fill is empty");
    struct Filling {
      const VolumeSource& source;
      std::exception_ptr failure;
      std::mutex mutex;
    } filling{source, nullptr, {}};
    PlinianVolumeSource plain{};
    plain.size = sizeof(plain);
    for (int i = 0; i < 3; ++i) {
      plain.first[i] = source.first[std::size_t(i)];
      plain.count[i] = source.count[std::size_t(i)];
    }
    std::copy(source.object_from_index.begin(), source.object_from_index.end(), plain.object_from_index);
    plain.flags = (source.temperatures ? PLINIAN_VOLUME_TEMPERATURE : 0u) |
                  (source.concurrent ? PLINIAN_VOLUME_CONCURRENT : 0u);
    plain.content = source.content;
    plain.user = &filling;
    plain.fill = [](void* user, const std::int32_t* first, float* density, float* temperature) {
      Filling& now = *static_cast<Filling*>(user);
      try {
        return int(now.source.fill({first[0], first[1], first[2]}, density, temperature));
      } catch (...) {
        const std::lock_guard lock(now.mutex);
        now.failure = std::current_exception();
        return -1;
      }
    };
    Volume volume;
    const int success = table_.make_volume(context_, &plain, &volume.handle);
    if (filling.failure) std::rethrow_exception(filling.failure);
    check(success);
    return volume;
  }
  VolumeInfo info(Volume volume) const {
    PlinianVolumeInfo plain{};
    plain.size = sizeof(plain);
    check(table_.volume_info(context_, volume.handle, &plain));
    VolumeInfo info;
    std::copy_n(plain.first, 3, info.first.begin());
    std::copy_n(plain.count, 3, info.count.begin());
    std::copy_n(plain.object_from_index, 16, info.object_from_index.begin());
    info.density_max = plain.density_max;
    info.temperature_max = plain.temperature_max;
    info.voxels = plain.voxels;
    return info;
  }
  /// The densities of a box of voxels, x fastest, and their temperatures where they are asked for.
  std::vector<float> voxels(Volume volume, const Voxel& first, const Voxel& count,
                            std::vector<float>* temperatures = nullptr) const {
    const std::size_t size = std::size_t(count[0]) * std::size_t(count[1]) * std::size_t(count[2]);
    std::vector<float> densities(size);
    if (temperatures) temperatures->resize(size);
    check(table_.read_voxels(context_, volume.handle, first.data(), count.data(), densities.data(),
                             temperatures ? temperatures->data() : nullptr));
    return densities;
  }
  void set(Attribute a, Volume volume) { check(table_.write_volume(context_, a.index, volume.handle)); }

  /// The current frame; for time sources alone.
  double time() const {
    double frames = 0.0;
    check(table_.time(context_, &frames));
    return frames;
  }
  bool cancelled() const { return table_.cancelled(context_) != 0; }
  void progress(double fraction, const std::string& what) {
    table_.progress(context_, fraction, what.c_str());
  }

  /// Throws Error with what the host says where a function of the tables failed.
  void check(int success) const {
    if (!success) throw Error(table_.error(context_));
  }
  PlinianContext* plain() const { return context_; }

 private:
  double read_number(Attribute a, std::int32_t element, const double* time) const {
    double value = 0.0;
    check(table_.read_number(context_, a.index, element, time, &value));
    return value;
  }
  std::array<float, 4> read_vector(Attribute a, std::int32_t element, const double* time) const {
    std::array<float, 4> value{};
    check(table_.read_vector(context_, a.index, element, time, value.data()));
    return value;
  }
  std::array<double, 16> read_matrix(Attribute a, std::int32_t element, const double* time) const {
    std::array<double, 16> value{};
    check(table_.read_matrix(context_, a.index, element, time, value.data()));
    return value;
  }
  std::string read_text(Attribute a, std::int32_t element, const double* time) const {
    const char* value = "";
    check(table_.read_text(context_, a.index, element, time, &value));
    return value;
  }
  const void* read_data(Attribute a, std::int32_t element, const double* time) const {
    const void* value = nullptr;
    check(table_.read_data(context_, a.index, element, time, &value));
    return value;
  }
  Volume read_volume(Attribute a, std::int32_t element, const double* time) const {
    Volume value;
    check(table_.read_volume(context_, a.index, element, time, &value.handle));
    return value;
  }

  const PlinianCompute& table_;
  PlinianContext* context_;
};

}  // namespace sdk
}  // namespace plinian
