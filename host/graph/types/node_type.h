// What a kind of node is: its attributes, how its outputs are computed, and how older scenes are read.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/graph/types/schema.h"

namespace plinian::graph {

class ComputeContext;

/// The attributes of one node as a scene file has them, before they mean anything: what migrators rewrite.
struct StoredAttribute {
  std::string path;  // "key[3].time"
  std::string text;  // words, as in the file
};
using StoredAttributes = std::vector<StoredAttribute>;

/// Rewrites attributes that a scene of the type's version `from` holds into those of version `from + 1`.
/// Throws where it cannot: the nodes of the type then stay as they stand in the scene.
struct Migrator {
  int from = 1;
  std::function<void(StoredAttributes& attributes)> migrate;
};

/// A name that an attribute had before; scenes and scripts that use it still work.
struct AttributeAlias {
  std::string old_path, path;
};

/// What an attribute is called now: the path itself, or the one that an old name stands for.
std::string current_path(const std::vector<AttributeAlias>& aliases, std::string_view path);

/// Declared by whoever makes a node type.
struct NodeTypeSpec {
  std::string name;
  int version = 1;  // goes up where scenes need migrating
  std::string help;
  std::vector<AttributeSpec> attributes;
  /// Writes `output` and may write other outputs that nothing more affects. Throws to fail: the message
  /// becomes the error of the output. Never touches the graph: everything it may read is in the context.
  std::function<void(ComputeContext& context, AttributeIndex output)> compute;
  bool concurrent = true;       // compute may run on several threads at a time
  bool time_source = false;     // tells the current time; everything downstream depends on it
  bool hierarchical = false;    // has a place in the transform hierarchy
  bool holds_children = false;  // ... and may be a parent in it
  bool unique = false;          // a scene has one: what is imported shares it instead of bringing its own
  bool follows = false;         // deleted with the last node that it drives, as an animation curve is
  std::vector<Migrator> migrators;
  std::vector<AttributeAlias> aliases;
  std::string plugin, plugin_version;  // who registers it; empty: the program itself
};

/// A registered node type; shared by its nodes and never changed.
class NodeType {
 public:
  /// Throws GraphError, naming the type, where the declaration contradicts itself.
  explicit NodeType(NodeTypeSpec spec);
  /// What stands in for a type that is not registered here: without attributes, and knowing its name only.
  static std::shared_ptr<const NodeType> unknown(std::string name, int version);
  /// What is left of a type whose code goes: its declaration without a function. Only steps of undo hold
  /// nodes of it.
  std::shared_ptr<const NodeType> without_code() const;

  const std::string& name() const { return spec_.name; }
  int version() const { return spec_.version; }
  const NodeTypeSpec& spec() const { return spec_; }
  const SchemaPtr& schema() const { return schema_; }
  bool is_unknown() const { return unknown_; }
  bool has_no_code() const { return codeless_; }
  /// Whether edits of nodes of the one type mean the same for the other: attributes of the same names, types,
  /// defaults and hard ranges in the same order, and the same version.
  bool holds_the_same(const NodeType& other) const;
  /// As the function of that name.
  std::string current_path(std::string_view path) const { return graph::current_path(spec_.aliases, path); }

 private:
  NodeType() = default;

  NodeTypeSpec spec_;
  SchemaPtr schema_;
  bool unknown_ = false, codeless_ = false;
};

using NodeTypePtr = std::shared_ptr<const NodeType>;

}  // namespace plinian::graph
