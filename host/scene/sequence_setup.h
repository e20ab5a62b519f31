// What a sequence is set up by, once for all of its frames.
//
// Frames are read one after the other until one shows anything; where a camera is to be placed, the middle
// and the last of those that follow are read as well, because what burns or rises outgrows its first frame;
// in the place of one that is broken stands the one before it that can be read. Which frames are rendered has
// no say, so that parts of a sequence that are made apart fit together. Deliberately left out: reading all
// frames, which would take as long as a picture of each.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/media/vdb_reader.h"

namespace plinian::scene {

struct SequenceSetup {
  std::vector<int> frames;                                 // of the disk, ascending
  int frame = 0;                                           // the first that shows anything, else the first
  std::shared_ptr<const BrickVolume> volume;               // of that frame; never null
  VdbFacts facts;                                          // of that frame, the orientation as below
  std::vector<std::shared_ptr<const BrickVolume>> others;  // further ones that a camera has to show
  std::string note;     // "3 frames, 1 to 3; set up by frame 2, the first that shows anything"
  std::string warning;  // where no frame shows anything; else empty
};

/// A frame as it was read.
struct SequenceFrame {
  std::shared_ptr<const BrickVolume> volume;  // empty where there is nothing to be read
  VdbFacts facts;
  bool readable = true;  // false: it is missing or broken, and whatever is shown says nothing of it
};

/// frames: of the disk, ascending, at least one. read: goes to a frame and reads it. whole: also reads frames
/// for `others`. The orientation is that of the first of these files that says one, for a program that writes
/// it into some frames means all of them. Throws what `read` throws.
SequenceSetup set_up_sequence(std::vector<int> frames, bool whole,
                              const std::function<SequenceFrame(int)>& read);

}  // namespace plinian::scene
