// A field that names a grid of a .vdb file, with a list of those that the file has.
#pragma once

#include <optional>
#include <string>

#include "host/window/studio.h"

namespace plinian::window {

/// What the widget of an attribute says of it: "grid of file", "grid of file or none".
struct GridWidget {
  std::string file;  // attribute that names the file
  bool or_none = false;
};
std::optional<GridWidget> grid_widget(const std::string& widget);

/// What a volumeRead has read where such an attribute of it is empty: "density", "none", "smoke[*]". Empty
/// where that is not known, as where the attribute names one itself. Computes nothing.
std::string grid_by_name(graph::Session& session, const graph::Plug& attribute, const GridWidget& widget);

/// name: of the field, for the trace. by_name: as of grid_by_name. path: the file, whole; empty where there
/// is none. What was typed or chosen. Where the file cannot be listed it is a field of text alone.
std::optional<std::string> grid_field(Studio& studio, const std::string& name, const std::string& now,
                                      const std::string& by_name, const GridWidget& widget,
                                      const std::string& path, float width, bool enabled);

}  // namespace plinian::window
