// The program's window on a display of its own, driven by real X input as by a hand.
#pragma once

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/shared/glue.h"
#include "tests/core/scene/temporary_folder.h"

namespace plinian {

struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // top row first
};

class Sitting {
 public:
  /// Starts a display and the program on it. arguments: after `view`. size: of the display [pixels], which
  /// the window fills. scale: of the interface, as a desktop with small pixels asks for. Throws
  /// std::runtime_error.
  explicit Sitting(const std::vector<std::string>& arguments, ivec2 size = {1000, 560}, int scale = 1);
  /// Ends both.
  ~Sitting();
  /// Why there can be no sitting here; empty where there can.
  static std::string problem();

  /// A folder of its own, where the program runs.
  const std::filesystem::path& folder() const { return folder_.path(); }

  /// Waits until a line of the trace, from the one `since` on, satisfies; returns its number. Throws where
  /// none comes within 90 seconds or the program ends.
  std::size_t wait_for(const std::function<bool(const std::string&)>& wanted, std::size_t since = 0);
  /// ... that holds these words in a row.
  std::size_t wait_for(const std::string& words, std::size_t since = 0);
  /// Waits until the trace says last that keys go there: "keys to a field", "keys to the window".
  void wait_for_keys(const std::string& where);
  std::size_t now();  // number of the next line of the trace
  std::string line(std::size_t number) { return lines_.at(number); }
  const std::vector<std::string>& lines();

  /// Where an item of the window is; waits for it. [pixels]
  ivec4 item(const std::string& name);
  ivec2 middle(const std::string& name);

  /// Waits until the window has seen the mouse there. button: that is down; 0: none.
  void wait_for_mouse(ivec2 at, unsigned button);
  void move(ivec2 to);
  void press(unsigned button = 1);
  void release(unsigned button = 1);
  void click(ivec2 at, unsigned button = 1);
  /// In ten steps, as a hand does.
  void drag(ivec2 from, ivec2 to, unsigned button = 1);
  void key_down(const char* keysym);
  void key_up(const char* keysym);
  /// "Ctrl+Z" as "Control_L+z".
  void stroke(const std::string& keysyms);
  void type(const std::string& text);

  /// Files, dropped there by a file manager.
  void drop(const std::vector<std::filesystem::path>& files, ivec2 at);

  Pixels pixels(ivec4 area);
  /// Where PLINIAN_SITTING_PICTURES names a folder, keeps there what is on the screen, to be looked at.
  void keep(const std::string& name);
  /// Ends the program, as a crash would unless the signal is another, and starts it anew.
  void kill_and_start_again(const std::vector<std::string>& arguments, int signal = SIGKILL);
  void resize(ivec2 size);
  /// Whether the program runs.
  bool is_running();
  /// What it holds in memory. [MiB]
  double memory();
  void send(int signal);
  /// Asks the window to close, as a desktop does.
  void ask_to_close();
  /// Waits for the program to end; -1 where it does not within half a minute.
  int exit_code();
  std::string errors() const;  // what the program said on standard error

 private:
  struct State;
  void start_program(const std::vector<std::string>& arguments);
  void read_trace();
  std::string last_lines() const;
  void pause();

  std::unique_ptr<State> state_;
  TemporaryFolder folder_;
  ivec2 size_;
  int scale_;
  std::vector<std::string> lines_;
  std::optional<ivec2> released_at_;  // by a click that the window may not have seen the end of
};

}  // namespace plinian
