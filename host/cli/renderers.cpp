// Renderers by name.
#include "host/cli/renderers.h"

#include <stdexcept>

#include "core/integrate/dual_march.h"
#include "core/integrate/map_renderer.h"
#include "host/cli/console.h"
#include "viewport/gl_renderer.h"

namespace plinian::cli {

std::vector<std::string> renderer_names() {
  return {"gl", "cpu", "reference"};
}

std::unique_ptr<Renderer> make_renderer(const std::string& name, const RendererOptions& options) {
  if (name == "gl") return make_gl_renderer();
  if (name == "cpu") return make_map_renderer();
  if (name == "reference") {
    DualMarchOptions march;
    if (options.reference_tolerance > 0.0) march.tolerance = options.reference_tolerance;
    return std::make_unique<DualMarch>(march);
  }
  throw std::runtime_error(name + ": no such renderer; there are: gl, cpu, reference");
}

NamedRenderer choose_renderer(const std::string& name, const RendererOptions& options) {
  if (name != "auto") return {name, make_renderer(name, options)};
  try {
    return {"gl", make_renderer("gl", options)};
  } catch (const std::runtime_error& reason) {
    note(std::string("rendering on the CPU: ") + reason.what());
    return {"cpu", make_renderer("cpu", options)};
  }
}

}  // namespace plinian::cli
