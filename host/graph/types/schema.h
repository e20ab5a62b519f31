// The attributes of a node type as one flat table: compounds, their children, and who affects whom.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/graph/types/attribute_spec.h"

namespace plinian::graph {

/// Place of an attribute in its schema; what a compute function reads and writes by.
using AttributeIndex = std::int32_t;
inline constexpr AttributeIndex no_attribute = -1;

struct SchemaAttribute {
  AttributeSpec spec;                    // without its children, which stand in the table themselves
  std::string path;                      // "colour", "key.time": names from the outermost compound inwards
  AttributeIndex parent = no_attribute;  // the compound it is in
  AttributeIndex array = no_attribute;   // the array that it is, or is a part of; there is at most one
  std::vector<AttributeIndex> children;
  std::vector<AttributeIndex> affects;      // outputs, without compounds
  std::vector<AttributeIndex> affected_by;  // of an output: its inputs, without compounds
  bool dynamic = false;                     // added to one node by addAttr
};

class Schema {
 public:
  Schema() = default;
  /// Throws GraphError where a declaration contradicts itself: a name twice, an array in an array, a default
  /// out of its range, an enum without choices, an output that is affected by nothing that exists.
  explicit Schema(const std::vector<AttributeSpec>& specs);

  /// This schema and one more attribute, which a single node has. Throws GraphError as above.
  Schema with_dynamic(const AttributeSpec& spec) const;
  /// This schema without the attribute that was added last.
  Schema without_last_dynamic() const;

  AttributeIndex size() const { return AttributeIndex(attributes_.size()); }
  const SchemaAttribute& operator[](AttributeIndex index) const { return attributes_[std::size_t(index)]; }
  /// The attribute of that path, or no_attribute.
  AttributeIndex find(std::string_view path) const;
  /// Paths of all attributes, for "did you mean".
  std::vector<std::string> paths() const;
  /// Attributes that stand at the top, in order of declaration.
  std::span<const AttributeIndex> top() const { return top_; }
  /// The attribute as it would be declared, children and all.
  AttributeSpec declaration(AttributeIndex index) const;
  /// The attribute itself, or what a compound holds at the bottom, in order of declaration.
  std::vector<AttributeIndex> leaves(AttributeIndex index) const;
  /// Computed attributes, without compounds.
  std::span<const AttributeIndex> outputs() const { return outputs_; }

 private:
  AttributeIndex add(const AttributeSpec& spec, AttributeIndex parent, bool dynamic);
  void connect_affects();

  std::vector<SchemaAttribute> attributes_;
  std::vector<AttributeIndex> top_, outputs_;
  std::map<std::string, AttributeIndex, std::less<>> by_path_;
};

using SchemaPtr = std::shared_ptr<const Schema>;

}  // namespace plinian::graph
