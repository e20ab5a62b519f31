// The command "reload": files that changed on the disk are read again.
#include <sstream>

#include "host/nodes/node_types.h"
#include "host/nodes/volume_store.h"

namespace plinian::nodes {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

void add_reload(sdk::Plugin& plugin, std::shared_ptr<VolumeStore> store) {
  plugin.add(sdk::Command{
      .name = "reload",
      .help =
          "Reads files again that changed since, and frames that were missing; answers with what changed.",
      .flags = {{.name = "check", .kind = "", .help = "only says which files have changed"}},
      .run = [store](sdk::Call& call) {
        for (const std::string& file : store->changed_files()) call.answer(file);
        if (call.given("check")) return;
        // What did not change is found where it is held.
        for (const std::string& node : lines_of(call.execute("ls -type volumeRead"))) {
          const int number = std::stoi(call.execute("getAttr " + node + ".reload"));
          call.execute("setAttr " + node + ".reload " + std::to_string(number + 1));
        }
      }});
}

}  // namespace plinian::nodes
