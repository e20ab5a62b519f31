// The node type "volumeRead": a .vdb file, or a sequence of them.
//
// attribute            unit
// file                 a file, or a sequence: smoke.####.vdb, smoke.%04d.vdb, smoke.$F4.vdb
// grid, ...            which grids are read, and how (core/scene/scene_parameters.h)
// up_axis, file_unit   the file's space; `auto` and 0: guessed from the file
// time                 frames; the scene's time drives it
// start, end           frames of the sequence that are shown; automatic_range: those on the disk
// offset, speed, ...   how time maps to them (core/media/frame_sequence.h)
// use_source_frame     source_frame says the frame, keyed or driven, in place of time
// before, after        what is shown beyond the range
// missing              what is shown for a frame that is not there or cannot be read
// reload               goes up where the file is to be read again
// volume               what was read
// space                object_from_file: connect it where the volume goes
// facts                what the file says of itself
// frame                of the sequence, that is shown
// badge                why something else is shown than what was asked for; empty: nothing to say
// frame_missing        the file of the frame is not there or cannot be read, or lies beyond an
// automatic_range
//
// Over 400 lines: half of them declare attributes, each once.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/media/frame_sequence.h"
#include "core/scene/scene_parameters.h"
#include "host/nodes/core_attributes.h"
#include "host/nodes/matrices.h"
#include "host/nodes/node_types.h"
#include "host/nodes/read_facts.h"
#include "host/nodes/volume_store.h"
#include "host/sdk/volume_table.h"

namespace plinian::nodes {

namespace {

using sdk::Attribute;

enum class Missing { blank, hold, error };

struct Attributes {
  Attribute file, grid, temperature_grid, level_set, frustum, up_axis, file_unit, time_limit, memory_limit,
      time, automatic_range, start, end, offset, speed, frames_per_second, scene_rate, use_source_frame,
      source_frame, before, after, missing, reload, volume, space, facts, frame, badge, frame_missing;
};

const char* const beyond_words = "hold,loop,ping_pong,blank";

// What the outputs are told.
struct Shown {
  std::shared_ptr<const BrickVolume> volume;
  std::shared_ptr<const VdbVolume> file;  // null where nothing is shown
  dmat4 space{1.0};                       // object_from_file
  std::string badge;
  std::uint64_t content = 0;
  int frame = 0;
  bool frame_missing = false;
};

class Reader {
 public:
  Reader(const Attributes& attributes, VolumeStore& store, sdk::Context& context)
      : a_(attributes), store_(store), context_(context), path_(context.text(attributes.file)) {}

  Shown read() {
    if (path_.empty()) throw sdk::Error("no file is set");
    const auto pattern = FramePattern::parse(path_);
    // A file may be called like a pattern.
    if (!pattern || stamp_of(path_) != FileStamp()) return read_file(path_, 0);
    return read_sequence(*pattern);
  }

 private:
  Shown read_sequence(const FramePattern& pattern) {
    const std::vector<int> frames = pattern.frames_on_disk();
    if (frames.empty()) throw sdk::Error(pattern.text() + ": no file of that sequence is there");
    FrameTiming timing;
    const bool automatic = context_.number(a_.automatic_range) != 0.0;
    timing.start = automatic ? frames.front() : context_.number(a_.start);
    timing.end = automatic ? frames.back() : context_.number(a_.end);
    if (timing.end < timing.start) throw sdk::Error("the sequence's end is before its start");
    timing.offset = context_.number(a_.offset);
    timing.speed = context_.number(a_.speed);
    timing.frames_per_second = context_.number(a_.frames_per_second);
    timing.scene_rate = context_.number(a_.scene_rate);
    timing.before = Beyond(int(context_.number(a_.before)));
    timing.after = Beyond(int(context_.number(a_.after)));
    const double source = context_.number(a_.use_source_frame) != 0.0
                              ? context_.number(a_.source_frame)
                              : source_frame(timing, context_.number(a_.time));
    const std::optional<int> frame = frame_in_range(timing, source);
    const int asked = int(std::clamp(std::floor(source), -1e9, 1e9));
    if (!frame) return blank("", asked);
    const std::string beyond = held(timing, source);
    // Where the range is that of the files, whatever lies beyond it may only be late.
    const bool is_late = automatic && !beyond.empty();
    if (is_late && Missing(int(context_.number(a_.missing))) == Missing::error)
      throw sdk::Error(pattern.path(asked) + ": no such file");
    Shown shown = read_frame(pattern, frames, *frame);
    shown.frame_missing = is_late || !shown.badge.empty();
    if (shown.badge.empty()) shown.badge = beyond;
    return shown;
  }

  // Nobody should have to wonder why nothing moves.
  static std::string held(const FrameTiming& timing, double source) {
    const auto text = [](const char* side, double frame) {
      return fmt::format("{} frame of the sequence, {:.0f}, which is held (before, after)", side, frame);
    };
    if (source < timing.start && timing.before == Beyond::hold) return text("before the first", timing.start);
    if (std::floor(source) > timing.end && timing.after == Beyond::hold)
      return text("behind the last", timing.end);
    return "";
  }

  Shown read_frame(const FramePattern& pattern, const std::vector<int>& frames, int frame) {
    const auto policy = Missing(int(context_.number(a_.missing)));
    std::string badge;
    for (int at = frame;;) {
      if (std::binary_search(frames.begin(), frames.end(), at)) {
        try {
          Shown shown = read_file(pattern.path(at), frame);
          shown.badge = badge;
          return shown;
        } catch (const VdbError& error) {
          if (policy == Missing::error) throw;
          if (badge.empty()) badge = "frame " + std::to_string(at) + " cannot be read: " + error.what();
        }
      } else if (badge.empty()) {
        badge = "frame " + std::to_string(at) + " is missing";
        if (policy == Missing::error) throw sdk::Error(pattern.path(at) + ": no such file");
      }
      // The one before it, or, at the beginning, the one behind it.
      const auto above = std::lower_bound(frames.begin(), frames.end(), at);
      if (policy == Missing::blank || (at > frame && above == frames.end())) return blank(badge, frame);
      if (at <= frame && above != frames.begin()) {
        at = *std::prev(above);
      } else {
        const auto next = std::upper_bound(frames.begin(), frames.end(), std::max(at, frame));
        if (next == frames.end()) return blank(badge, frame);
        at = *next;
      }
    }
  }

  Shown blank(const std::string& badge, int frame) {
    Shown shown;
    shown.volume = std::make_shared<const BrickVolume>();
    shown.badge = badge;
    shown.frame = frame;
    shown.content = 1;
    return shown;
  }

  Shown read_file(const std::string& path, int frame) {
    VdbOptions options;
    options.grid = context_.text(a_.grid);
    options.temperature_grid = context_.text(a_.temperature_grid);
    options.level_set = LevelSetMode(int(context_.number(a_.level_set)));
    options.frustum = FrustumMode(int(context_.number(a_.frustum)));
    options.time_limit_s = context_.number(a_.time_limit);
    options.memory_limit_bytes = std::uint64_t(context_.number(a_.memory_limit));
    options.progress = [&](double share) {
      context_.progress(share, "reading");
      return !context_.cancelled();
    };
    const std::string key = options.grid + '\n' + options.temperature_grid + '\n' +
                            std::to_string(int(options.level_set)) + std::to_string(int(options.frustum));
    const VolumeStore::Read read = [&] {
      try {
        return store_.read(path, options, key);
      } catch (const VdbError& error) {
        throw VdbError(advice_for_node(error.what()));
      }
    }();
    Shown shown;
    // Whoever holds the voxels holds the file's entry in the store with them.
    shown.volume = {read.file, read.file->volume.get()};
    shown.file = read.file;
    shown.space = orientation(read.file->facts.orientation).world_from_medium();
    shown.content = read.content;
    shown.frame = frame;
    return shown;
  }

  VdbOrientation orientation(VdbOrientation guess) {
    const int axis = int(context_.number(a_.up_axis));
    if (axis > 0) guess.up_axis = axis == 1 ? 'y' : 'z';
    if (const double unit = context_.number(a_.file_unit); unit > 0.0) guess.file_unit = unit;
    return guess;
  }

  const Attributes& a_;
  VolumeStore& store_;
  sdk::Context& context_;
  std::string path_;
};

Attributes declare(sdk::NodeType& type) {
  const std::string all = "volume space facts frame badge frame_missing";
  const auto& parameters = medium_parameters();
  Attributes a;
  a.file =
      type.add({.name = "file",
                .type = "path",
                .help = "A .vdb file, or a sequence of them: smoke.####.vdb, smoke.%04d.vdb, smoke.$F4.vdb.",
                .affects = all,
                .widget = "file .vdb"});
  a.grid =
      type.add(attribute_of(parameters, "grid",
                            {.help = "Density grid: NAME, NAME[INDEX] or NAME[*] (their sum); empty: chosen.",
                             .group = "Grids",
                             .affects = all,
                             .widget = "grid of file"}));
  a.temperature_grid = type.add(attribute_of(parameters, "temperature_grid",
                                             {.help = "Grid of temperatures, or none; empty: found by name.",
                                              .group = "Grids",
                                              .affects = all,
                                              .widget = "grid of file or none"}));
  a.level_set = type.add(attribute_of(parameters, "level_set", {.group = "Grids", .affects = all}));
  a.frustum = type.add(attribute_of(parameters, "frustum", {.group = "Grids", .affects = all}));
  a.up_axis = type.add({.name = "up_axis",
                        .type = "enum",
                        .help = "Which way is up in the file; auto: guessed from what it says of itself.",
                        .group = "Space",
                        .choices = "auto,y,z",
                        .affects = all});
  a.file_unit = type.add({.name = "file_unit",
                          .type = "double",
                          .help = "Length of one unit of the file; 0: guessed from what it says of itself.",
                          .unit = "m",
                          .group = "Space",
                          .affects = all,
                          .minimum = 0});
  a.time = type.add({.name = "time",
                     .type = "time",
                     .default_value = "1",
                     .help = "The moment that is shown; connect the scene's time.",
                     .unit = "frames",
                     .group = "Sequence",
                     .affects = all});
  a.automatic_range = type.add({.name = "automatic_range",
                                .type = "bool",
                                .default_value = "true",
                                .help = "The sequence begins and ends with the files that are there.",
                                .group = "Sequence",
                                .affects = all});
  for (const auto& [attribute, name, help] : {std::tuple(&a.start, "start", "First frame of the sequence."),
                                              std::tuple(&a.end, "end", "Last frame of the sequence.")})
    *attribute = type.add({.name = name,
                           .type = "int",
                           .default_value = "1",
                           .help = help,
                           .unit = "frames",
                           .group = "Sequence",
                           .affects = all,
                           .children = {},
                           .widget = "",
                           .shown_when = "automatic_range=false"});
  a.offset = type.add({.name = "offset",
                       .type = "time",
                       .help = "The sequence begins so much later.",
                       .unit = "frames",
                       .group = "Sequence",
                       .affects = all});
  a.speed = type.add({.name = "speed",
                      .type = "double",
                      .default_value = "1",
                      .help = "0.5: half as fast; negative: backwards, from the last frame on.",
                      .group = "Sequence",
                      .affects = all,
                      .soft_minimum = -2,
                      .soft_maximum = 2});
  a.frames_per_second = type.add({.name = "frames_per_second",
                                  .type = "double",
                                  .help = "Of the sequence; 0: as the scene.",
                                  .unit = "frames/s",
                                  .group = "Sequence",
                                  .affects = all,
                                  .minimum = 0});
  a.scene_rate =
      type.add({.name = "scene_rate",
                .type = "double",
                .default_value = "24",
                .help = "Of the scene, where frames_per_second is set; connect the time node's rate.",
                .unit = "frames/s",
                .group = "Sequence",
                .affects = all,
                .minimum = 0.001});
  a.use_source_frame = type.add({.name = "use_source_frame",
                                 .type = "bool",
                                 .help = "source_frame says which frame is shown, in place of time.",
                                 .group = "Sequence",
                                 .affects = all});
  a.source_frame = type.add({.name = "source_frame",
                             .type = "double",
                             .default_value = "1",
                             .help = "The frame of the sequence that is shown; may be keyed.",
                             .unit = "frames",
                             .group = "Sequence",
                             .affects = all,
                             .children = {},
                             .widget = "",
                             .shown_when = "use_source_frame=true"});
  a.before = type.add({.name = "before",
                       .type = "enum",
                       .help = "What is shown before the first frame.",
                       .group = "Sequence",
                       .choices = beyond_words,
                       .affects = all});
  a.after = type.add({.name = "after",
                      .type = "enum",
                      .help = "What is shown behind the last frame.",
                      .group = "Sequence",
                      .choices = beyond_words,
                      .affects = all});
  a.missing =
      type.add({.name = "missing",
                .type = "enum",
                .help = "For a frame that is not there, or is still being written: nothing, the nearest "
                        "one before it, or an error. Beyond an automatic range before and after say what is "
                        "shown, but for the error.",
                .group = "Sequence",
                .choices = "blank,hold,error",
                .affects = all});
  a.time_limit = type.add({.name = "time_limit",
                           .type = "double",
                           .help = "For reading a file; 0: grows with the file.",
                           .unit = "s",
                           .group = "Limits",
                           .affects = all,
                           .minimum = 0,
                           .keyable = false});
  a.memory_limit = type.add({.name = "memory_limit",
                             .type = "double",
                             .help = "For reading a file; 0: grows with the file.",
                             .unit = "bytes",
                             .group = "Limits",
                             .affects = all,
                             .minimum = 0,
                             .keyable = false});
  a.reload = type.add({.name = "reload",
                       .type = "int",
                       .help = "Another number: the file is read again, as it may have changed.",
                       .affects = all,
                       .keyable = false,
                       .storable = false});
  a.volume = type.add({.name = "volume",
                       .type = "data",
                       .help = "The density that was read, and its temperature where there is one.",
                       .data_type = PLINIAN_VOLUME_TYPE,
                       .output = true});
  a.space = type.add({.name = "space",
                      .type = "matrix",
                      .help = "From the file's space to metres, y up: what the shape that draws it takes.",
                      .output = true});
  a.facts = type.add({.name = "facts",
                      .type = "data",
                      .help = "What the file says of itself.",
                      .data_type = facts_type,
                      .output = true,
                      .hidden = true});
  a.frame = type.add({.name = "frame",
                      .type = "int",
                      .help = "The frame of the sequence that is shown.",
                      .unit = "frames",
                      .output = true});
  a.badge = type.add({.name = "badge",
                      .type = "string",
                      .help = "Why something else is shown than what was asked for.",
                      .output = true});
  a.frame_missing =
      type.add({.name = "frame_missing",
                .type = "bool",
                .help = "The file of the frame is not there or cannot be read; missing says what is shown.",
                .output = true});
  return a;
}

}  // namespace

void add_volume_read(sdk::Plugin& plugin, std::shared_ptr<VolumeStore> store) {
  sdk::NodeType type("volumeRead");
  type.help = "A .vdb file, or a sequence of them.";
  const Attributes a = declare(type);
  type.compute = [a, store](sdk::Context& context, Attribute) {
    Shown shown;
    try {
      shown = Reader(a, *store, context).read();
    } catch (const VdbCancelled&) {
      return;
    }
    context.set(a.frame, double(shown.frame));
    context.set(a.badge, shown.badge);
    context.set(a.frame_missing, shown.frame_missing ? 1.0 : 0.0);
    context.set(a.space, columns(shown.space));
    if (shown.file)
      context.set_data(a.facts, facts_type, std::make_unique<const VdbFacts>(shown.file->facts), 1024);
    else
      context.set_data(a.facts, facts_type, std::make_unique<const VdbFacts>(), 1024);
    sdk::write_volume(context.plain(), a.volume.index, std::move(shown.volume), shown.content);
  };
  plugin.add(type);
}

}  // namespace plinian::nodes
