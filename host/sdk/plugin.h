// What a plug-in includes: C++ over the plain C of abi.h. It needs nothing else of Plinian, and everything in
// it is compiled into the plug-in.
//
//   #include "host/sdk/plugin.h"
//
//   static void initialise(plinian::sdk::Plugin& plugin) {
//     using namespace plinian::sdk;
//     NodeType type("wobble");
//     const Attribute amount = type.add({.name = "amount", .default_value = "1", .affects = "out"});
//     const Attribute out = type.add({.name = "out", .output = true});
//     type.compute = [=](Context& context, Attribute) { context.set(out, 2.0 * context.number(amount)); };
//     plugin.add(type);
//   }
//   PLINIAN_PLUGIN("wobble", "1.0", "A. Artist", "node:wobble", initialise);
#pragma once

#include <deque>
#include <map>

#include "host/sdk/abi.h"
#include "host/sdk/plugin/command.h"
#include "host/sdk/plugin/data_type.h"
#include "host/sdk/plugin/event.h"
#include "host/sdk/plugin/node.h"

namespace plinian {
namespace PLINIAN_HIDDEN sdk {

namespace detail {

// What one host was given; it lives until the plug-in is uninitialised there.
struct Registered {
  std::deque<NodeType> types;
  std::deque<Command> commands;
  std::deque<DataType> data_types;
  std::deque<FileType> file_types;
  std::shared_ptr<const bool> alive = std::make_shared<bool>(true);
  std::deque<Subscription> subscriptions;
};

}  // namespace detail

/// Registers what the plug-in brings. Throws Error where the host refuses.
class Plugin {
 public:
  Plugin(const PlinianHost& host, detail::Registered& registered) : host_(host), registered_(registered) {}

  void add(NodeType type) {
    registered_.types.push_back(std::move(type));
    check(detail::register_type(host_, registered_.types.back()));
  }
  void add(Command command) {
    registered_.commands.push_back(std::move(command));
    check(detail::register_command(host_, registered_.commands.back()));
  }

  void add(DataType type) {
    registered_.data_types.push_back(std::move(type));
    check(detail::register_data_type(host_, registered_.data_types.back()));
  }
  void add(FileType type) {
    registered_.file_types.push_back(std::move(type));
    check(detail::register_file_type(host_, registered_.file_types.back()));
  }
  void add(const MenuEntry& entry) { check(detail::register_menu_entry(host_, entry)); }

  /// Calls back on every event of a kind for as long as the plug-in is loaded. kind: as in PlinianEvent.
  void on(const std::string& kind, std::function<void(const Event&)> callback) {
    registered_.subscriptions.push_back(subscribe(kind, std::move(callback)));
  }
  /// ... or until the subscription is destroyed.
  [[nodiscard]] Subscription subscribe(const std::string& kind, std::function<void(const Event&)> callback) {
    return Subscription(host_, registered_.alive, kind, std::move(callback));
  }

 private:
  static void check(int success) {
    if (!success) throw Error("the host refuses it");  // and knows why
  }

  const PlinianHost& host_;
  detail::Registered& registered_;
};

namespace detail {

// By host: several scenes may be open in one program.
inline std::map<const PlinianHost*, Registered>& registered() {
  static std::map<const PlinianHost*, Registered> all;
  return all;
}

inline int initialise(const PlinianHost* host, void (*function)(Plugin&)) {
  int success = 0;
  guarded(
      [&] {
        Plugin plugin(*host, registered()[host]);
        function(plugin);
        success = 1;
      },
      [&](const char* message) { host->fail(host->self, message); });
  return success;
}
inline void uninitialise(const PlinianHost* host) {
  registered().erase(host);
}

// An ELF note: name, description, type, as the System V ABI lays them out. An aggregate: GCC puts what has a
// constructor into a section that can be written to, as no note may be.
template <std::size_t N>
struct Note {
  std::uint32_t name_size = 8, text_size = N, type = 1;
  char name[8] = {'P', 'l', 'i', 'n', 'i', 'a', 'n', 0};
  char text[(N + 3) / 4 * 4] = {};
};
template <std::size_t N>
constexpr Note<N> note_of(const char (&source)[N]) {
  Note<N> note;
  for (std::size_t i = 0; i < N; ++i) note.text[i] = source[i];
  return note;
}

}  // namespace detail
}  // namespace sdk
}  // namespace plinian

#define PLINIAN_STRING_(x) #x
#define PLINIAN_STRING(x) PLINIAN_STRING_(x)
#define PLINIAN_DESCRIPTION_(plugin_name, plugin_version, plugin_vendor, registers)                         \
  "name " plugin_name "\nversion " plugin_version "\nvendor " plugin_vendor                                 \
  "\nabi " PLINIAN_STRING(PLINIAN_ABI_MAJOR) "." PLINIAN_STRING(PLINIAN_ABI_MINOR) "\nregisters " registers \
                                                                                   "\n"

/// Makes a shared library a plug-in: describes it, in a note that is read without loading it, and exports
/// what the host calls. registers: "node:TYPE command:NAME data:TYPE file:NAME", each type, command, data
/// type and file type that it brings and no other, else it is refused; it and what stands before it are
/// string literals. initialise_function: void (plinian::sdk::Plugin&); throws to refuse.
#define PLINIAN_PLUGIN(plugin_name, plugin_version, plugin_vendor, registers, initialise_function) \
  __attribute__((section(".note.plinian"), used, aligned(4))) constexpr auto plinian_plugin_note = \
      plinian::sdk::detail::note_of(                                                               \
          PLINIAN_DESCRIPTION_(plugin_name, plugin_version, plugin_vendor, registers));            \
  extern "C" int plinian_initialise(const PlinianHost* host) {                                     \
    return plinian::sdk::detail::initialise(host, initialise_function);                            \
  }                                                                                                \
  extern "C" void plinian_uninitialise(const PlinianHost* host) {                                  \
    plinian::sdk::detail::uninitialise(host);                                                      \
  }                                                                                                \
  static_assert(true)

/// The same for a plug-in that is compiled into the program, which may hold several: a constant of the name
/// `symbol`, for PluginManager::add_linked.
#define PLINIAN_LINKED_PLUGIN(symbol, plugin_name, plugin_version, plugin_vendor, registers,               \
                              initialise_function)                                                         \
  extern const PlinianLinkedPlugin symbol;                                                                 \
  const PlinianLinkedPlugin symbol = {                                                                     \
      sizeof(PlinianLinkedPlugin),                                                                         \
      PLINIAN_DESCRIPTION_(plugin_name, plugin_version, plugin_vendor, registers),                         \
      [](const PlinianHost* host) { return plinian::sdk::detail::initialise(host, initialise_function); }, \
      plinian::sdk::detail::uninitialise};                                                                 \
  static_assert(true)
