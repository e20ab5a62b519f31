// Choosing a file: where one is, what is listed, and what Enter does. Without a window; FileDialog shows it.
//
// Folders are read on a thread of their own: a large or slow one holds nobody up.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/window/files/file_list.h"
#include "host/window/platform/newest_worker.h"

namespace plinian::window {

/// What is asked for.
struct FileQuestion {
  std::string title{};
  std::filesystem::path folder{};         // to begin in; empty: where one was last, or the working folder
  std::string name{};                     // to begin with; where it opens, to be chosen if it is there
  std::vector<std::string> extensions{};  // with their dots; the first is put on where one saves without any
  bool saves = false;                     // the file need not exist
};

/// A question, and who hears the answer.
struct FileWish {
  FileQuestion question;
  std::function<void(const std::string&)> take;
};

class FileBrowser {
 public:
  /// wake: called on a thread of the browser's when a folder has been read; must not block.
  explicit FileBrowser(std::function<void()> wake);
  ~FileBrowser();

  void begin(FileQuestion question);
  const FileQuestion& question() const { return question_; }

  /// Takes over what was read. To be called once a turn; returns whether anything changed.
  bool update();
  /// Whether what is listed is still another folder's.
  bool is_reading() const { return listing_.folder != folder_; }
  const std::filesystem::path& folder() const { return folder_; }
  /// Leaves the list as it is until the other folder is read.
  void go_to(const std::filesystem::path& folder);
  void go_up();

  /// The lines of the list: folders, files and sequences that the letters leave over.
  const std::vector<FileEntry>& rows() const { return rows_; }
  FileOrder order() const { return order_; }  // kept for the next question
  void set_order(FileOrder order);
  std::optional<std::size_t> chosen() const { return chosen_; }
  void choose(std::size_t row);
  /// Up and down the list, to its ends. Begins at the top.
  void step(int rows);

  /// What stands in the field of the name: where a file is opened, letters to look for, or a path; where one
  /// is saved, its name.
  const std::string& text() const { return text_; }
  /// pasted: a path that is there is gone to at once.
  void type(const std::string& text, bool pasted = false);
  /// What is chosen or typed, where that is a file; a folder is gone into. Where a file would be written over
  /// it is asked first (overwrites()), and what cannot be is said (line()).
  std::optional<std::filesystem::path> take();
  /// The file that is there already, until take() says that it may go or anything else is done.
  const std::filesystem::path& overwrites() const { return overwrites_; }
  void keep_it() { overwrites_.clear(); }

  /// What there is to be said, in one line.
  struct Line {
    std::string text;
    bool is_problem = false;
    bool is_why_empty = false;  // it stands for rows, of which there are none
  };
  Line line() const;

 private:
  struct Question {
    std::filesystem::path folder;
    std::vector<std::string> extensions;
    std::uint64_t number = 0;
  };
  struct Answer {
    FolderListing listing;
    std::uint64_t number = 0;
    double seconds = 0.0;
  };
  void ask();
  void fill();
  void choose_named(const std::string& name);
  void refuse(std::string line);
  bool visit(const std::filesystem::path& path);
  std::optional<std::filesystem::path> take_path(const std::filesystem::path& path);

  FileQuestion question_;
  std::filesystem::path folder_, overwrites_;
  std::string text_, letters_;  // letters_: of text_, that a name must hold
  FolderListing listing_;
  std::vector<FileEntry> rows_;
  FileOrder order_;
  std::optional<std::size_t> chosen_;
  std::string wanted_;   // is to be chosen when it is listed
  std::string problem_;  // of what was done last
  std::uint64_t number_ = 0, shown_number_ = 0;
  double read_seconds_ = 0.0;  // that the folder took
  std::chrono::steady_clock::time_point asked_{};
  std::atomic<std::uint64_t> newest_{0};   // question; older ones are given up
  NewestWorker<Question, Answer> worker_;  // last: it uses the rest
};

}  // namespace plinian::window
