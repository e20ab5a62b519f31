// Corners of the picture, and the figures.
#include "host/window/panels/viewport_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/image/heat_map.h"
#include "host/window/panels/overlay_text.h"
#include "host/window/panels/snapshot_strip.h"
#include "host/window/panels/zoom_hand.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

// What there is to say about the picture, in its corners.
void show_notes(Studio& studio, const PicturePlaces& places, const PaneRect& pane,
                const DevelopedPtr& shown) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float line = ImGui::GetTextLineHeight() + scaled(3);
  vec2 at = pane.begin + vec2(scaled(10) + zoom_badge_width(places), scaled(8));
  const std::vector<std::string>& problems = studio.feed.problems();
  const std::string render_error = studio.renderer.status().error;
  for (const std::string& problem : problems) {
    draw_text(at, colour::error, problem);
    at.y += line;
  }
  if (!render_error.empty()) {
    draw_text(at, colour::error, render_error);
    at.y += line;
  }
  const bool stale = studio.feed.is_stale() && studio.feed.snapshot();
  if (stale) draw_text(at, colour::warning, problems.empty() ? "updating" : "the last good picture");
  if (shown && !shown->error.empty()) draw_text(at, colour::error, shown->error);
  if (studio.feed.snapshot() && studio.feed.snapshot()->snapshot.media.empty() &&
      studio.commands.job.what.empty()) {
    const std::string hint = "Nothing to see yet: drop a .vdb here, or take Scene > Begin with.";
    const ImVec2 size = ImGui::CalcTextSize(hint.c_str());
    draw_text(pane.begin + (pane.size - vec2(size.x, size.y)) * 0.5f, colour::faint_text, hint);
  }
  if (studio.show_display) show_figures(studio, pane);
  // While a picture refines, a thin line runs along its lower edge.
  const ViewRenderer::Status status = studio.renderer.status();
  if (status.is_busy && !studio.is_hand_on()) {
    const float y = pane.begin.y + pane.size.y - scaled(2);
    list->AddRectFilled({pane.begin.x, y}, {pane.begin.x + pane.size.x * float(status.share), y + scaled(2)},
                        (colour::accent & 0x00ffffff) | 0x90000000);
  }
}

void show_figures(Studio& studio, const PaneRect& pane) {
  const ViewPicturePtr picture = studio.picture();
  if (!picture) return;
  const RenderStats& stats = picture->stats;
  constexpr double mebibyte = 1024.0 * 1024.0;
  std::uint64_t voxels = 0;
  for (const Medium& medium : picture->scene.media)
    if (medium.volume) voxels += medium.volume->active_voxels;
  const std::vector<std::string> lines = {
      fmt::format("view     {:7.1f} ms", stats.view_ms),
      fmt::format("maps     {:7.1f} ms", stats.map_ms),
      fmt::format("upload   {:7.1f} ms", stats.upload_ms),
      fmt::format("picture  {:7.1f} ms", picture->render_ms),
      fmt::format("passes   {:7}", picture->passes),
      fmt::format("size     {:4}x{}", picture->frame.width, picture->frame.height),
      fmt::format("maps made{:7}", stats.map_builds),
      fmt::format("voxels   {:7.2f} M", double(voxels) / 1e6),
      fmt::format("on GPU   {:7.1f} MiB", double(stats.volume_bytes + stats.map_bytes) / mebibyte),
      fmt::format("asked    {:7}", studio.renderer.status().begun),
      fmt::format("overtaken{:7}", studio.renderer.status().dropped)};
  ImGui::PushFont(fonts().fixed);
  const float width = ImGui::CalcTextSize("maps made0000000 MiB  ").x,
              line = ImGui::GetTextLineHeight() + scaled(2);
  vec2 at(pane.begin.x + pane.size.x - width - scaled(10), pane.begin.y + scaled(36));
  ImGui::GetWindowDrawList()->AddRectFilled({at.x - scaled(8), at.y - scaled(6)},
                                            {at.x + width, at.y + line * float(lines.size()) + scaled(6)},
                                            0xa0101010, scaled(4));
  for (const std::string& text : lines) {
    draw_text(at, 0xffc8c4c2, text);
    at.y += line;
  }
  ImGui::PopFont();
}

void show_map_error(const Studio& studio, const DevelopedPtr& shown, const PaneRect& pane) {
  if (!shown || !shown->map_error) return;
  const MapError& error = *shown->map_error;
  const std::string figures =
      fmt::format("|T exact - T map|   mean {:.4f}   worst {:.3f}", error.mean, error.worst);
  const std::string end = fmt::format("{:g}", MapError::full_scale);
  const float width = scaled(160), height = scaled(8), line = ImGui::GetTextLineHeight() + scaled(3);
  const vec2 corner =
      pane.begin + pane.size - vec2(width + scaled(10), 2.0f * line + height + snapshot_strip_height(studio));
  constexpr int steps = 40;
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (int i = 0; i < steps; ++i) {
    const vec3 colour = heat_colour((float(i) + 0.5f) / steps);
    list->AddRectFilled({corner.x + width * float(i) / steps, corner.y},
                        {corner.x + width * float(i + 1) / steps, corner.y + height},
                        ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, 1.0f}));
  }
  draw_text(corner - vec2(0.0f, line), colour::faint_text, "0");
  draw_text(corner + vec2(width - ImGui::CalcTextSize(end.c_str()).x, -line), colour::faint_text, end);
  draw_text({pane.begin.x + pane.size.x - ImGui::CalcTextSize(figures.c_str()).x - scaled(10),
             corner.y - 2.0f * line},
            colour::text, figures);
}

}  // namespace plinian::window
