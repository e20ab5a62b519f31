#include "tests/host/window/sitting.h"

#include <X11/XKBlib.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

#include "core/files/atomic_file.h"
#include "core/image/image_io.h"
#include "tests/host/window/file_drag.h"

namespace plinian {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Sitting::State {
  pid_t server = -1, program = -1;
  std::string display_name;
  Display* display = nullptr;
  std::ifstream trace;
  std::string rest;  // of a line that is not ended yet
};

namespace {

pid_t start(const std::vector<std::string>& words, const std::function<void()>& prepare) {
  std::vector<std::string> kept = words;
  std::vector<char*> argv;
  for (std::string& word : kept) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    prepare();
    execvp(argv[0], argv.data());
    _exit(127);
  }
  return child;
}

void end(pid_t& child) {
  if (child <= 0) return;
  kill(child, SIGTERM);
  for (int i = 0; i < 100; ++i) {
    if (waitpid(child, nullptr, WNOHANG) == child) {
      child = -1;
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  child = -1;
}

Window find_window(Display* display) {
  Window root = 0, parent = 0, *children = nullptr, found = 0;
  unsigned count = 0;
  if (XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count))
    for (unsigned i = 0; i < count; ++i) {
      XWindowAttributes attributes;
      if (XGetWindowAttributes(display, children[i], &attributes) && attributes.map_state == IsViewable &&
          attributes.width > 100)
        found = children[i];
    }
  if (children) XFree(children);
  return found;
}

}  // namespace

std::string Sitting::problem() {
  std::istringstream folders(std::getenv("PATH") ? std::getenv("PATH") : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((fs::path(folder) / "Xvfb").c_str(), X_OK) == 0) return "";
  return "Xvfb is not installed";
}

Sitting::Sitting(const std::vector<std::string>& arguments, ivec2 size, int scale)
    : state_(std::make_unique<State>()), size_(size), scale_(scale) {
  int number[2];
  if (pipe(number) != 0) throw std::runtime_error("no pipe");
  const std::string screen = std::to_string(size.x) + "x" + std::to_string(size.y) + "x24";
  state_->server = start(
      {"Xvfb", "-displayfd", std::to_string(number[1]), "-screen", "0", screen, "-nolisten", "tcp"}, [] {
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDERR_FILENO);
      });
  ::close(number[1]);
  char digits[16] = "";
  for (std::size_t have = 0; have + 1 < sizeof digits;) {
    const ssize_t more = read(number[0], digits + have, sizeof digits - 1 - have);
    if (more <= 0) throw std::runtime_error("Xvfb did not start");
    have += std::size_t(more);
    if (digits[have - 1] == '\n') break;
  }
  ::close(number[0]);
  state_->display_name = std::string(":").append(std::to_string(std::atoi(digits)));

  state_->display = XOpenDisplay(state_->display_name.c_str());
  if (!state_->display) throw std::runtime_error("the display cannot be opened");
  const std::string resources = "Xft.dpi:\t" + std::to_string(96 * scale) + "\n";
  XChangeProperty(state_->display, DefaultRootWindow(state_->display), XA_RESOURCE_MANAGER, XA_STRING, 8,
                  PropModeReplace, reinterpret_cast<const unsigned char*>(resources.data()),
                  int(resources.size()));
  XSync(state_->display, False);
  start_program(arguments);
}

void Sitting::start_program(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {
      PLINIAN_PROGRAM,   "view",   "--trace",
      folder_ / "trace", "--size", std::to_string(size_.x / scale_) + "x" + std::to_string(size_.y / scale_)};
  words.insert(words.end(), arguments.begin(), arguments.end());
  state_->program = start(words, [&] {
    setenv("DISPLAY", state_->display_name.c_str(), 1);
    unsetenv("WAYLAND_DISPLAY");
    setenv("XDG_CONFIG_HOME", (folder() / "config").c_str(), 1);
    setenv("XDG_STATE_HOME", (folder() / "state").c_str(), 1);
    const int errors = open((folder() / "errors").c_str(), O_WRONLY | O_CREAT, 0600);
    dup2(errors, STDERR_FILENO);
    if (chdir(folder().c_str()) != 0) _exit(126);
  });
  released_at_.reset();
  wait_for("item \"picture\"");
  if (!find_window(state_->display)) throw std::runtime_error("there is no window");
}

void Sitting::kill_and_start_again(const std::vector<std::string>& arguments, int signal) {
  kill(state_->program, signal);
  waitpid(state_->program, nullptr, 0);
  state_->program = -1;
  state_->trace = std::ifstream();
  state_->rest.clear();
  lines_.clear();
  fs::remove(folder_ / "trace");
  start_program(arguments);
}

Sitting::~Sitting() {
  end(state_->program);
  if (state_->display) XCloseDisplay(state_->display);
  end(state_->server);
}

std::string Sitting::errors() const {
  std::ifstream file(folder_ / "errors");
  return {std::istreambuf_iterator<char>(file), {}};
}

void Sitting::read_trace() {
  if (!state_->trace.is_open()) state_->trace.open(folder_ / "trace");
  state_->trace.clear();
  char buffer[4096];
  while (state_->trace.read(buffer, sizeof buffer) || state_->trace.gcount() > 0) {
    state_->rest.append(buffer, std::size_t(state_->trace.gcount()));
    for (std::size_t end; (end = state_->rest.find('\n')) != std::string::npos;) {
      lines_.push_back(state_->rest.substr(0, end));
      state_->rest.erase(0, end + 1);
    }
    if (!state_->trace) break;
  }
}

const std::vector<std::string>& Sitting::lines() {
  read_trace();
  return lines_;
}

std::size_t Sitting::now() {
  return lines().size();
}

std::string Sitting::last_lines() const {
  std::string text;
  for (std::size_t i = lines_.size() > 12 ? lines_.size() - 12 : 0; i < lines_.size(); ++i)
    text += lines_[i] + "\n";
  return text;
}

std::size_t Sitting::wait_for(const std::function<bool(const std::string&)>& wanted, std::size_t since) {
  const Clock::time_point begin = Clock::now();
  for (std::size_t next = since;;) {
    read_trace();
    for (; next < lines_.size(); ++next)
      if (wanted(lines_[next])) return next;
    if (state_->program > 0 && waitpid(state_->program, nullptr, WNOHANG) == state_->program) {
      state_->program = -1;
      throw std::runtime_error("the program ended: " + errors());
    }
    if (Clock::now() - begin > std::chrono::seconds(90))
      throw std::runtime_error("what was waited for did not come; the trace ends with\n" + last_lines() +
                               errors());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

std::size_t Sitting::wait_for(const std::string& words, std::size_t since) {
  return wait_for([&](const std::string& line) { return line.find(words) != std::string::npos; }, since);
}

void Sitting::wait_for_keys(const std::string& where) {
  std::string last = "keys to the window";
  std::size_t next = 0;
  for (;;) {
    for (read_trace(); next < lines_.size(); ++next)
      if (const std::size_t at = lines_[next].find("keys to "); at != std::string::npos)
        last = lines_[next].substr(at);
    if (last == where) return;
    wait_for("keys to ", next);
  }
}

ivec4 Sitting::item(const std::string& name) {
  const std::string words = "item \"" + name + "\" ";
  wait_for(words);
  ivec4 place(0);
  for (const std::string& line : lines())
    if (const std::size_t at = line.find(words); at != std::string::npos) {
      std::istringstream numbers(line.substr(at + words.size()));
      numbers >> place.x >> place.y >> place.z >> place.w;
    }
  return place;
}

ivec2 Sitting::middle(const std::string& name) {
  const ivec4 place = item(name);
  return {place.x + place.z / 2, place.y + place.w / 2};
}

// Long enough that the window may take notice of each step; nothing depends on whether it does.
void Sitting::pause() {
  XSync(state_->display, False);
  std::this_thread::sleep_for(std::chrono::milliseconds(25));
}

void Sitting::move(ivec2 to) {
  // A button is let go where it was pressed: seen together with the way to the next place it is no click.
  if (const auto at = std::exchange(released_at_, std::nullopt)) wait_for_mouse(*at, 0);
  XTestFakeMotionEvent(state_->display, -1, to.x, to.y, CurrentTime);
  pause();
}

void Sitting::press(unsigned button) {
  XTestFakeButtonEvent(state_->display, button, True, CurrentTime);
  pause();
}

void Sitting::release(unsigned button) {
  XTestFakeButtonEvent(state_->display, button, False, CurrentTime);
  pause();
}

void Sitting::wait_for_mouse(ivec2 at, unsigned button) {
  const int down = button == 1 ? 1 : button == 2 ? 4 : button == 3 ? 2 : 0;
  const std::string wanted =
      "mouse " + std::to_string(at.x) + " " + std::to_string(at.y) + " " + std::to_string(down);
  // What was seen last counts, not that it was there before.
  const std::vector<std::string>& seen = lines();
  std::size_t last = seen.size();
  while (last > 0 && seen[last - 1].find(" mouse ") == std::string::npos) --last;
  if (last == 0 || !seen[last - 1].ends_with(wanted))
    wait_for([&](const std::string& line) { return line.ends_with(wanted); }, last);
}

// A hand sees what it does: however slow the window is, it has seen each part before the next one comes.
void Sitting::click(ivec2 at, unsigned button) {
  move(at);
  wait_for_mouse(at, 0);
  press(button);
  wait_for_mouse(at, button);
  release(button);
  released_at_ = at;
}

void Sitting::drag(ivec2 from, ivec2 to, unsigned button) {
  move(from);
  wait_for_mouse(from, 0);
  press(button);
  wait_for_mouse(from, button);
  for (int i = 1; i <= 10; ++i) move(from + (to - from) * i / 10);
  wait_for_mouse(to, button);
  release(button);
  wait_for_mouse(to, 0);
}

void Sitting::key_down(const char* keysym) {
  const KeyCode code = XKeysymToKeycode(state_->display, XStringToKeysym(keysym));
  XTestFakeKeyEvent(state_->display, code, True, CurrentTime);
  pause();
}

void Sitting::key_up(const char* keysym) {
  const KeyCode code = XKeysymToKeycode(state_->display, XStringToKeysym(keysym));
  XTestFakeKeyEvent(state_->display, code, False, CurrentTime);
  pause();
}

void Sitting::stroke(const std::string& keysyms) {
  std::vector<std::string> names;
  std::istringstream words(keysyms);
  for (std::string name; std::getline(words, name, '+');) names.push_back(name);
  for (const std::string& name : names) key_down(name.c_str());
  for (auto name = names.rbegin(); name != names.rend(); ++name) key_up(name->c_str());
}

void Sitting::type(const std::string& text) {
  for (const char c : text) {
    const KeySym keysym = KeySym((unsigned char)c);  // Latin-1 is its own
    const KeyCode code = XKeysymToKeycode(state_->display, keysym);
    const bool shift = XkbKeycodeToKeysym(state_->display, code, 0, 0) != keysym;
    if (shift) key_down("Shift_L");
    XTestFakeKeyEvent(state_->display, code, True, CurrentTime);
    XSync(state_->display, False);
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
    XTestFakeKeyEvent(state_->display, code, False, CurrentTime);
    XSync(state_->display, False);
    if (shift) key_up("Shift_L");
  }
  pause();
}

void Sitting::drop(const std::vector<fs::path>& files, ivec2 at) {
  std::string uris;
  for (const fs::path& file : files) {
    uris += "file://";
    for (const char c : file.string())
      if (std::isalnum((unsigned char)c) || std::strchr("/-_.~", c)) {
        uris += c;
      } else {
        char escaped[4];
        std::snprintf(escaped, sizeof escaped, "%%%02X", unsigned((unsigned char)c));
        uris += escaped;
      }
    uris += "\r\n";
  }
  move(at);
  drop_uris(state_->display, find_window(state_->display), uris, at);
}

void Sitting::resize(ivec2 size) {
  XResizeWindow(state_->display, find_window(state_->display), unsigned(size.x), unsigned(size.y));
  pause();
}

bool Sitting::is_running() {
  siginfo_t info{};
  return state_->program > 0 &&
         waitid(P_PID, id_t(state_->program), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0;
}

double Sitting::memory() {
  std::ifstream file("/proc/" + std::to_string(state_->program) + "/statm");
  double all = 0.0, resident = 0.0;
  file >> all >> resident;
  return resident * double(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

void Sitting::send(int signal) {
  kill(state_->program, signal);
}

Pixels Sitting::pixels(ivec4 area) {
  XImage* image = XGetImage(state_->display, DefaultRootWindow(state_->display), area.x, area.y,
                            unsigned(area.z), unsigned(area.w), AllPlanes, ZPixmap);
  if (!image) throw std::runtime_error("the screen cannot be read");
  Pixels pixels{area.z, area.w, {}};
  for (int y = 0; y < area.w; ++y)
    for (int x = 0; x < area.z; ++x) {
      const unsigned long p = XGetPixel(image, x, y);
      for (const int shift : {16, 8, 0}) pixels.rgb.push_back(std::uint8_t(p >> shift));
    }
  XDestroyImage(image);
  return pixels;
}

void Sitting::keep(const std::string& name) {
  const char* folder = std::getenv("PLINIAN_SITTING_PICTURES");
  if (!folder) return;
  const Pixels seen = pixels({0, 0, size_.x, size_.y});
  write_file((fs::path(folder) / name).string(), encode_png(seen.rgb, seen.width, seen.height));
}

void Sitting::ask_to_close() {
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = find_window(state_->display);
  event.xclient.message_type = XInternAtom(state_->display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = long(XInternAtom(state_->display, "WM_DELETE_WINDOW", False));
  XSendEvent(state_->display, find_window(state_->display), False, NoEventMask, &event);
  XSync(state_->display, False);
}

int Sitting::exit_code() {
  for (int i = 0; i < 1500; ++i) {
    int status = 0;
    if (waitpid(state_->program, &status, WNOHANG) == state_->program) {
      state_->program = -1;
      return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return -1;
}

}  // namespace plinian
