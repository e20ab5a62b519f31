// Renderers by name.
#include "host/cli/renderers.h"

#include <stdexcept>

#include "core/integrate/dual_march.h"
#ifdef PLINIAN_WITH_CPU_MAPS
#include "core/integrate/map_renderer.h"
#endif
#include "host/cli/console.h"
#ifdef PLINIAN_WITH_GL
#include "viewport/gl_renderer.h"
#endif

namespace plinian::cli {

std::vector<std::string> renderer_names() {
  return {"gl", "cpu", "reference"};
}

std::unique_ptr<Renderer> make_renderer(const std::string& name, const RendererOptions& options) {
#ifdef PLINIAN_WITH_GL
  if (name == "gl") return make_gl_renderer();
#endif
#ifdef PLINIAN_WITH_CPU_MAPS
  if (name == "cpu") return make_map_renderer();
#endif
  if (name == "reference") {
    DualMarchOptions march;
    if (options.reference_tolerance > 0.0) march.tolerance = options.reference_tolerance;
    return std::make_unique<DualMarch>(march);
  }
  throw std::runtime_error(name + ": this program was built without that renderer");
}

NamedRenderer choose_renderer(const std::string& name, const RendererOptions& options) {
  if (name != "auto") return {name, make_renderer(name, options)};
  for (const std::string& next : renderer_names()) try {
      return {next, make_renderer(next, options)};
    } catch (const std::runtime_error& reason) {
      note(next + " is passed over: " + reason.what());
    }
  throw std::runtime_error("no renderer runs on this machine");
}

}  // namespace plinian::cli
