// Widgets that several panels share.
#pragma once

#include <optional>
#include <string>

#include "core/shared/glue.h"
#include "host/window/drawing/pane_rect.h"
#include "host/window/fields/number_drag.h"

namespace plinian::window {

class Trace;

/// Opens a pane as a window of Dear ImGui that neither moves nor closes. To be followed by end_pane.
void begin_pane(const char* id, const PaneRect& pane, bool scrolls = true);
void end_pane();

/// A heading over a pane or a group of widgets.
void heading(const std::string& text);

/// What was done to a number field in this turn.
struct FieldEdit {
  std::optional<double> dragged;      // to this value; the drag goes on
  std::optional<std::string> typed;   // and confirmed
  bool begun = false, ended = false;  // a drag
};

struct FieldLook {
  float width = 80.0f;   // [pixels of points]
  std::string prefix;    // "x": drawn faintly before the number
  std::string unit;      // drawn faintly behind it
  bool changed = false;  // is not the default
  bool enabled = true;   // can be edited
  bool driven = false;   // by a connection
};

/// A number that is dragged (Ctrl fine, Shift coarse) or, after a click, typed.
FieldEdit number_field(const char* id, double value, const NumberRange& range, const FieldLook& look);

/// A text that is edited in place and confirmed by Enter or by leaving it. hint: stands faintly where there
/// is none.
std::optional<std::string> text_field(const char* id, const std::string& text, float width,
                                      bool enabled = true, const char* hint = "");

/// The next field of a number or a text that is shown takes the keys; none where `wanted` is false.
void want_typing(bool wanted);

/// A button that is on or off. width: [points]; 0: the label's.
bool toggle(const char* label, bool on, const char* help, float width = 0.0f);
/// The width that a button with that label has. [points]
float button_width(const char* label);

/// A row of a list, as wide as there is room, that stays marked under the pointer; what stands in it is the
/// caller's to draw. Whether it was clicked, also for the second time.
bool list_row(const char* id, bool chosen, float height);

/// Tells the trace where the last widget is.
void note_item(Trace& trace, const std::string& name);

/// Help on what is under the pointer, after a moment.
void help(const std::string& text);

/// The amber dot of what is not at its default, at the cursor and a row high; whether it is clicked, which is
/// to put that back. width: [points]
bool show_changed_dot(float width, const std::string& what);

/// The colour of a display for a linear one, brought into range.
vec3 display_colour(const vec3& linear);

}  // namespace plinian::window
