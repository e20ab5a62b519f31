// The tree keeps to its own rules: who may include whom, and every source is built.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace plinian {
namespace {

namespace fs = std::filesystem;
const fs::path root = PLINIAN_SOURCE_DIR;

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Every file with one of the extensions under a folder, by its path in the tree.
std::vector<std::string> files_under(const std::string& folder, const std::set<std::string>& extensions) {
  std::vector<std::string> files;
  if (!fs::exists(root / folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder))
    if (entry.is_regular_file() && extensions.contains(entry.path().extension().string()))
      files.push_back(fs::relative(entry.path(), root).string());
  return files;
}

const std::set<std::string> sources = {".h", ".cpp", ".comp", ".glsl"};

// The folder that decides what a file may use.
std::string layer_of(const std::string& path) {
  for (const char* layer :
       {"host/cli/", "host/window/", "host/graph/", "host/sdk/", "host/nodes/", "host/scene/", "host/draw/",
        "host/plugins/", "host/", "viewport/", "core/", "tests/"})
    if (path.starts_with(layer)) return std::string(layer);
  return "";
}

// What the files of a layer may include of ours, beside their own layer.
const std::map<std::string, std::set<std::string>> allowed = {
    {"core/", {}},
    {"viewport/", {"core/"}},
    {"host/graph/", {"core/"}},
    {"host/sdk/", {"core/", "host/graph/"}},
    {"host/nodes/", {"core/", "host/graph/", "host/sdk/"}},
    {"host/plugins/", {"host/sdk/"}},
    {"host/scene/", {"core/", "host/graph/", "host/sdk/", "host/nodes/"}},
    {"host/draw/", {"core/", "viewport/", "host/graph/", "host/sdk/"}},
    {"host/", {"core/", "host/graph/", "host/sdk/", "host/nodes/", "host/scene/"}},
    {"host/cli/",
     {"core/", "viewport/", "host/", "host/graph/", "host/sdk/", "host/nodes/", "host/scene/", "host/draw/",
      "host/window/"}},
    {"host/window/",
     {"core/", "viewport/", "host/", "host/graph/", "host/sdk/", "host/nodes/", "host/scene/", "host/draw/"}},
    {"tests/",
     {"core/", "viewport/", "host/", "host/graph/", "host/sdk/", "host/nodes/", "host/scene/", "host/draw/",
      "host/cli/", "host/window/"}},
};

// Includes that are forbidden, one line each.
std::vector<std::string> forbidden_includes(const std::string& path, const std::string& text) {
  static const std::regex include(R"re((?:^|\n)\s*#\s*include\s*"([^"]+)")re");
  std::vector<std::string> found;
  const std::string layer = layer_of(path);
  for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match) {
    const std::string used = (*match)[1], other = layer_of(used);
    if (!other.empty() && other != layer && !allowed.at(layer).contains(other))
      found.push_back(path + " includes " + used);
  }
  return found;
}

TEST(Structure, AForbiddenIncludeWouldBeSeen) {
  EXPECT_EQ(forbidden_includes("core/x.h", "#include \"viewport/gl/y.h\"\n").size(), 1u);
  EXPECT_EQ(forbidden_includes("core/x.h", "\n  #  include \"host/cli/y.h\"\n").size(), 1u);
  EXPECT_EQ(forbidden_includes("viewport/x.h", "#include \"host/y.h\"").size(), 1u);
  EXPECT_EQ(forbidden_includes("host/graph/x.h", "#include \"viewport/y.h\"").size(), 1u);
  EXPECT_EQ(forbidden_includes("host/cli/x.h", "#include \"viewport/y.h\"\n#include <vector>").size(), 0u);
  EXPECT_EQ(forbidden_includes("viewport/x.h", "#include \"core/y.h\"\n").size(), 0u);
}

TEST(Structure, IncludesPointOneWayCoreViewportHost) {
  std::size_t files = 0;
  for (const char* folder : {"core", "viewport", "host", "tests"})
    for (const std::string& path : files_under(folder, sources)) {
      ++files;
      for (const std::string& line : forbidden_includes(path, text_of(root / path))) ADD_FAILURE() << line;
    }
  EXPECT_GT(files, 50u);
}

// What plug-ins include is installed alone, so it may use nothing else of ours.
TEST(Structure, PluginHeadersUseNothingButOneAnother) {
  const std::regex include(R"re(#\s*include\s*"([^"]+)")re");
  std::vector<std::string> headers = files_under("host/sdk/abi", {".h"});
  for (const std::string& path : files_under("host/sdk/plugin", {".h"})) headers.push_back(path);
  headers.insert(headers.end(), {"host/sdk/abi.h", "host/sdk/plugin.h"});
  EXPECT_GE(headers.size(), 6u);
  const std::set<std::string> known(headers.begin(), headers.end());
  for (const std::string& path : headers) {
    const std::string text = text_of(root / path);
    for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match)
      EXPECT_TRUE(known.contains((*match)[1])) << path << " includes " << (*match)[1];
  }
}

// What handles compute is tried without a window: only what paints them and what hears the mouse knows one.
TEST(Structure, HandlesAreComputedWithoutTheInterface) {
  const std::set<std::string> of_the_window = {"handle_painter.cpp", "plugin_handles.cpp",
                                               "viewport_handles.cpp"};
  const std::regex interface(R"re(#\s*include\s*(<imgui|"host/window/(panels|platform)/))re");
  std::size_t files = 0;
  for (const std::string& path : files_under("host/window/handles", {".h", ".cpp"})) {
    if (of_the_window.contains(fs::path(path).filename().string())) continue;
    ++files;
    EXPECT_FALSE(std::regex_search(text_of(root / path), interface)) << path;
  }
  EXPECT_GT(files, 8u);
}

// So is the node editor: only its panel and its painter know one.
TEST(Structure, DiagramsAreLaidOutAndHitWithoutTheInterface) {
  const std::set<std::string> of_the_window = {"diagram_painter.cpp", "node_panel.cpp", "node_panel.h"};
  const std::regex interface(R"re(#\s*include\s*(<imgui|"host/window/(panels|platform)/))re");
  std::size_t files = 0;
  for (const std::string& path : files_under("host/window/nodes", {".h", ".cpp"})) {
    if (of_the_window.contains(fs::path(path).filename().string())) continue;
    ++files;
    EXPECT_FALSE(std::regex_search(text_of(root / path), interface)) << path;
  }
  EXPECT_GT(files, 12u);
}

// Headers that take seconds to compile may be seen by sources, and by headers that their own folder keeps to
// itself.
TEST(Structure, HeavyHeadersDoNotLeaveTheFolderThatNeedsThem) {
  const std::regex heavy(
      R"re(#\s*include\s*<(openvdb|OpenImageIO|OpenColorIO|CLI|spdlog|nlohmann)/(?!json_fwd))re");
  const std::regex include(R"re(#\s*include\s*"([^"]+)")re");
  std::map<std::string, std::string> texts;
  for (const char* folder : {"core", "viewport", "host"})
    for (const std::string& path : files_under(folder, {".h", ".cpp"})) texts[path] = text_of(root / path);

  std::set<std::string> heavy_headers;
  for (const auto& [path, text] : texts)
    if (path.ends_with(".h") && std::regex_search(text, heavy)) heavy_headers.insert(path);
  for (std::size_t before = std::size_t(-1);
       before != heavy_headers.size();) {  // and those that include them
    before = heavy_headers.size();
    for (const auto& [path, text] : texts)
      for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match) {
        if (!heavy_headers.contains((*match)[1])) continue;
        EXPECT_EQ(fs::path(path).parent_path(), fs::path((*match)[1].str()).parent_path())
            << path << " includes " << (*match)[1] << ", which is slow to compile";
        if (path.ends_with(".h")) heavy_headers.insert(path);
      }
  }
}

// It brings some 250 libraries, so it is a module's alone, which is loaded when it is needed.
TEST(Structure, OpenImageIOIsSeenByItsModuleAlone) {
  const std::regex include(R"re(#\s*include\s*<OpenImageIO/)re");
  std::vector<std::string> found;
  for (const char* folder : {"core", "viewport", "host"})
    for (const std::string& path : files_under(folder, {".h", ".cpp"}))
      if (std::regex_search(text_of(root / path), include)) found.push_back(path);
  EXPECT_EQ(found, std::vector<std::string>{"core/image/image_files_module.cpp"});
}

TEST(Structure, EverySourceIsListedInTheCMakeListsOfItsFolder) {
  for (const char* folder : {"core", "viewport", "host", "tests"})
    for (const std::string& path : files_under(folder, {".cpp"})) {
      // A folder without a list of its own belongs to the one above.
      fs::path list = root / fs::path(path).parent_path();
      std::string name = fs::path(path).filename().string();
      while (!fs::exists(list / "CMakeLists.txt") && list != root) {
        name = list.filename().string() + "/" + name;
        list = list.parent_path();
      }
      const std::string text = text_of(list / "CMakeLists.txt");
      const std::regex listed("(^|[\\s(/])" + std::regex_replace(name, std::regex(R"([.+])"), "\\$&") +
                              "([\\s)]|$)");
      EXPECT_TRUE(std::regex_search(text, listed)) << path << " is not in " << (list / "CMakeLists.txt");
    }
}

// An example that the README shows is the one that is installed, and whole: block after block is the file.
TEST(Structure, TheReadmeShowsTheExamplesWholeAndAsTheyAre) {
  const std::string readme = text_of(root / "README.md");
  const std::size_t begin = readme.find("\n## Plug-ins\n"), end = readme.find("\n## ", begin + 1);
  ASSERT_NE(begin, std::string::npos);
  const std::string chapter = readme.substr(begin, end - begin);
  const std::regex block("```(cmake|cpp)\n([^`]*)```");
  std::map<std::string, std::string> shown;  // by language
  for (std::sregex_iterator match(chapter.begin(), chapter.end(), block), none; match != none; ++match)
    shown[(*match)[1]] += (*match)[2];
  const auto without_empty_lines = [](const std::string& text) {
    return std::regex_replace(text, std::regex("\n\n+"), "\n");
  };
  const fs::path examples = root / "host/sdk/examples";
  std::string sources;
  for (const char* source : {"marker/marker.cpp", "puff/puff.cpp", "places/places.cpp"})
    sources += text_of(examples / source);
  EXPECT_EQ(without_empty_lines(shown["cpp"]), without_empty_lines(sources));
  EXPECT_EQ(shown["cmake"], text_of(examples / "marker/CMakeLists.txt"));
}

TEST(Structure, NothingStandsAtTheTopThatDoesNotBelongThere) {
  const std::set<std::string> known = {"core",
                                       "viewport",
                                       "host",
                                       "presets",
                                       "tests",
                                       "tools",
                                       "CMakeLists.txt",
                                       "README.md",
                                       "LICENSE",
                                       "CMakePresets.json",
                                       ".gitignore",
                                       ".clang-format",
                                       ".ci",
                                       ".git",
                                       "build",
                                       "out",
                                       "docs"};
  for (const auto& entry : fs::directory_iterator(root))
    EXPECT_TRUE(known.contains(entry.path().filename().string())) << entry.path();
}

}  // namespace
}  // namespace plinian
