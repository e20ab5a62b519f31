// The list of a file browser: icons, names, sizes, times, and headings to sort by.
#pragma once

#include <optional>

#include "core/shared/glue.h"
#include "host/window/files/file_browser.h"

namespace plinian::window {

class Trace;

class FileTable {
 public:
  /// What was done to a row in this turn.
  struct Doing {
    std::optional<std::size_t> clicked;
    bool twice = false;
  };
  /// size: [points] of the whole. Orders the browser's rows where a heading is clicked; the rest is the
  /// caller's.
  Doing show(Trace& trace, FileBrowser& browser, vec2 size);
  /// Scrolls to what is chosen, or to the top, with the next picture.
  void follow() { follows_ = true; }
  /// Rows that have room, as of the last picture.
  int page() const { return page_; }

 private:
  void show_headings(Trace& trace, FileBrowser& browser, float width);
  void scroll_to(const FileBrowser& browser, float row_height);

  bool follows_ = false;
  int page_ = 10;
};

}  // namespace plinian::window
