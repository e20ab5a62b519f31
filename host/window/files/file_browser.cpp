// A folder, a list, a name.
#include "host/window/files/file_browser.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/files/atomic_file.h"
#include "core/media/frame_sequence.h"
#include "host/graph/graph_error.h"
#include "host/window/files/typed_path.h"

namespace plinian::window {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

namespace {

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

bool is_there(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path, error)) return true;
  const auto pattern = FramePattern::parse(path.string());
  return pattern && !pattern->frames_on_disk().empty();
}

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

FileBrowser::FileBrowser(std::function<void()> wake)
    : worker_(
          [this](const Question& question) {
            const auto begin = Clock::now();
            Answer answer{
                list_folder(question.folder, question.extensions, [&] { return newest_ == question.number; }),
                question.number};
            answer.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
            return answer;
          },
          std::move(wake)) {}

FileBrowser::~FileBrowser() {
  newest_ = 0;
}

void FileBrowser::begin(FileQuestion question) {
  question_ = std::move(question);
  std::error_code error;
  fs::path folder = question_.folder.empty() ? folder_ : question_.folder;
  if (folder.empty()) folder = fs::current_path(error);
  listing_ = {};
  rows_.clear();
  wanted_.clear();
  go_to(folder);
  type(question_.saves ? question_.name : "");
  if (question_.saves) return;
  wanted_ = question_.name;
  if (!is_reading()) fill();
}

void FileBrowser::go_to(const fs::path& folder) {
  std::error_code error;
  folder_ = tidy_folder(fs::absolute(folder, error));
  problem_.clear();
  overwrites_.clear();
  chosen_.reset();
  wanted_.clear();
  if (!question_.saves) text_.clear();
  letters_.clear();
  if (!is_reading()) fill();
  ask();
}

void FileBrowser::go_up() {
  if (folder_ == folder_.root_path()) return;
  const std::string from = folder_.filename().string();
  go_to(folder_.parent_path());
  wanted_ = from;
}

void FileBrowser::ask() {
  newest_ = ++number_;
  asked_ = Clock::now();
  worker_.ask({folder_, question_.extensions, number_});
}

bool FileBrowser::update() {
  const auto answer = worker_.answer();
  if (answer && answer->number == number_ && shown_number_ != number_) {
    shown_number_ = number_;
    read_seconds_ = answer->seconds;
    if (answer->listing == listing_) return false;
    listing_ = answer->listing;
    fill();
    return true;
  }
  // Files come and go while one looks. What takes long is not read over and over.
  constexpr double quick_s = 0.05;
  if (number_ == shown_number_ && read_seconds_ < quick_s && Clock::now() - asked_ > std::chrono::seconds(2))
    ask();
  return false;
}

void FileBrowser::fill() {
  const std::string before = !wanted_.empty() ? wanted_ : chosen_ ? rows_[*chosen_].name : "";
  rows_.clear();
  for (const FileEntry& entry : listing_.entries)
    if (matches(entry.name, letters_)) rows_.push_back(entry);
  sort_entries(rows_, order_);
  choose_named(before);
  if (chosen_) wanted_.clear();
  // Enter takes the first that has the letters.
  if (!chosen_ && !letters_.empty() && !rows_.empty()) chosen_ = 0;
}

void FileBrowser::choose_named(const std::string& name) {
  // Sequences are spelled in several ways.
  const auto pattern = FramePattern::parse(name);
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const FileEntry& entry) {
    if (entry.name == name) return true;
    if (!pattern || entry.kind != FileEntry::Kind::sequence) return false;
    const auto other = FramePattern::parse(entry.name);
    return other && other->path(entry.first) == pattern->path(entry.first);
  });
  chosen_.reset();
  if (found != rows_.end()) chosen_ = std::size_t(found - rows_.begin());
}

void FileBrowser::set_order(FileOrder order) {
  order_ = order;
  const std::string before = chosen_ ? rows_[*chosen_].name : "";
  sort_entries(rows_, order_);
  choose_named(before);
}

void FileBrowser::choose(std::size_t row) {
  if (row >= rows_.size() || is_reading()) return;
  chosen_ = row;
  problem_.clear();
  overwrites_.clear();
  wanted_.clear();
  if (question_.saves && !rows_[row].is_folder()) text_ = rows_[row].name;
}

void FileBrowser::step(int rows) {
  if (rows_.empty() || rows == 0) return;
  const int last = int(rows_.size()) - 1;
  const int from = chosen_ ? int(*chosen_) : rows > 0 ? -1 : last + 1;
  choose(std::size_t(std::clamp(from + rows, 0, last)));
}

void FileBrowser::type(const std::string& text, bool pasted) {
  text_ = text;
  problem_.clear();
  overwrites_.clear();
  std::optional<fs::path> path;
  try {
    path = typed_path(text, folder_);
  } catch (const graph::GraphError&) {
    // Said when it is taken.
  }
  letters_ = question_.saves || path ? "" : text;
  if (question_.saves && !path) question_.name = text;
  chosen_.reset();
  wanted_ = text;
  fill();
  wanted_.clear();
  if (pasted && path) visit(*path);
}

// A path that was pasted is shown in its folder. Returns whether it is there.
bool FileBrowser::visit(const fs::path& path) {
  if (is_folder(path)) {
    go_to(path);
    if (question_.saves) text_ = question_.name;
    return true;
  }
  if (question_.saves ? !is_folder(path.parent_path()) : !is_there(path)) {
    refuse(path.string() + ": there is no such file or folder");
    return false;
  }
  const std::string text = std::exchange(text_, "");
  if (path.parent_path() != folder_) go_to(path.parent_path());
  text_ = question_.saves ? path.filename().string() : text;
  wanted_ = path.filename().string();
  if (!is_reading()) fill();
  return true;
}

void FileBrowser::refuse(std::string line) {
  problem_ = std::move(line);
}

std::optional<fs::path> FileBrowser::take() {
  problem_.clear();
  try {
    if (const auto path = typed_path(text_, folder_)) {
      if (!is_folder(*path)) return take_path(*path);
      visit(*path);
      return std::nullopt;
    }
  } catch (const graph::GraphError& error) {
    refuse(error.what());
    return std::nullopt;
  }
  if (chosen_ && !is_reading() && (rows_[*chosen_].is_folder() || !question_.saves))
    return take_path(folder_ / rows_[*chosen_].name);
  if (text_.empty()) return std::nullopt;
  return take_path(folder_ / text_);
}

std::optional<fs::path> FileBrowser::take_path(const fs::path& typed) {
  fs::path path = typed;
  if (is_folder(path)) {
    go_to(path);
    return std::nullopt;
  }
  if (!question_.saves) {
    if (is_there(path)) return path;
    refuse(path.string() + ": there is no such file");
    return std::nullopt;
  }
  if (path.extension().empty() && !question_.extensions.empty()) path += question_.extensions.front();
  try {
    check_writable(path.string());
  } catch (const FileError& error) {
    refuse(error.what());
    return std::nullopt;
  }
  if (is_there(path) && overwrites_ != path) {
    overwrites_ = path;
    return std::nullopt;
  }
  overwrites_.clear();
  return path;
}

FileBrowser::Line FileBrowser::line() const {
  if (!problem_.empty()) return {problem_, true};
  if (is_reading()) {
    constexpr auto soon = std::chrono::milliseconds(200);
    return {Clock::now() - asked_ > soon ? "reading the folder ..." : "", false};
  }
  if (!listing_.problem.empty()) return {listing_.problem, true, true};
  using Kind = FileEntry::Kind;
  const auto how_many = [](const std::vector<FileEntry>& entries, Kind kind) {
    return std::size_t(std::count_if(entries.begin(), entries.end(),
                                     [&](const FileEntry& entry) { return entry.kind == kind; }));
  };
  if (how_many(listing_.entries, Kind::folder) == listing_.entries.size() && letters_.empty())
    return {question_.saves ? "No " + list_of(question_.extensions) + " here yet"
            : question_.extensions.empty()
                ? "There is no file here"
                : "Nothing to be opened here; looked for " + list_of(question_.extensions),
            false, rows_.empty()};
  if (rows_.empty()) return {fmt::format("Nothing here has \"{}\" in its name", letters_), false, true};
  std::string text;
  for (const auto& [kind, what] : {std::pair(Kind::folder, "folder"), std::pair(Kind::sequence, "sequence"),
                                   std::pair(Kind::file, "file")})
    if (const std::size_t count = how_many(rows_, kind); count > 0)
      text += (text.empty() ? "" : ", ") + counted(count, what);
  if (rows_.size() != listing_.entries.size()) text += fmt::format(", of {} in all", listing_.entries.size());
  return {text, false};
}

}  // namespace plinian::window
