#include "tests/host/window/file_drag.h"

#include <X11/Xatom.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace plinian {

namespace {

class FileDrag {
 public:
  FileDrag(Display* display, Window target, const std::string& uris)
      : display_(display), target_(target), uris_(uris) {
    source_ = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display, atom("XdndSelection"), source_, CurrentTime);
  }
  ~FileDrag() {
    XDestroyWindow(display_, source_);
    XSync(display_, False);
  }

  void drop(ivec2 at) {
    constexpr long version = 5L << 24;
    send("XdndEnter", version, long(atom("text/uri-list")), 0, 0);
    send("XdndPosition", 0, long(at.x) << 16 | at.y, CurrentTime, long(atom("XdndActionCopy")));
    const XClientMessageEvent status = wait_for("XdndStatus");
    if (!(status.data.l[1] & 1)) throw std::runtime_error("the window takes no files");
    send("XdndDrop", 0, CurrentTime, 0, 0);
    const XClientMessageEvent finished = wait_for("XdndFinished");
    if (!asked_) throw std::runtime_error("the window never asked what was dropped");
    // By the protocol its first bit tells; GLFW 3.3 puts the length of what it got there.
    if (finished.data.l[1] == 0) throw std::runtime_error("the window did not take what was dropped");
  }

 private:
  Atom atom(const char* name) { return XInternAtom(display_, name, False); }

  void send(const char* type, long b, long c, long d, long e) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(type);
    event.xclient.format = 32;
    const long data[] = {long(source_), b, c, d, e};
    for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = data[i];
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XSync(display_, False);
  }

  // Whoever is dropped on asks for the text in between.
  XClientMessageEvent wait_for(const char* type) {
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < std::chrono::seconds(60)) {
      XEvent event;
      if (XCheckTypedWindowEvent(display_, source_, ClientMessage, &event) &&
          event.xclient.message_type == atom(type))
        return event.xclient;
      if (XCheckTypedWindowEvent(display_, source_, SelectionRequest, &event))
        answer(event.xselectionrequest);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    throw std::runtime_error(std::string("the window sends no ") + type);
  }

  void answer(const XSelectionRequestEvent& request) {
    const bool known = request.target == atom("text/uri-list");
    if (known)
      XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                      reinterpret_cast<const unsigned char*>(uris_.data()), int(uris_.size()));
    asked_ = asked_ || known;
    XEvent event{};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request.requestor;
    event.xselection.selection = request.selection;
    event.xselection.target = request.target;
    event.xselection.property = known ? request.property : None;
    event.xselection.time = request.time;
    XSendEvent(display_, request.requestor, False, NoEventMask, &event);
    XSync(display_, False);
  }

  Display* display_;
  Window target_, source_ = 0;
  std::string uris_;
  bool asked_ = false;
};

}  // namespace

void drop_uris(Display* display, Window target, const std::string& uris, ivec2 at) {
  FileDrag(display, target, uris).drop(at);
}

}  // namespace plinian
