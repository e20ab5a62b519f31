// Snapshots: picture, scene and figures under a name, to be compared with or gone back to.
//
// They belong to the window and end with it. Their pictures are kept whole, layers and all, so that what is
// compared can be looked at in any way; memory is bounded by letting the oldest go.
#pragma once

#include <deque>
#include <functional>
#include <future>
#include <string>
#include <vector>

#include "host/scene/workspace.h"
#include "host/window/view/developer.h"

namespace plinian::window {

struct Snapshot {
  std::string name;
  ViewPicturePtr picture;
  std::string scene;       // the text of its scene
  DevelopedPtr thumbnail;  // as it was looked at; null while it is made
  std::string figures;     // "high, 640x480, 6 passes in 1.2 s"
};

class Snapshots {
 public:
  /// Adds the commands restoreSnapshot and deleteSnapshot to the session, for as long as this lives.
  explicit Snapshots(scene::Workspace& workspace, std::size_t budget_bytes = std::size_t(512) << 20);
  ~Snapshots();
  Snapshots(const Snapshots&) = delete;
  Snapshots& operator=(const Snapshots&) = delete;

  /// Keeps what is shown; where that is not the picture itself but what it is compared with, shown is null,
  /// and make_thumbnail() follows. name: made unique; empty: "snapshot N". Returns the names of those that
  /// had to go for it; the new one never does.
  std::vector<std::string> keep(const ViewPicturePtr& picture, const DevelopedPtr& shown,
                                const std::string& name = "");
  /// Develops the picture of the newest beside the caller, for its thumbnail. wake: called on another thread
  /// when it is there; must not block.
  void make_thumbnail(const Development& how, std::function<void()> wake);
  /// Takes over thumbnails that are done. To be called once a turn.
  void update();
  const std::deque<Snapshot>& all() const { return all_; }
  const Snapshot* find(const std::string& name) const;
  void forget(const std::string& name);
  std::size_t bytes() const;  // of the pictures

 private:
  /// Throws GraphError, with the name of the command, where there is none.
  const Snapshot& get(const std::string& command, const std::string& name) const;

  scene::Workspace& workspace_;
  std::size_t budget_;
  std::deque<Snapshot> all_;  // oldest first
  struct Making {
    ViewPicturePtr picture;  // whose thumbnail it is
    std::future<DevelopedPtr> thumbnail;
  };
  std::vector<Making> making_;
  int made_ = 0;
};

/// The developed picture at that height [pixels], each pixel the mean of those that it stands for.
DevelopedPtr thumbnail_of(const Developed& shown, int height);

/// Memory that a frame holds [bytes].
std::size_t bytes_of(const Frame& frame);

}  // namespace plinian::window
