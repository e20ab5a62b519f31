// How the interface looks: a dark, calm theme, so that the picture is the brightest thing in the room.
#pragma once

struct ImFont;

namespace plinian::window {

/// Colours that the panels use beyond the widgets' own. [sRGB 0xAABBGGRR, as Dear ImGui packs them]
namespace colour {
inline constexpr unsigned text = 0xffd6d2d0;
inline constexpr unsigned faint_text = 0xff8f8986;
inline constexpr unsigned accent = 0xffe0a05a;   // what is active
inline constexpr unsigned played = 0xff8fae6a;   // green: frames that play in real time
inline constexpr unsigned changed = 0xff5ab0e8;  // amber: a value that is not its default
inline constexpr unsigned warning = 0xff4fb4f0;
inline constexpr unsigned error = 0xff6a6af0;
inline constexpr unsigned good = 0xff8ac28a;
inline constexpr unsigned gap = 0xff171717;  // between panes
/// What panes lie on [sRGB 0 to 1]: everything is cleared to it. Where the processor draws the interface,
/// a layer of its own for each pane took a third of the time.
inline constexpr float pane = 0.145f;
}  // namespace colour

struct Fonts {
  ImFont* text = nullptr;   // of labels and values
  ImFont* bold = nullptr;   // of headings
  ImFont* fixed = nullptr;  // of the console and of figures that stand in columns
};
/// Those of set_theme.
const Fonts& fonts();

/// Sets colours, distances and fonts of the current context. scale: of everything [-].
void set_theme(double scale);

/// A distance at the interface's scale. [pixels of points]
float scaled(float points);

}  // namespace plinian::window
