// GLFW, and what it tells.
#include "host/window/platform/main_window.h"

#include <epoxy/gl.h>
//
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "host/window/platform/input_queue.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

struct MainWindow::Events {
  std::vector<std::string> dropped;
  std::vector<Chord> keys;
  bool any = false, close = false;
  InputQueue input;
  bool told = false;    // a share of it, that no picture has seen yet
  bool urgent = false;  // a key or a button was in it
  dvec2 mouse{-FLT_MAX};
  std::array<bool, 5> buttons{};
};

namespace {

std::string key_name(int key, int scancode) {
  static const std::map<int, std::string> named = {{GLFW_KEY_SPACE, "Space"},
                                                   {GLFW_KEY_TAB, "Tab"},
                                                   {GLFW_KEY_ENTER, "Enter"},
                                                   {GLFW_KEY_KP_ENTER, "Enter"},
                                                   {GLFW_KEY_ESCAPE, "Escape"},
                                                   {GLFW_KEY_DELETE, "Delete"},
                                                   {GLFW_KEY_BACKSPACE, "Backspace"},
                                                   {GLFW_KEY_HOME, "Home"},
                                                   {GLFW_KEY_END, "End"},
                                                   {GLFW_KEY_PAGE_UP, "PageUp"},
                                                   {GLFW_KEY_PAGE_DOWN, "PageDown"},
                                                   {GLFW_KEY_LEFT, "Left"},
                                                   {GLFW_KEY_RIGHT, "Right"},
                                                   {GLFW_KEY_UP, "Up"},
                                                   {GLFW_KEY_DOWN, "Down"},
                                                   {GLFW_KEY_INSERT, "Insert"}};
  if (const auto found = named.find(key); found != named.end()) return found->second;
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  const char* text = glfwGetKeyName(key, scancode);
  if (!text || text[0] == 0 || text[1] != 0) return "";
  return std::string(1, char(std::toupper((unsigned char)text[0])));
}

}  // namespace

namespace {

// A part of the window that is not on the screen cannot be reached.
ivec2 on_screen(ivec2 size) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (!monitor) return size;
  ivec2 place(0), room(0);
  glfwGetMonitorWorkarea(monitor, &place.x, &place.y, &room.x, &room.y);
  return room.x > 0 && room.y > 0 ? glm::min(size, room) : size;
}

GLFWwindow* make_window(const std::string& title, ivec2 size) {
  size = on_screen(size);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  // Not every driver can tell of a reset.
  for (const int robustness : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, robustness);
    if (GLFWwindow* window = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr)) return window;
  }
  throw NoDisplay("no window with OpenGL 4.5 can be opened: " + Desktop::last_error());
}

// A driver compiles a program for each kind of texture and filter when it is first drawn with, llvmpipe for a
// tenth of a second: here for those of text and of pictures, where nobody waits for an answer yet.
void draw_once() {
  const ivec2 size(5, 3);  // as odd as pictures are
  unsigned textures[2];
  glCreateTextures(GL_TEXTURE_2D, 2, textures);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddText({9, 9}, 0xffffffff, "Plinian");
  for (int i = 0; i < 2; ++i) {
    glTextureStorage2D(textures[i], 1, GL_RGB8, size.x, size.y);
    glTextureParameteri(textures[i], GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(textures[i], GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    for (const unsigned which : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      glTextureParameteri(textures[i], which, i == 0 ? GL_NEAREST : GL_LINEAR);
    list.AddImage(ImTextureID(std::intptr_t(textures[i])), {9, 9}, {40, 40});
  }
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glFinish();
  glDeleteTextures(2, textures);
}

}  // namespace

MainWindow::MainWindow(const std::string& title, ivec2 size) : events_(std::make_unique<Events>()) {
  GLFWwindow* window = make_window(title, size);
  window_ = window;
  glfwSetWindowSizeLimits(window, 720, 480, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  float x = 1.0f, y = 1.0f;
  glfwGetWindowContentScale(window, &x, &y);
  scale_ = std::clamp(double(std::max(x, y)), 1.0, 4.0);

  glfwSetWindowUserPointer(window, events_.get());
  static constexpr auto note = [](GLFWwindow* w) {
    return static_cast<Events*>(glfwGetWindowUserPointer(w));
  };
  using Kind = InputEvent::Kind;
  static constexpr auto add = [](GLFWwindow* w, const InputEvent& event) {
    note(w)->any = true;
    note(w)->input.add(event);
  };
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    add(w, {.kind = Kind::motion, .at = {x, y}});
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    note(w)->any = true;
    ImGui_ImplGlfw_CursorEnterCallback(w, entered);
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
    add(w, {.kind = Kind::button, .code = button, .down = action == GLFW_PRESS});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    add(w, {.kind = Kind::wheel, .at = {x, y}});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
    add(w, {.kind = Kind::character, .code = int(character)});
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    note(w)->any = true;
    ImGui_ImplGlfw_WindowFocusCallback(w, focused);
  });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { note(w)->any = true; });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { note(w)->any = true; });
  glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
    note(w)->any = note(w)->close = true;
    glfwSetWindowShouldClose(w, GLFW_FALSE);
  });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    note(w)->any = true;
    note(w)->dropped.insert(note(w)->dropped.end(), paths, paths + count);
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
    add(w, {.kind = Kind::key,
            .code = key,
            .down = action != GLFW_RELEASE,
            .repeat = action == GLFW_REPEAT,
            .scancode = scancode,
            .modifiers = mods});
  });

  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().ConfigInputTextCursorBlink = false;  // the window is drawn when something happens
  ImGui_ImplGlfw_InitForOpenGL(window, false);
  ImGui_ImplOpenGL3_Init("#version 330 core");
  set_theme(scale_);
  draw_once();
  glfwShowWindow(window);
}

MainWindow::~MainWindow() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(static_cast<GLFWwindow*>(window_));
}

bool MainWindow::wait(double seconds) {
  if (seconds > 0.0)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
  const bool woken = Desktop::take_wake();
  return std::exchange(events_->any, false) || woken;
}

void MainWindow::tell_input() {
  Events& events = *events_;
  if (events.told || events.input.is_empty()) return;
  events.told = true;
  GLFWwindow* window = static_cast<GLFWwindow*>(window_);
  for (const InputEvent& event : events.input.take()) switch (event.kind) {
      case InputEvent::Kind::motion:
        events.mouse = event.at;
        break;
      case InputEvent::Kind::button:
        if (std::size_t(event.code) < events.buttons.size())
          events.buttons[std::size_t(event.code)] = event.down;
        events.urgent = true;
        break;
      case InputEvent::Kind::wheel:
        ImGui_ImplGlfw_ScrollCallback(window, event.at.x, event.at.y);
        break;
      case InputEvent::Kind::character:
        ImGui_ImplGlfw_CharCallback(window, unsigned(event.code));
        break;
      case InputEvent::Kind::key: {
        events.urgent = true;
        ImGui_ImplGlfw_KeyCallback(window, event.code, event.scancode, event.down ? GLFW_PRESS : GLFW_RELEASE,
                                   event.modifiers);
        const Chord chord{(event.modifiers & GLFW_MOD_CONTROL) != 0, (event.modifiers & GLFW_MOD_SHIFT) != 0,
                          (event.modifiers & GLFW_MOD_ALT) != 0, key_name(event.code, event.scancode)};
        if (event.down && !chord.key.empty()) events.keys.push_back(chord);
        break;
      }
    }
}

bool MainWindow::has_input() const {
  return !events_->input.is_empty();
}

bool MainWindow::take_urgent() {
  return std::exchange(events_->urgent, false);
}

void* MainWindow::gl_function(const char* name) {
  return reinterpret_cast<void*>(glfwGetProcAddress(name));
}

void MainWindow::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  // The backend asks where the mouse is now, and which of its buttons are down.
  ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMousePosValid() || events_->buttons[0])
    io.MousePos = {float(events_->mouse.x), float(events_->mouse.y)};
  std::copy(events_->buttons.begin(), events_->buttons.end(), io.MouseDown);
  events_->told = false;
  ImGui::NewFrame();
}

void MainWindow::end_frame(vec3 background) {
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(static_cast<GLFWwindow*>(window_), &width, &height);
  glViewport(0, 0, width, height);
  glClearColor(background.x, background.y, background.z, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(static_cast<GLFWwindow*>(window_));
}

bool MainWindow::is_context_lost() const {
  return glGetGraphicsResetStatus() != GL_NO_ERROR;
}

void MainWindow::hide() {
  glfwHideWindow(static_cast<GLFWwindow*>(window_));
  glfwPollEvents();
}

void MainWindow::set_title(const std::string& title) {
  glfwSetWindowTitle(static_cast<GLFWwindow*>(window_), title.c_str());
}

bool MainWindow::take_close_request() {
  return std::exchange(events_->close, false);
}

std::vector<std::string> MainWindow::take_dropped(dvec2* where) {
  if (where) glfwGetCursorPos(static_cast<GLFWwindow*>(window_), &where->x, &where->y);
  return std::exchange(events_->dropped, {});
}

std::vector<Chord> MainWindow::take_keys() {
  return std::exchange(events_->keys, {});
}

bool MainWindow::is_held(const Chord& chord) const {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput || chord.key.empty() || io.KeyCtrl != chord.ctrl || io.KeyAlt != chord.alt ||
      (chord.shift && !io.KeyShift))
    return false;
  for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key)
    if (io.KeysDown[key] && key_name(key, glfwGetKeyScancode(key)) == chord.key) return true;
  return false;
}

ivec2 MainWindow::size() const {
  ivec2 size(0);
  glfwGetWindowSize(static_cast<GLFWwindow*>(window_), &size.x, &size.y);
  return size;
}

double MainWindow::pixel_ratio() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(static_cast<GLFWwindow*>(window_), &width, &height);
  const ivec2 points = size();
  return points.x > 0 ? double(width) / points.x : 1.0;
}

}  // namespace plinian::window
