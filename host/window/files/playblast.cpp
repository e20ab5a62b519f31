// Starts, listens, tidies up.
#include "host/window/files/playblast.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "core/files/atomic_file.h"
#include "core/image/image_io.h"
#include "core/media/frame_sequence.h"

extern char** environ;

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

std::string find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const fs::path program = fs::path(folder) / name; access(program.c_str(), X_OK) == 0)
      return program.string();
  return "";
}

bool is_film(const std::string& output) {
  return output.ends_with(".mp4");
}

std::string last_line(const std::string& text) {
  std::istringstream lines(text);
  std::string line, last;
  while (std::getline(lines, line))
    if (!line.empty()) last = line;
  return last;
}

}  // namespace

std::string as_format(const std::string& output, const std::string& extension) {
  const auto pattern = FramePattern::parse(output);
  std::string path = pattern && is_film(extension) ? pattern->unnumbered() : output;
  // "shot.####" has none yet: what it ends in is the place of the number.
  const std::string ends = fs::path(path).extension().string();
  if (ends.size() < 2 || std::string_view("#%$").find(ends[1]) == std::string_view::npos)
    path = fs::path(path).replace_extension().string();
  if (is_film(output) && !is_film(extension) && !pattern) path += ".####";
  return path + extension;
}

std::string view_words(const ViewSettings& view) {
  if (view.view == View::srgb) return "srgb";
  if (view.view == View::filmic) return "filmic";
  return view.ocio_display.empty() ? "ocio" : "ocio:" + view.ocio_display + "/" + view.ocio_view;
}

bool Playblast::has_ffmpeg() {
  return !find_program("ffmpeg").empty();
}

Playblast::~Playblast() {
  if (child_ > 0) {
    kill(child_, SIGTERM);
    int status = 0;
    for (int i = 0; i < 200 && waitpid(child_, &status, WNOHANG) == 0; ++i) usleep(10'000);
    if (waitpid(child_, &status, WNOHANG) == 0) {
      kill(child_, SIGKILL);
      waitpid(child_, &status, 0);
    }
  }
  tidy_up();
}

void Playblast::start(const PlayblastSettings& settings, const std::string& scene, const fs::path& folder) {
  if (is_running()) throw std::runtime_error("a playblast is running: Esc stops it");
  if (settings.last < settings.first)
    throw std::runtime_error(fmt::format("playblast: frames {} to {}: the last one comes before the first",
                                         settings.first, settings.last));
  const bool film = is_film(settings.output);
  if (film && !has_ffmpeg())
    throw std::runtime_error("playblast: " + settings.output +
                             ": ffmpeg is not installed; take .png or .exr");
  // What cannot be written is told before anything is rendered.
  if (film)
    check_writable(settings.output);
  else
    check_output(settings.output, {});
  settings_ = settings;
  done_ = left_ = 0;
  cancelled_ = films_ = false;
  said_.clear();
  scene_ = folder / fmt::format(".playblast-{}.plinian", getpid());
  try {
    write_file(scene_.string(), std::string_view(scene));
    begin();
  } catch (...) {
    tidy_up();
    throw;
  }
}

void Playblast::begin() {
  std::string output = settings_.output;
  if (is_film(output)) {
    frames_folder_ = fs::temp_directory_path() / fmt::format("plinian-playblast-{}", getpid());
    fs::create_directories(frames_folder_);
    output = (frames_folder_ / "frame.######.png").string();
  }
  run({program_.empty() ? fs::read_symlink("/proc/self/exe").string() : program_, "render", scene_.string(),
       "--frames", fmt::format("{}-{}", settings_.first, settings_.last), "-o", output, "--preset",
       settings_.quality, "--view", view_words(settings_.view), "--exposure",
       fmt::format("{}", settings_.view.exposure), "--gamma", fmt::format("{}", settings_.view.gamma)});
}

// Beside the frames, and from there to its place: nobody finds half a film.
void Playblast::begin_film() {
  ::close(words_from_);
  words_from_ = -1;
  said_.clear();
  films_ = true;
  // 4:2:0 wants even sides; a line less is not seen, a black one is. Players take a film for Rec.709, which
  // the converter does not by itself; fine structure in smoke wants more than the usual quality.
  run({find_program("ffmpeg"),
       "-y",
       "-loglevel",
       "error",
       "-framerate",
       fmt::format("{}", settings_.rate),
       "-start_number",
       std::to_string(settings_.first),
       "-i",
       (frames_folder_ / "frame.%06d.png").string(),
       "-vf",
       "crop=trunc(iw/2)*2:trunc(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv",
       "-pix_fmt",
       "yuv420p",
       "-colorspace",
       "bt709",
       "-color_primaries",
       "bt709",
       "-color_trc",
       "iec61966-2-1",
       "-color_range",
       "tv",
       "-crf",
       "16",
       "-movflags",
       "+faststart",
       (frames_folder_ / "film.mp4").string()});
}

void Playblast::run(const std::vector<std::string>& words) {
  std::vector<std::string> kept = words;
  std::vector<char*> argv;
  for (std::string& word : kept) argv.push_back(word.data());
  argv.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("playblast: no pipe");
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, ends[1], STDERR_FILENO);
  const int failed = posix_spawn(&child_, argv[0], &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  ::close(ends[1]);
  words_from_ = ends[0];
  if (failed) {
    child_ = -1;
    throw std::runtime_error(words.front() + " cannot be started");
  }
  // Whoever sits before the window goes first.
  setpriority(PRIO_PROCESS, id_t(child_), 10);
}

void Playblast::cancel() {
  if (!is_running() || cancelled_) return;
  cancelled_ = true;
  kill(child_, SIGTERM);
}

void Playblast::read_words() {
  char buffer[4096];
  for (ssize_t got; (got = ::read(words_from_, buffer, sizeof buffer)) > 0;)
    said_.append(buffer, std::size_t(got));
  if (films_) return;
  // A line for each frame that is made, or was there already.
  done_ = left_ = 0;
  std::istringstream lines(said_);
  for (std::string line; std::getline(lines, line);) {
    const bool left = line.find(": there already") != line.npos;
    if (left || line.find(" passes in ") != line.npos) ++done_;
    if (left) ++left_;
  }
}

void Playblast::tidy_up() {
  std::error_code ignored;
  if (!scene_.empty()) fs::remove(scene_, ignored);
  if (!frames_folder_.empty()) fs::remove_all(frames_folder_, ignored);
  scene_.clear();
  frames_folder_.clear();
  if (words_from_ >= 0) ::close(words_from_);
  words_from_ = -1;
}

Playblast::End Playblast::ended(int status) {
  const bool good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  std::string line = last_line(said_);
  const std::string prefix = "plinian: error: ";
  if (line.starts_with(prefix)) line = line.substr(prefix.size());
  if (cancelled_ && films_) return {false, "playblast stopped: there is no film"};
  if (cancelled_) return {false, fmt::format("playblast stopped after {} of {} frames", done_, frames())};
  if (!good) return {false, "playblast: " + (line.empty() ? "the renderer ended without a word" : line)};
  return {true, fmt::format("playblast: {} frames, {}{}", frames(), settings_.output,
                            left_ > 0 ? fmt::format("; {} were there already", left_) : "")};
}

std::vector<Playblast::End> Playblast::poll() {
  if (!is_running()) return {};
  read_words();
  int status = 0;
  if (waitpid(child_, &status, WNOHANG) != child_) return {};
  read_words();
  child_ = -1;
  End end = ended(status);
  if (end.succeeded && is_film(settings_.output)) try {
      if (!films_) {
        begin_film();
        return {};
      }
      write_file(settings_.output, [&](const std::string& there) {
        fs::copy_file(frames_folder_ / "film.mp4", there, fs::copy_options::overwrite_existing);
      });
    } catch (const std::exception& error) {
      end = {false, std::string("playblast: ") + error.what()};
    }
  tidy_up();
  return {end};
}

}  // namespace plinian::window
