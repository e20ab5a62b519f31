// An empty scene in place of the one that is there, as an edit.
#pragma once

#include "host/graph/edits/editor.h"

namespace plinian::graph {

/// Takes out all nodes, and what the scene said of types and plug-ins that are not known here. Within one
/// scope of the history it is one step, so that a failure to read what is to come instead brings it all back.
void clear_graph(Editor& editor);

}  // namespace plinian::graph
