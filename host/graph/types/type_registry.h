// The node types that this program knows at the moment.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "host/graph/types/names_elsewhere.h"
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
  /// Types that are not there and could be.
  NamesElsewhere elsewhere;

  /// Attributes of this data type can be stored from now on. Throws GraphError where the name is taken.
  void add_data_type(DataType type);
  void remove_data_type(const std::string& name);
  /// The data type of that name, or null.
  DataTypePtr find_data_type(const std::string& name) const;

 private:
  void give_slots(std::vector<AttributeSpec>& attributes);
  const std::shared_ptr<DataSlot>& slot(const std::string& data_type);

  std::map<std::string, NodeTypePtr, std::less<>> types_;
  std::map<std::string, std::shared_ptr<DataSlot>> slots_;  // by data type
};

}  // namespace plinian::graph
