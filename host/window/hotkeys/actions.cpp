// A command, or a change of how the scene is looked at, for each action.
#include "host/window/hotkeys/actions.h"

#include "host/window/platform/desktop.h"
#include "host/window/studio.h"

namespace plinian::window {

namespace {

// A picture is found again by itself, whatever it is compared with just now.
Development seen_alone(Development how) {
  how.seen = Seen::picture;
  how.against = nullptr;
  how.against_file = nullptr;
  return how;
}

// What has been rendered further than its quick pass; null: not yet.
ViewPicturePtr whole_picture(const Studio& studio) {
  const ViewPicturePtr picture = studio.renderer.picture();
  return picture && !picture->quick ? picture : nullptr;
}

void keep_picture(Studio& studio) {
  const ViewPicturePtr picture = whole_picture(studio);
  studio.wants_snapshot = !picture;
  if (!picture) {
    studio.console.add(LineKind::note, "the snapshot is taken when the picture is past its quick pass");
    return;
  }
  const bool is_seen = studio.development.seen == Seen::picture;
  for (const std::string& name :
       studio.snapshots.keep(picture, is_seen ? studio.developer.developed() : nullptr))
    studio.console.add(LineKind::note, name + " was let go: snapshots hold all the memory that they may");
  if (!studio.snapshots.all().back().thumbnail)
    studio.snapshots.make_thumbnail(seen_alone(studio.development), Desktop::wake);
  // What one is measuring against stays; a click on the snapshot compares with it.
  const OtherKind kind = studio.comparison.kind;
  if (kind == OtherKind::none || kind == OtherKind::snapshot)
    studio.comparison.keep(picture, studio.snapshots.all().back().name, OtherKind::snapshot);
  studio.show_snapshots = true;
}

void key_selection(Studio& studio) {
  for (const graph::NodeId id : studio.session().graph().selection())
    if (const graph::Node& node = *studio.session().graph().find(id);
        node.schema->find("rotate") != graph::no_attribute)
      studio.run("setKeyframe " + node.name + ".translate " + node.name + ".rotate");
    else
      studio.console.add(LineKind::note, node.name + " has no place; 'setKeyframe " + node.name +
                                             ".ATTRIBUTE' keys what else it has");
}

}  // namespace

bool keep_wished_picture(Studio& studio) {
  if (!studio.wants_snapshot || !whole_picture(studio)) return false;
  keep_picture(studio);
  studio.console.add(LineKind::note, studio.snapshots.all().back().name + " is taken");
  studio.trace.note("took " + studio.snapshots.all().back().name);
  return true;
}

bool is_of_the_view(Action action) {
  switch (action) {
    case Action::tool_select:
    case Action::tool_translate:
    case Action::tool_rotate:
    case Action::tool_scale:
    case Action::axis_space:
    case Action::frame_all:
    case Action::camera_back:
    case Action::camera_forth:
    case Action::scene_camera:
    case Action::zoom_in:
    case Action::zoom_out:
    case Action::zoom_whole:
    case Action::wipe:
    case Action::side_by_side:
    case Action::flicker:
    case Action::flicker_turn:
    case Action::difference:
    case Action::probe:
    case Action::flip:
    case Action::toggle_display:
    case Action::toggle_panels:
    case Action::console_line:
    case Action::node_editor:
    case Action::hotkey_list:
    case Action::cancel:
      return true;
    default:
      return false;
  }
}

void act(Studio& studio, Action action) {
  // While a handle is held, what is not of the view waits: the drag is the last step of undo.
  if (studio.tools.is_dragging && action == Action::cancel) {
    studio.tools.give_up = true;
    return;
  }
  if (studio.tools.is_dragging && !is_of_the_view(action)) return;
  const bool selected = !studio.session().graph().selection().empty();
  Comparison& comparison = studio.comparison;
  switch (action) {
    case Action::undo:
      return studio.run("undo");
    case Action::redo:
      return studio.run("redo");
    case Action::new_scene:
      return studio.files.begin_empty();
    case Action::open_scene:
      studio.ask_open = true;
      return;
    case Action::save_scene:
      if (studio.session().scene_path().empty())
        studio.ask_save_as = true;
      else
        studio.run("save");
      return;
    case Action::save_scene_as:
      studio.ask_save_as = true;
      return;
    case Action::delete_nodes:
      if (selected) studio.run("delete -inputs");  // what only served it is of no use to anybody
      return;
    case Action::duplicate_nodes:
      if (selected) studio.run("duplicate");
      return;
    case Action::tool_select:
      studio.tools.tool = Tool::select;
      return;
    case Action::tool_translate:
      studio.tools.tool = Tool::translate;
      return;
    case Action::tool_rotate:
      studio.tools.tool = Tool::rotate;
      return;
    case Action::tool_scale:
      studio.tools.tool = Tool::scale;
      return;
    case Action::axis_space:
      studio.tools.switch_space();
      return;
    case Action::frame_selection:
      return studio.viewpoint.frame(true, studio.picture_size);
    case Action::frame_all:
      return studio.viewpoint.frame(false, studio.picture_size);
    case Action::camera_back:
      return studio.viewpoint.go_back();
    case Action::camera_forth:
      return studio.viewpoint.go_forth();
    case Action::scene_camera:
      return studio.viewpoint.look_through_scene_camera();
    case Action::zoom_in:
      ++studio.zoom_steps;
      return;
    case Action::zoom_out:
      --studio.zoom_steps;
      return;
    case Action::zoom_whole:
      studio.viewpoint.zoom = {};
      return;
    case Action::quality_fast:
      return studio.run("quality fast");
    case Action::quality_high:
      return studio.run("quality high");
    case Action::original_maps:
      studio.original_maps = !studio.original_maps;
      return;
    case Action::snapshot_picture:
      return keep_picture(studio);
    case Action::reference:
      return studio.render_reference();
    case Action::wipe:
      return comparison.toggle(CompareMode::wipe);
    case Action::side_by_side:
      return comparison.toggle(CompareMode::side_by_side);
    case Action::flicker:
      if (comparison.flicker_rate <= 0.0f) comparison.flicker_rate = 2.0f;
      return comparison.toggle(CompareMode::flicker);
    case Action::flicker_turn:
      if (comparison.mode() == CompareMode::flicker && comparison.flicker_rate <= 0.0f) {
        comparison.flicker_other = !comparison.flicker_other;
      } else {
        comparison.set_mode(CompareMode::flicker);
        comparison.flicker_rate = 0.0f;
        comparison.flicker_other = true;
      }
      return;
    case Action::difference:
      return comparison.toggle(CompareMode::difference);
    case Action::flip:
      return comparison.toggle(CompareMode::flip);
    case Action::load_reference:
      studio.ask_reference = true;
      return;
    case Action::playblast:
      studio.ask_playblast = true;
      return;
    case Action::probe:
      // Where it is behind the console it is wanted back.
      studio.inspector.on =
          !studio.inspector.on || (studio.inspector.is_docked && studio.inspector.is_behind);
      studio.inspector.is_behind = false;
      return;
    case Action::set_key:
      return key_selection(studio);
    case Action::toggle_display:
      studio.show_display = !studio.show_display;
      return;
    case Action::toggle_panels:
      studio.show_panels = !studio.show_panels;
      return;
    case Action::console_line:
      studio.focus_console = true;
      studio.show_nodes = false;
      studio.show_panels = true;
      studio.inspector.is_behind = true;
      return;
    case Action::node_editor:
      studio.show_nodes = !studio.show_nodes || !studio.show_panels || studio.inspector.is_beneath();
      studio.show_panels = true;
      studio.inspector.is_behind = true;
      return;
    case Action::palette:
      studio.show_palette = true;
      return;
    case Action::hotkey_list:
      studio.show_hotkeys = !studio.show_hotkeys;
      return;
    case Action::cancel:
      if (std::exchange(studio.show_hotkeys, false)) return;
      if (studio.commands.job.what.empty() && std::exchange(studio.show_looks, false)) return;
      studio.commands.job.cancelled = true;
      if (std::exchange(studio.wants_snapshot, false))
        studio.console.add(LineKind::note, "no snapshot is taken");
      comparison.stop_reference();
      studio.playblast.cancel();
      studio.viewpoint.stop_waiting();
      if (studio.commands.job.what.empty()) studio.feed.cancel();
      return;
    default:
      return;
  }
}

}  // namespace plinian::window
