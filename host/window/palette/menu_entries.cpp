// A table.
#include "host/window/palette/menu_entries.h"

#include "host/window/studio.h"

namespace plinian::window {

std::vector<PaletteEntry> menu_entries() {
  std::vector<PaletteEntry> entries;
  const auto add = [&](const char* title, const char* help, std::function<void(Studio&)> act) {
    entries.push_back({.title = title,
                       .kind = "menu",
                       .detail = help,
                       .keys = "",
                       .action = {},
                       .line = "",
                       .is_open = false,
                       .act = std::move(act)});
  };
  for (const char* kind : {"ash", "cloud", "sandstorm", "explosion"})
    add((std::string("begin with ") + kind).c_str(), "a procedural medium in place of the scene",
        [kind](Studio& s) { s.files.begin_anew(kind); });
  add("import a volume", "beside those of the scene", [](Studio& s) { s.ask_import = true; });
  add("look gallery", "the scene in every look beside the picture", [](Studio& s) { s.show_looks ^= true; });
  add("snapshots", "the strip of snapshots", [](Studio& s) { s.show_snapshots ^= true; });
  add("load a plate", "a picture behind what has an alpha", [](Studio& s) { s.ask_plate = true; });
  add("set the gate", "to the size of the reference", [](Studio& s) {
    if (const auto size = s.comparison.wanted_size()) s.set_gate(*size);
  });
  add("match exposure", "of a reference from a file, before it is measured",
      [](Studio& s) { s.development.matching.exposure ^= s.development.against_file != nullptr; });
  add("match background", "put this one behind a reference from a file that has an alpha",
      [](Studio& s) { s.development.matching.background ^= s.development.against_file != nullptr; });
  add("compare with the reference", "the picture from a file that the scene has",
      [](Studio& s) { s.comparison.want_file(); });
  add("compare with nothing", "let go of the other picture",
      [](Studio& s) { s.comparison.keep(nullptr, "", OtherKind::none); });
  add("stop the reference", "what is rendered of it is lost",
      [](Studio& s) { s.comparison.stop_reference(); });
  add("stop the playblast", "frames that are done stay", [](Studio& s) { s.playblast.cancel(); });
  add("quit", "asks about unsaved changes", [](Studio& s) { s.wants_quit = true; });
  return entries;
}

}  // namespace plinian::window
