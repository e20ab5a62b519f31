// The lines of a node in a scene file, made into a node: migrated, parsed, and kept where they mean nothing
// here.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/graph/edits/editor.h"
#include "host/graph/files/scene_sections.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

/// What a scene says that is no reason to refuse it; `line` is 0 where none is to blame.
using WarnLine = std::function<void(int line, const std::string& message)>;

/// What of a node can be read only when the others are there.
struct NodeLinks {
  struct Link {
    std::string path;   // of the attribute
    std::string text;   // reference: the name; connection: NODE.ATTRIBUTE
    std::string line;   // as it stands in the scene
    int number;         // of it
    LinePlace place{};  // where it stays if it means nothing here
  };
  std::vector<Link> references, connections, locks;
};

/// A node as its lines describe it.
struct NodeText {
  Node node;  // without id, parent and connections
  NodeLinks links;
};

/// A migrator that failed. Since a scene has one version of a type, all nodes of it stay as they stand there,
/// as unknown ones of the old version, until a type is registered that can migrate them.
struct MigrationError : GraphError {
  MigrationError(std::string of_type, const std::string& message)
      : GraphError(message), type(std::move(of_type)) {}
  std::string type;
};

/// The place of a line about an attribute of the node; empty where it has none of that path.
std::optional<LinePlace> place_in(const Node& node, const std::string& path, bool lock = false);

/// Reads nodes of one type, given what the scene says of it.
class NodeReader {
 public:
  /// section: the scene's section of the type; newer: the scene is of a newer version, so that lines unknown
  /// here are kept instead of refused.
  /// What the section looks into must outlive the reader.
  NodeReader(NodeTypePtr type, const TypeSection& section, bool newer);

  /// Throws GraphError, without the line's place, through `fail_at`, for what no scene holds, and
  /// MigrationError, naming the node.
  NodeText read(const std::string& name, const std::vector<SceneLine>& lines, const WarnLine& warn,
                const std::function<void(int line, const std::string&)>& fail) const;

  /// What is to be kept of the type's section: of an unknown type all, of a known one what is not known of
  /// it.
  KeptType kept() const;
  bool keeps_anything() const;
  const NodeTypePtr& type() const { return type_; }

 private:
  void migrate(const std::string& name, StoredAttributes& stored) const;

  NodeTypePtr type_;
  TypeSection section_;
  bool newer_;
  std::vector<std::pair<AttributeIndex, Value>> other_defaults_;  // in the scene than here
  std::vector<std::string> unknown_lines_;                        // of the section
  std::vector<std::string> unknown_after_;                        // ... as KeptType::after
};

/// The second half, when all nodes are there: references, connections and locks. What cannot be used is kept.
/// node_of: the node that the scene calls by a name; 0 where there is none.
void finish_node(Editor& editor, NodeId node, const NodeLinks& links,
                 const std::function<NodeId(std::string_view)>& node_of, const WarnLine& warn);

}  // namespace plinian::graph
