// The node types that this program knows at the moment.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "host/graph/types/node_type.h"

namespace plinian::graph {

class TypeRegistry {
 public:
  /// Throws GraphError where the name is taken or the declaration contradicts itself.
  NodeTypePtr add(NodeTypeSpec spec);
  /// Forgets a type; nodes that have it keep it until the graph turns them into unknown ones.
  void remove(std::string_view name);
  /// The type of that name, or null.
  NodeTypePtr find(std::string_view name) const;
  /// The type of that name. Throws GraphError with the nearest name.
  NodeTypePtr get(std::string_view name) const;
  std::vector<std::string> names() const;

 private:
  std::map<std::string, NodeTypePtr, std::less<>> types_;
};

}  // namespace plinian::graph
