// A graph as the text of a scene file.
//
//   plinian scene 1.0
//   requires atfm 1.2                    plug-ins, by name
//   node transform cloud                 nodes in the order of their creation: type and name
//     .translate 0 2.5 0                 one attribute per line; what is at its default is left out
//   node volumeNoise noise1 under cloud
//     add float glow min 0               an attribute of this node alone
//     .density 3
//     .seed <- curve1.out                a connection stands where it ends
//     lock .density
//   type transform 1                     each type in use, its version, and the defaults that were left out
//     .translate 0 0 0
//   end                                  without it the file was cut off
//
// The defaults stand in the file so that a program with other ones reads the same scene. Deliberately left
// out: selection, time and view, which are no part of a scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/graph/model/graph.h"

namespace plinian::graph {

inline constexpr int scene_major_version = 1, scene_minor_version = 0;

/// The text of the whole scene; the same graph gives the same text, whatever was done to get there. folder:
/// where the scene goes; paths of what lies in it or under it are written relative to it, so that it may be
/// moved as a whole. Empty: paths are written as they are.
std::string write_scene(const Graph& graph, const std::filesystem::path& folder = {});

/// As above with only some nodes; connections from others are left out.
std::string write_scene(const Graph& graph, const std::vector<NodeId>& nodes,
                        const std::filesystem::path& folder = {});

/// What stands under a node's own line, without line ends.
std::vector<std::string> node_lines(const Graph& graph, const Node& node,
                                    const std::filesystem::path& folder = {});

/// What stands under a type's own line: the default of everything that scenes store and, each at its place,
/// what is kept of the scene's own section (null: nothing).
std::vector<std::string> type_lines(const NodeType& type, const KeptType* kept = nullptr);

/// Saves the scene, whole or not at all: on the disk before it replaces the old file, which stays as
/// `path`.bak. Throws FileError.
void save_scene(const std::string& path, const std::string& text);

}  // namespace plinian::graph
