// A 128-bit hash of values, by which results of computations are known. Not cryptographic.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string_view>

namespace plinian::graph {

struct Hash {
  std::uint64_t low = 0, high = 0;
  bool operator==(const Hash&) const = default;
};

/// Takes words one by one; the order counts.
class Hasher {
 public:
  void add(std::uint64_t word) {
    // Two lanes of the finaliser of MurmurHash3 (Appleby, public domain) over running states.
    low_ = (std::rotl(low_, 23) ^ word) * 0xff51afd7ed558ccdull;
    low_ ^= low_ >> 33;
    high_ = (std::rotl(high_, 29) ^ word) * 0xc4ceb9fe1a85ec53ull;
    high_ ^= high_ >> 29;
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number == 0.0 ? 0.0 : number)); }
  void add(Hash hash) {
    add(hash.low);
    add(hash.high);
  }
  void add(std::string_view text) {
    add(std::uint64_t(text.size()));
    for (std::size_t i = 0; i < text.size(); i += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, text.data() + i, std::min<std::size_t>(8, text.size() - i));
      add(word);
    }
  }
  Hash result() const { return {low_ ^ (high_ >> 31), high_ ^ (low_ << 7)}; }

 private:
  std::uint64_t low_ = 0x9e3779b97f4a7c15ull, high_ = 0xd1b54a32d192ed03ull;
};

}  // namespace plinian::graph

template <>
struct std::hash<plinian::graph::Hash> {
  std::size_t operator()(const plinian::graph::Hash& hash) const noexcept { return hash.low; }
};
