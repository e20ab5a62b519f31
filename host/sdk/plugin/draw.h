// Draw overrides in C++: what only a viewport shows of a node.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "host/sdk/abi.h"
#include "host/sdk/plugin/context.h"

namespace plinian {
namespace PLINIAN_HIDDEN sdk {

/// The GL of the host, on its thread.
class Gl {
 public:
  explicit Gl(const PlinianGl& table) : table_(table) {}
  /// The address of a GL function: `gl.load(draw_arrays, "glDrawArrays")`. Throws Error where there is
  /// none.
  template <class Function>
  void load(Function& function, const char* name) const {
    void* found = table_.function(table_.self, name);
    if (!found) throw Error(std::string("there is no GL function ") + name);
    function = reinterpret_cast<Function>(found);
  }

 private:
  const PlinianGl& table_;
};

/// What a draw function is given; the fields are those of PlinianDrawContext.
struct DrawContext {
  const PlinianDrawContext& plain;
  Gl gl;

  explicit DrawContext(const PlinianDrawContext& context) : plain(context), gl(*context.gl) {}
  /// For glUniformMatrix4fv.
  std::array<float, 16> clip_from_object() const {
    const Matrix matrix =
        product(product(plain.clip_from_view, plain.view_from_world).data(), plain.world_from_object);
    std::array<float, 16> result{};
    for (std::size_t i = 0; i < 16; ++i) result[i] = float(matrix[i]);
    return result;
  }
  static Matrix product(const double* a, const double* b) {
    Matrix result{};
    for (std::size_t column = 0; column < 4; ++column)
      for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t k = 0; k < 4; ++k) result[column * 4 + row] += a[k * 4 + row] * b[column * 4 + k];
    return result;
  }
};

/// Any draw override; make one with draw_override.
struct AnyDraw {
  std::string affected_by{};
  std::function<PlinianData(Context&)> prepare{};
  std::function<bool(const Gl&, const void* data, void** resources)> upload{};
  std::function<void(const DrawContext&, const void* data, void* resources)> draw{};
  std::function<void(const Gl&, void* resources)> release{};
  std::function<std::optional<double>(const DrawContext&, const void* data, float x, float y)> hit{};
};

/// A draw override of draw data `Data` and GL objects `Resources`, which is made empty.
template <class Data, class Resources>
struct Draw {
  std::string affected_by{};  // attributes that drawing depends on, separated by spaces; empty: all inputs
  std::function<std::unique_ptr<const Data>(Context&)> prepare{};           // on any thread
  std::function<bool(const Gl&, const Data&, Resources&)> upload{};         // true when done; else again soon
  std::function<void(const DrawContext&, const Data&, Resources&)> draw{};  // throws to fail
  std::function<void(const Gl&, Resources&)> release{};
  /// Whether a pixel is on it, and how far away that is [world]. May be empty.
  std::function<std::optional<double>(const DrawContext&, const Data&, float x, float y)> hit{};
};

template <class Data, class Resources>
AnyDraw draw_override(Draw<Data, Resources> of) {
  if (!of.prepare)
    throw Error("a draw override needs a function that prepares what it draws: prepare is empty");
  AnyDraw any;
  any.affected_by = of.affected_by;
  any.prepare = [prepare = of.prepare](Context& context) {
    std::unique_ptr<const Data> data = prepare(context);
    return PlinianData{
        sizeof(PlinianData), nullptr, data.release(),
        sizeof(Data),        0,       [](const void* p) { delete static_cast<const Data*>(p); }};
  };
  any.upload = [upload = of.upload](const Gl& gl, const void* data, void** resources) {
    if (!*resources) *resources = new Resources();
    return !upload || upload(gl, *static_cast<const Data*>(data), *static_cast<Resources*>(*resources));
  };
  any.draw = [draw = of.draw](const DrawContext& context, const void* data, void* resources) {
    if (draw) draw(context, *static_cast<const Data*>(data), *static_cast<Resources*>(resources));
  };
  any.release = [release = of.release](const Gl& gl, void* resources) {
    const std::unique_ptr<Resources> owned(static_cast<Resources*>(resources));
    if (release && owned) release(gl, *owned);
  };
  if (of.hit)
    any.hit = [hit = of.hit](const DrawContext& context, const void* data, float x, float y) {
      return hit(context, *static_cast<const Data*>(data), x, y);
    };
  return any;
}

namespace detail {

// draw: stays where it is until the plug-in is uninitialised.
inline PlinianDraw plain(AnyDraw& draw) {
  PlinianDraw result{};
  result.size = sizeof(result);
  result.affected_by = draw.affected_by.empty() ? nullptr : draw.affected_by.c_str();
  result.user = &draw;
  result.prepare = [](void* user, const PlinianCompute* table, PlinianContext* context, PlinianData* data) {
    guarded(
        [&] {
          Context wrapped(*table, context);
          *data = static_cast<AnyDraw*>(user)->prepare(wrapped);
        },
        [&](const char* message) { table->fail(context, message); });
  };
  result.upload = [](void* user, const PlinianGl* gl, const void* data, void** resources) {
    int done = -1;
    guarded([&] { done = static_cast<AnyDraw*>(user)->upload(Gl(*gl), data, resources); },
            [&](const char* message) { gl->fail(gl->self, message); });
    return done;
  };
  result.draw = [](void* user, const PlinianDrawContext* context, const void* data, void* resources) {
    int success = 0;
    guarded(
        [&] {
          static_cast<AnyDraw*>(user)->draw(DrawContext(*context), data, resources);
          success = 1;
        },
        [&](const char* message) { context->gl->fail(context->gl->self, message); });
    return success;
  };
  result.release = [](void* user, const PlinianGl* gl, void* resources) {
    guarded([&] { static_cast<AnyDraw*>(user)->release(Gl(*gl), resources); },
            [&](const char* message) { gl->fail(gl->self, message); });
  };
  if (draw.hit)
    result.hit = [](void* user, const PlinianDrawContext* context, const void* data, float x, float y,
                    double* distance) {
      int success = 0;
      guarded(
          [&] {
            const auto found = static_cast<AnyDraw*>(user)->hit(DrawContext(*context), data, x, y);
            success = found.has_value();
            if (found) *distance = *found;
          },
          [&](const char* message) { context->gl->fail(context->gl->self, message); });
      return success;
    };
  return result;
}

}  // namespace detail

}  // namespace sdk
}  // namespace plinian
