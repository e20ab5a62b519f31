// Commands that plug-ins declare, as the graph's own declarations.
#pragma once

#include <memory>

#include "host/graph/commands/file_types.h"
#include "host/sdk/abi.h"
#include "host/sdk/data_count.h"

namespace plinian::sdk {

/// Throws GraphError where the declaration makes no sense.
graph::CommandSpec command_from(const PlinianCommand* plain, const std::shared_ptr<DataCount>& data);
graph::FileType file_type_from(const PlinianFileType* plain, const std::shared_ptr<DataCount>& data);

struct MenuItem {
  std::string path, command, help;
  std::string plugin;  // who registers it
};
MenuItem menu_entry_from(const PlinianMenuEntry* plain);

}  // namespace plinian::sdk
