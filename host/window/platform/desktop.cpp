// GLFW as a library.
#include "host/window/platform/desktop.h"

#include <GLFW/glfw3.h>

#include <atomic>
#include <cstdlib>

namespace plinian::window {

namespace {

std::atomic<bool> news{false};  // there is one desktop, and one queue of events

}  // namespace

NoDisplay::NoDisplay(const std::string& problem)
    : std::runtime_error(problem + "; 'plinian render INPUT -o OUT.png' makes a picture without a window") {}

bool has_display() {
  const auto given = [](const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
  };
  return given("DISPLAY") || given("WAYLAND_DISPLAY");
}

Desktop::Desktop() {
  if (!has_display()) throw NoDisplay("there is no display to open a window on");
  if (!glfwInit()) throw NoDisplay("no window can be opened: " + last_error());
}

Desktop::~Desktop() {
  glfwTerminate();
}

void Desktop::wake() {
  news = true;
  glfwPostEmptyEvent();
}

bool Desktop::take_wake() {
  return news.exchange(false);
}

std::string Desktop::last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "the window system says no more";
}

}  // namespace plinian::window
