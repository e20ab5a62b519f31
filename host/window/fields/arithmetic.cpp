// A parser by recursive descent.
#include "host/window/fields/arithmetic.h"

#include <charconv>
#include <cmath>

namespace plinian::window {

namespace {

class Parser {
 public:
  explicit Parser(const std::string& text) : at_(text.data()), end_(text.data() + text.size()) {}

  std::optional<double> all() {
    const std::optional<double> value = sum();
    skip();
    return at_ == end_ && value && std::isfinite(*value) ? value : std::nullopt;
  }

 private:
  std::optional<double> sum() {
    std::optional<double> left = product();
    for (;;) {
      const bool plus = take('+');
      if (!left || (!plus && !take('-'))) return left;
      const std::optional<double> right = product();
      if (!right) return std::nullopt;
      *left += plus ? *right : -*right;
    }
  }
  std::optional<double> product() {
    std::optional<double> left = factor();
    for (;;) {
      const bool times = take('*');
      if (!left || (!times && !take('/'))) return left;
      const std::optional<double> right = factor();
      if (!right) return std::nullopt;
      *left = times ? *left * *right : *left / *right;
    }
  }
  std::optional<double> factor() {
    if (++depth_ > 100) return std::nullopt;
    if (take('-')) {
      const std::optional<double> value = factor();
      return value ? std::optional(-*value) : value;
    }
    if (take('+')) return factor();
    if (take('(')) {
      const std::optional<double> value = sum();
      return take(')') ? value : std::nullopt;
    }
    skip();
    double value = 0.0;
    const auto [rest, error] = std::from_chars(at_, end_, value);
    if (error != std::errc()) return std::nullopt;
    at_ = rest;
    return value;
  }
  void skip() {
    while (at_ != end_ && *at_ == ' ') ++at_;
  }
  bool take(char c) {
    skip();
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  const char *at_, *end_;
  int depth_ = 0;
};

}  // namespace

std::optional<double> typed_number(const std::string& text, double current) {
  const auto first = text.find_first_not_of(' ');
  if (first == text.npos) return std::nullopt;
  const std::string typed = text.substr(first);
  const char operation = typed[0];
  const bool assigns = typed.size() > 1 && typed[1] == '=';
  if (assigns || operation == '*' || operation == '/') {
    const std::optional<double> by = Parser(typed.substr(assigns ? 2 : 1)).all();
    if (!by) return std::nullopt;
    const double value = operation == '+'   ? current + *by
                         : operation == '-' ? current - *by
                         : operation == '*' ? current * *by
                         : operation == '/' ? current / *by
                                            : NAN;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  }
  return Parser(typed).all();
}

}  // namespace plinian::window
