// A field that names a file, with a button that opens the file browser.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/window/studio.h"

namespace plinian::window {

/// What the widget "file .exr .png" of an attribute says of the files that it takes; empty: any.
std::vector<std::string> file_widget(const std::string& widget);

struct PathField {
  std::string name;                     // of the attribute: "plate.file"
  std::string typed;                    // as it stands there
  std::string path;                     // that this is, whole; empty where there is none
  std::vector<std::string> extensions;  // with their dots; empty: any
  bool saves = false;                   // the file need not exist
  float width = 80.0f;                  // [points]
  bool enabled = true;
};

/// What was typed. take: hears what is chosen in the browser, later.
std::optional<std::string> path_field(Studio& studio, const PathField& field,
                                      std::function<void(const std::string&)> take);

}  // namespace plinian::window
