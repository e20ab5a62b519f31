// Choosing a file, in the window: places, a list, a name.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "host/window/files/file_browser.h"
#include "host/window/panels/file_table.h"
#include "host/window/panels/place_list.h"
#include "host/window/studio.h"

struct ImGuiInputTextCallbackData;

namespace plinian::window {

class FileDialog {
 public:
  /// wake: as of FileBrowser.
  explicit FileDialog(std::function<void()> wake);

  /// question.folder: where it saves, and where a file is named; else, where it opens, that only counts the
  /// first time. take: hears the path that was chosen.
  void open(Studio& studio, FileQuestion question, std::function<void(const std::string&)> take);
  /// Within the window that it is to stand over; always the same one while it is open.
  void show(Studio& studio);
  bool is_open() const { return opens_ || is_open_; }

 private:
  void show_head(Studio& studio);
  void show_list(Studio& studio);
  void show_line(Studio& studio);
  void show_foot(Studio& studio);
  void show_name(Studio& studio, float width);
  void take_keys();
  void take();
  void close();
  int edit(ImGuiInputTextCallbackData& data);

  FileBrowser browser_;
  PlaceList places_;
  FileTable table_;
  std::map<std::string, std::filesystem::path> folders_;  // where one was last, by the question's title
  std::function<void(const std::string&)> take_;
  char path_[4096] = "", name_[4096] = "";
  bool opens_ = false, is_open_ = false;
  bool path_active_ = false;  // keys are that field's
  bool reloads_ = false;      // the name is another one while it is typed in
  int focused_ = -2;          // picture in which the name asked for the keys
  std::string listed_;        // folder, as the trace was told
};

}  // namespace plinian::window
