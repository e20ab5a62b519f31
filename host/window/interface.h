// The interface: its panels, and one turn of its loop.
#pragma once

#include <chrono>
#include <optional>

#include "host/window/drawing/drawings.h"
#include "host/window/nodes/node_panel.h"
#include "host/window/palette/palette.h"
#include "host/window/panels/attribute_panel.h"
#include "host/window/panels/console_panel.h"
#include "host/window/panels/file_dialog.h"
#include "host/window/panels/layout.h"
#include "host/window/panels/light_panel.h"
#include "host/window/panels/outliner_panel.h"
#include "host/window/panels/playblast_dialog.h"
#include "host/window/panels/timeline_panel.h"
#include "host/window/panels/viewport_panel.h"
#include "host/window/platform/main_window.h"
#include "host/window/studio.h"

namespace plinian::window {

class Interface {
 public:
  Interface(MainWindow& window, Studio& studio);
  ~Interface();

  /// Takes input, draws, and does what was asked for. Waits until there is something to do, a second at most.
  void turn();

 private:
  void draw();
  void draw_meanwhile();
  void tell_input();
  void take_input();
  void show_panels();
  void show_splitters(const Panes& panes);
  void show_dialogs();
  std::optional<Action> action_of(const Chord& chord) const;
  bool is_meant(const Chord& chord) const;
  void act(Action action);
  void settle_title();
  void note_work(bool waited);
  void note_phase(const char* name);
  void note_mouse();
  void note_keys();
  double patience() const;
  double earliness() const;

  MainWindow& window_;
  Studio& studio_;
  PaneSizes sizes_;
  PaneRect picture_;  // where it was shown last
  Drawings drawings_;
  ViewportPanel viewport_;
  OutlinerPanel outliner_;
  LightPanel lights_;
  AttributePanel attributes_;
  TimelinePanel timeline_;
  ConsolePanel console_;
  NodePanel nodes_;
  Palette palette_;
  FileDialog file_dialog_;
  PlayblastDialog playblast_dialog_;
  double draw_ms_ = 0.0;  // of the last drawing
  std::chrono::steady_clock::time_point drawn_{};
  int redraws_ = 3;
  std::string title_, mouse_;
  std::chrono::steady_clock::time_point work_began_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point phase_began_{};
  std::string phases_;   // of the work since then, for the trace: "draw 31 run 12" [ms]
  bool still_ = false;   // nothing is left to be drawn
  bool typing_ = false;  // keys are a field's
};

}  // namespace plinian::window
