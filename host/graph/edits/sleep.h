// Steps of undo whose plug-in goes: what they hold of it sleeps until the plug-in is back.
//
// Steps outlive plug-ins. Nodes in them keep their place and values under a type without code, data become
// their bytes; no step that holds either can be undone or done again before they wake.
#pragma once

#include <string>

#include "host/graph/edits/history.h"

namespace plinian::graph {

/// "nodes of the type 'wobble': load the plug-in 'ashworks' first", where the edit would bring back what
/// sleeps; else empty.
std::string sleeping_part(const Edit& edit);

/// Nodes of the type that steps hold lose its code; values of the data type become bytes.
void put_to_sleep(History& history, const NodeTypePtr& type);
/// Forgets the steps whose data cannot be written, as forget_steps_where() does, and returns how many.
std::size_t put_to_sleep(History& history, const DataType& type);

/// Gives the nodes and values of steps back what a plug-in registers again. Steps that do not fit it any
/// more, since its attributes are others or its data cannot be read, are forgotten likewise; returns how
/// many.
std::size_t wake(History& history, const NodeTypePtr& type);
std::size_t wake(History& history, const DataType& type);

}  // namespace plinian::graph
