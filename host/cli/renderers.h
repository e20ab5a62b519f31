// Renderers by the name that the command line gives them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/scene/renderer.h"

namespace plinian::cli {

/// gl, cpu, reference.
std::vector<std::string> renderer_names();

struct RendererOptions {
  double reference_tolerance = 0.0;  // [-] of the reference's convergence; 0: its default
};

/// Throws std::runtime_error (one line) where it cannot run on this machine.
std::unique_ptr<Renderer> make_renderer(const std::string& name, const RendererOptions& options = {});

/// A renderer by name; "auto" is gl, or cpu with a note where there is no OpenGL 4.5.
struct NamedRenderer {
  std::string name;
  std::unique_ptr<Renderer> renderer;
};
NamedRenderer choose_renderer(const std::string& name, const RendererOptions& options = {});

}  // namespace plinian::cli
