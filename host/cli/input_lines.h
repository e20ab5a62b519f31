// Standard input, a line at a time, each as soon as it is there: whoever writes may wait for the answer.
#pragma once

#include <optional>
#include <string>

namespace plinian::cli {

class InputLines {
 public:
  /// longest: of a line, without its end [bytes].
  explicit InputLines(std::size_t longest) : longest_(longest) {}
  /// Waits for the next line, without its end; empty where there is none any more, or after Ctrl-C. Of one
  /// that is too long only the beginning comes, which is longer than the longest.
  std::optional<std::string> next();

 private:
  std::size_t longest_;
  std::string waiting_;       // what came behind the last line
  std::size_t searched_ = 0;  // of it, in which no line ends
  bool ended_ = false;
};

}  // namespace plinian::cli
