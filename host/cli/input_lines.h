// Standard input, a line at a time, each as soon as it is there: whoever writes may wait for the answer.
#pragma once

#include <optional>
#include <string>

namespace plinian::cli {

class InputLines {
 public:
  /// Waits for the next line, without its end; empty where there is none any more, or after Ctrl-C.
  std::optional<std::string> next();

 private:
  std::string waiting_;  // what came behind the last line
  bool ended_ = false;
};

}  // namespace plinian::cli
