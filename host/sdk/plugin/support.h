// What the C++ over the plain C has in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

#include "host/sdk/abi.h"

// Hidden, so that nothing of one plug-in is taken for the same thing of another.
namespace plinian {
namespace PLINIAN_HIDDEN sdk {

/// Something was asked that cannot be; the message is the host's or the plug-in's own.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

namespace detail {

// Runs a function of the plug-in; nothing that it throws crosses the boundary.
template <class Action, class Fail>
void guarded(const Action& action, const Fail& fail) {
  try {
    action();
  } catch (const std::exception& error) {
    fail(error.what());
  } catch (...) {
    fail("failed without saying why");
  }
}

inline const char* text_or_null(const std::string& text) {
  return text.empty() ? nullptr : text.c_str();
}
inline const double* number_or_null(const std::optional<double>& number) {
  return number ? &*number : nullptr;
}

}  // namespace detail

}  // namespace sdk
}  // namespace plinian
