// A driver that says it has reset the GPU where `resetGpu` asks for it, once to each context: what is rare on
// a real one.
#include <epoxy/gl.h>

#include <atomic>
#include <thread>

#include "host/sdk/plugin.h"

namespace {

using namespace plinian::sdk;

std::thread::id interface;
std::atomic<bool> window_to_lose{false}, renderer_to_lose{false};

GLenum APIENTRY made_up_status() {
  std::atomic<bool>& to_lose = std::this_thread::get_id() == interface ? window_to_lose : renderer_to_lose;
  return to_lose.exchange(false) ? GL_INNOCENT_CONTEXT_RESET : GL_NO_ERROR;
}

void initialise(Plugin& plugin) {
  interface = std::this_thread::get_id();
  epoxy_glGetGraphicsResetStatus = made_up_status;
  plugin.add(Command{.name = "resetGpu", .help = "Says that the GPU was reset.", .run = [](Call&) {
                       window_to_lose = renderer_to_lose = true;
                     }});
}

}  // namespace

PLINIAN_PLUGIN("reset", "1.0", "A. Artist", "command:resetGpu", initialise);
