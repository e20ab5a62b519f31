// plinian render --vary: one picture for each value, on a sheet that says which is which.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "core/image/contact_sheet.h"
#include "core/scene/nearest_word.h"
#include "core/scene/scene_loader.h"
#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/picture.h"
#include "host/graph/graph_error.h"

namespace plinian::cli {

namespace {

struct Variation {
  std::string key;
  std::vector<std::string> values;
};

// "medium.albedo=0.3,0.6" ; the numbers of a vector stand between spaces: "key.colour=1 0 0,0 1 0".
Variation parse_variation(const std::string& text) {
  const auto equals = text.find('=');
  Variation variation;
  if (equals != text.npos) variation.key = text.substr(0, equals);
  for (std::size_t begin = equals == text.npos ? text.size() : equals + 1; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (end == begin && !(variation.values.empty() && end == text.size()))
      throw std::runtime_error(fmt::format("--vary {}: there is no value {} a comma", text,
                                           end == text.size() ? "behind" : "before"));
    variation.values.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  if (variation.values == std::vector<std::string>{""}) variation.values.clear();
  if (variation.key.empty() || variation.values.empty())
    throw std::runtime_error(
        fmt::format("--vary {}: expected KEY=VALUE,VALUE, such as medium.albedo=0.3,0.6,0.9", text));
  return variation;
}

// A sheet has little room: the attribute says enough, "albedo" of "medium.albedo", where it is no mere "y"
// and no other variation's is called so too.
std::string short_name(const Variation& variation, const std::vector<Variation>& all) {
  const std::string& key = variation.key;
  std::size_t dot = key.rfind('.');
  while (dot != key.npos) {
    const std::string_view end = std::string_view(key).substr(dot);
    const auto has_it = [&](const Variation& other) { return ("." + other.key).ends_with(end); };
    if (end.size() > 2 && std::ranges::count_if(all, has_it) == 1) return key.substr(dot + 1);
    dot = dot == 0 ? key.npos : key.rfind('.', dot - 1);
  }
  return key;
}

// Refuses a value before pictures are made that a later one would throw away.
void check_values(PreparedScene& scene, const std::vector<Variation>& variations) {
  graph::Session& session = scene.workspace->session();
  const auto on_warning = std::exchange(session.on_warning, nullptr);  // they come with the pictures
  graph::History::Scope check(session.history(), "check");
  for (const Variation& variation : variations)
    for (const std::string& value : variation.values)
      apply_edit(*scene.workspace, {variation.key, value, "--vary " + variation.key});
  check.roll_back();
  session.on_warning = on_warning;
}

// A value as the attribute has it now: a limit may have changed it, and the picture is of what came out.
std::string settled_text(graph::Session& session, const std::string& key, const std::string& asked) {
  const auto number = [](const std::string& text) -> std::optional<double> {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
  };
  const auto wanted = number(asked);
  if (!wanted) return asked;
  try {
    const std::string text = session.execute("getAttr " + key).front();
    const auto is = number(text);
    if (is && std::abs(*is - *wanted) > 1e-5 * std::max(1.0, std::abs(*wanted)))
      return fmt::format("{:.4g} (asked: {})", *is, asked);
  } catch (const graph::GraphError&) {
    // A key of the quality, or one that places a camera, is no attribute, and is refused beyond its limits.
  }
  return asked;
}

// What stands in the place of a picture that could not be made.
SheetPicture empty_cell(const std::vector<SheetPicture>& pictures, const std::string& label) {
  SheetPicture cell{64, 64, {}, label + ": failed"};
  for (const SheetPicture& picture : pictures)
    if (!picture.rgb.empty()) std::tie(cell.width, cell.height) = std::pair(picture.width, picture.height);
  cell.rgb.assign(std::size_t(cell.width) * std::size_t(cell.height) * 3, 0);
  return cell;
}

}  // namespace

int run_variants(const RenderArguments& arguments) {
  std::vector<Variation> variations;
  std::size_t count = 1;
  for (const std::string& text : arguments.vary) {
    variations.push_back(parse_variation(text));
    const std::string& key = variations.back().key;
    if (std::ranges::count(variations, key, &Variation::key) > 1)
      throw std::runtime_error(fmt::format("--vary {}: is varied twice; give all its values at once", key));
    count *= variations.back().values.size();
  }
  if (count > 1024)
    throw std::runtime_error(fmt::format("--vary: {} pictures are more than a sheet holds", count));
  if (!arguments.sheet.ends_with(".png"))
    throw std::runtime_error(arguments.sheet + ": the name of a sheet ends in .png");
  const WriteOptions writing = write_options(arguments);
  check_output(arguments.sheet, writing);

  PreparedScene scene = prepare_scene(arguments.scene);
  tell_shown_frames(scene);
  check_values(scene, variations);
  NamedRenderer chosen = choose_renderer(arguments.renderer, {.reference_tolerance = arguments.tolerance});
  const ViewTransform view(writing.view);
  std::vector<SheetPicture> pictures;
  std::vector<std::size_t> failed;  // of the pictures
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < count; ++i) {
    // The last variation changes fastest.
    std::vector<SceneEdit> edits(variations.size());
    for (std::size_t v = variations.size(), rest = i; v-- > 0;) {
      const std::vector<std::string>& values = variations[v].values;
      edits[v] = {variations[v].key, values[rest % values.size()], "--vary " + variations[v].key};
      rest /= values.size();
    }
    // A line for each picture, of what is said of each edit.
    const auto line_of = [&](const auto& said) {
      std::vector<std::string> parts;
      for (std::size_t v = 0; v < edits.size(); ++v) parts.push_back(said(variations[v], edits[v]));
      return join(parts);
    };
    std::string label = line_of([&](const Variation& variation, const SceneEdit& edit) {
      return short_name(variation, variations) + " " + edit.value;
    });
    nlohmann::ordered_json values;
    for (const SceneEdit& edit : edits) values[edit.key] = edit.value;
    nlohmann::ordered_json one = {{"values", values}};
    try {
      for (const SceneEdit& edit : edits) apply_edit(*scene.workspace, edit);
      label = line_of([&](const Variation& variation, const SceneEdit& edit) {
        return short_name(variation, variations) + " " +
               settled_text(scene.workspace->session(), edit.key, edit.value);
      });
      const SceneSnapshot snapshot = take_snapshot(scene);
      const Picture picture =
          make_picture(chosen, snapshot, arguments, "", fmt::format("variant {} of {}", i + 1, count));
      if (picture.cut_short) throw RenderCancelled();
      pictures.push_back(sheet_picture(picture.image, view, label));
      tell_picture(label, picture);
      one.update(picture_report(picture, {}));
    } catch (const RenderCancelled&) {
      throw;
    } catch (const SceneLoadCancelled&) {
      throw;
    } catch (const std::exception& reason) {
      // The others are worth having all the same.
      const std::string name =
          line_of([](const Variation&, const SceneEdit& edit) { return edit.key + "=" + edit.value; });
      error(fmt::format("--vary {}: {}", name, reason.what()));
      failed.push_back(pictures.size());
      pictures.push_back({0, 0, {}, label});
      one["error"] = reason.what();
    }
    report.push_back(std::move(one));
  }
  for (const std::size_t i : failed) pictures[i] = empty_cell(pictures, pictures[i].label);
  if (failed.size() == count) throw std::runtime_error(arguments.sheet + ": no variant could be drawn");
  const int columns =
      variations.size() > 1 ? int(variations.back().values.size()) : int(std::min<std::size_t>(count, 6));
  const SheetPicture sheet = contact_sheet(pictures, columns);
  write_file(arguments.sheet, encode_png(sheet.rgb, sheet.width, sheet.height));
  const std::size_t drawn = count - failed.size();
  note(fmt::format("{}: {} {}, {}x{}", arguments.sheet, drawn, drawn == 1 ? "picture" : "pictures",
                   sheet.width, sheet.height));
  if (arguments.json)
    print(nlohmann::ordered_json{
              {"input", arguments.scene.input}, {"sheet", arguments.sheet}, {"variants", report}}
              .dump(2) +
          "\n");
  return failed.empty() ? exit_success : exit_failure;
}

}  // namespace plinian::cli
