// What a plug-in includes: C++ over the plain C of abi.h. It needs nothing else of Plinian, and everything in
// it is compiled into the plug-in.
//
//   #include "host/sdk/plugin.h"
//
//   PLINIAN_PLUGIN("wobble", "1.0", "A. Artist", "node:wobble");
//
//   void plinian::sdk::initialise(Plugin& plugin) {
//     NodeType type("wobble");
//     const Attribute amount = type.add({.name = "amount", .default_value = "1", .affects = "out"});
//     const Attribute out = type.add({.name = "out", .output = true});
//     type.compute = [=](Context& context, Attribute) { context.set(out, 2.0 * context.number(amount)); };
//     plugin.add(type);
//   }
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "host/sdk/abi.h"

// Hidden, so that nothing of one plug-in is taken for the same thing of another.
namespace plinian {
namespace sdk __attribute__((visibility("hidden"))) {

  /// Something was asked that cannot be; the message is the host's or the plug-in's own.
  struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  /// An attribute of the node type that declared it.
  struct Attribute {
    std::int32_t index = -1;
    bool operator==(const Attribute& other) const { return index == other.index; }
  };

  /// As the host's own declaration of an attribute. Types and defaults are spelled as in scene files.
  struct AttributeSpec {
    std::string name, type = "float", default_value, nice_name, help, unit, group, choices, data_type,
                      affects;
    std::optional<double> minimum, maximum, soft_minimum, soft_maximum;
    bool array = false, output = false, hidden = false, read_only = false;
    bool keyable = true, storable = true, connectable = true;
    std::vector<AttributeSpec> children;
  };

  /// What a compute function sees of the world. Throws Error where an input failed or is of another type.
  class Context {
   public:
    Context(const PlinianCompute& table, PlinianContext* context) : table_(table), context_(context) {}

    double number(Attribute a, std::int32_t element = -1) const { return read_number(a, element, nullptr); }
    double number_at(double time, Attribute a, std::int32_t element = -1) const {
      return read_number(a, element, &time);
    }
    std::array<float, 4> vector(Attribute a, std::int32_t element = -1) const {
      std::array<float, 4> value{};
      check(table_.read_vector(context_, a.index, element, nullptr, value.data()));
      return value;
    }
    std::array<double, 16> matrix(Attribute a, std::int32_t element = -1) const {
      std::array<double, 16> value{};
      check(table_.read_matrix(context_, a.index, element, nullptr, value.data()));
      return value;
    }
    std::string text(Attribute a, std::int32_t element = -1) const {
      const char* value = "";
      check(table_.read_text(context_, a.index, element, nullptr, &value));
      return value;
    }
    /// Null where there are none yet.
    const void* data(Attribute a, std::int32_t element = -1) const {
      const void* object = nullptr;
      check(table_.read_data(context_, a.index, element, nullptr, &object));
      return object;
    }
    std::vector<std::int32_t> elements(Attribute array) const {
      const std::int32_t* found = nullptr;
      const std::size_t count = table_.elements(context_, array.index, &found);
      return std::vector<std::int32_t>(found, found + count);
    }

    void set(Attribute a, double value) { check(table_.write_number(context_, a.index, value)); }
    void set(Attribute a, std::initializer_list<float> value) {
      check(table_.write_vector(context_, a.index, value.begin(), std::int32_t(value.size())));
    }
    void set(Attribute a, const std::array<double, 16>& matrix) {
      check(table_.write_matrix(context_, a.index, matrix.data()));
    }
    void set(Attribute a, const std::string& text) {
      check(table_.write_text(context_, a.index, text.c_str()));
    }
    /// Hands an object on. bytes: that it holds; content: as in PlinianData.
    template <class T>
    void set_data(Attribute a, const char* type, std::unique_ptr<const T> object, std::size_t bytes,
                  std::uint64_t content = 0) {
      const PlinianData data{sizeof(PlinianData), type, object.release(), bytes, content, [](const void* p) {
                               delete static_cast<const T*>(p);
                             }};
      check(table_.write_data(context_, a.index, &data));
    }

    bool cancelled() const { return table_.cancelled(context_) != 0; }
    void progress(double fraction, const std::string& what) {
      table_.progress(context_, fraction, what.c_str());
    }

   private:
    double read_number(Attribute a, std::int32_t element, const double* time) const {
      double value = 0.0;
      check(table_.read_number(context_, a.index, element, time, &value));
      return value;
    }
    void check(int success) const {
      if (!success) throw Error(table_.error(context_));
    }

    const PlinianCompute& table_;
    PlinianContext* context_;
  };

  /// The attributes of a node in an older scene, by their paths, as texts.
  class Migration {
   public:
    Migration(const PlinianMigrate& table, PlinianMigration* migration)
        : table_(table), migration_(migration) {}
    std::optional<std::string> text(const std::string& path) const {
      const char* found = table_.text(migration_, path.c_str());
      return found ? std::optional<std::string>(found) : std::nullopt;
    }
    void set(const std::string& path, const std::string& text) {
      table_.set(migration_, path.c_str(), text.c_str());
    }
    void remove(const std::string& path) { table_.remove(migration_, path.c_str()); }

   private:
    const PlinianMigrate& table_;
    PlinianMigration* migration_;
  };

  struct NodeType {
    explicit NodeType(std::string type_name, int type_version = 1)
        : name(std::move(type_name)), version(type_version) {}

    /// The attribute's number; those of its children follow it.
    Attribute add(AttributeSpec spec) {
      const Attribute attribute{count_};
      count_ += size_of(spec);
      attributes.push_back(std::move(spec));
      return attribute;
    }
    /// The child of a compound that was added.
    static Attribute child(Attribute compound, const AttributeSpec& spec, const std::string& name) {
      std::int32_t index = compound.index + 1;
      for (const AttributeSpec& child : spec.children) {
        if (child.name == name) return {index};
        index += size_of(child);
      }
      throw Error("there is no child '" + name + "'");
    }

    std::string name, help, aliases;  // aliases: "old=new older=new"
    int version = 1;
    bool concurrent = true, hierarchical = false, holds_children = false, follows = false;
    std::vector<AttributeSpec> attributes;
    std::function<void(Context&, Attribute output)> compute;
    /// From version `from` to the next one.
    std::function<void(int from, Migration&)> migrate;

   private:
    static std::int32_t size_of(const AttributeSpec& spec) {
      std::int32_t count = 1;
      for (const AttributeSpec& child : spec.children) count += size_of(child);
      return count;
    }
    std::int32_t count_ = 0;
  };

  /// A running command. Throws Error where another command that it runs fails.
  class Call {
   public:
    Call(const PlinianCommandContext& table, PlinianCall* call) : table_(table), call_(call) {}
    bool given(const std::string& argument) const { return table_.given(call_, argument.c_str()) != 0; }
    std::vector<std::string> words(const std::string& argument) const {
      std::vector<std::string> result;
      for (std::size_t i = 0; i < table_.word_count(call_, argument.c_str()); ++i)
        result.push_back(table_.word(call_, argument.c_str(), i));
      return result;
    }
    /// Runs another command as a part of this one; returns what it answers.
    std::string execute(const std::string& line) {
      const char* answers = "";
      if (!table_.execute(call_, line.c_str(), &answers)) throw Error(table_.error(call_));
      return answers;
    }
    void answer(const std::string& line) { table_.answer(call_, line.c_str()); }

   private:
    const PlinianCommandContext& table_;
    PlinianCall* call_;
  };

  struct Argument {
    std::string name, kind = "text", help;
    bool optional = false, many = false;
  };

  struct Command {
    std::string name, help;
    std::vector<Argument> parameters, flags;  // a flag of kind "" takes no word
    std::function<void(Call&)> run;
  };

  /// Registers what the plug-in brings. Throws Error where the host refuses.
  class Plugin {
   public:
    explicit Plugin(const PlinianHost& host) : host_(host) {}
    void add(NodeType type);
    void add(Command command);

   private:
    const PlinianHost& host_;
  };

  /// Defined by the plug-in.
  void initialise(Plugin & plugin);

  // ---------------------------------------------------------------------------------------------------------------------
  // What follows is how it works.

  namespace detail {

  // Registered things live until the plug-in is uninitialised.
  struct Registered {
    std::deque<NodeType> types;
    std::deque<Command> commands;
  };
  inline Registered& registered() {
    static Registered all;
    return all;
  }

  // Runs a function of the plug-in; nothing that it throws crosses the boundary.
  template <class Action, class Fail>
  void guarded(const Action& action, const Fail& fail) {
    try {
      action();
    } catch (const std::exception& error) {
      fail(error.what());
    } catch (...) {
      fail("failed without saying why");
    }
  }

  inline const char* text_or_null(const std::string& text) {
    return text.empty() ? nullptr : text.c_str();
  }
  inline const double* number_or_null(const std::optional<double>& number) {
    return number ? &*number : nullptr;
  }

  // The C form of attributes; children live in `store`.
  inline PlinianAttribute plain(const AttributeSpec& spec, std::deque<std::vector<PlinianAttribute>>& store) {
    std::vector<PlinianAttribute> children;
    for (const AttributeSpec& child : spec.children) children.push_back(plain(child, store));
    store.push_back(std::move(children));
    PlinianAttribute result{};
    result.size = sizeof(PlinianAttribute);
    result.name = spec.name.c_str();
    result.type = spec.type.c_str();
    result.default_value = text_or_null(spec.default_value);
    result.nice_name = text_or_null(spec.nice_name);
    result.help = text_or_null(spec.help);
    result.unit = text_or_null(spec.unit);
    result.group = text_or_null(spec.group);
    result.choices = text_or_null(spec.choices);
    result.data_type = text_or_null(spec.data_type);
    result.affects = text_or_null(spec.affects);
    result.minimum = number_or_null(spec.minimum);
    result.maximum = number_or_null(spec.maximum);
    result.soft_minimum = number_or_null(spec.soft_minimum);
    result.soft_maximum = number_or_null(spec.soft_maximum);
    result.flags =
        (spec.array ? PLINIAN_ATTRIBUTE_ARRAY : 0u) | (spec.output ? PLINIAN_ATTRIBUTE_OUTPUT : 0u) |
        (spec.hidden ? PLINIAN_ATTRIBUTE_HIDDEN : 0u) | (spec.read_only ? PLINIAN_ATTRIBUTE_READ_ONLY : 0u) |
        (spec.keyable ? 0u : PLINIAN_ATTRIBUTE_NOT_KEYABLE) |
        (spec.storable ? 0u : PLINIAN_ATTRIBUTE_NOT_STORABLE) |
        (spec.connectable ? 0u : PLINIAN_ATTRIBUTE_NOT_CONNECTABLE);
    result.children = store.back().data();
    result.child_count = store.back().size();
    return result;
  }

  inline std::vector<PlinianArgument> plain(const std::vector<Argument>& arguments) {
    std::vector<PlinianArgument> result;
    for (const Argument& a : arguments)
      result.push_back(
          {sizeof(PlinianArgument), a.name.c_str(), a.kind.c_str(), a.help.c_str(), a.optional, a.many});
    return result;
  }

  }  // namespace detail

  inline void Plugin::add(NodeType added) {
    NodeType& type = detail::registered().types.emplace_back(std::move(added));
    std::deque<std::vector<PlinianAttribute>> store;
    std::vector<PlinianAttribute> attributes;
    for (const AttributeSpec& spec : type.attributes) attributes.push_back(detail::plain(spec, store));
    PlinianNodeType plain{};
    plain.size = sizeof(PlinianNodeType);
    plain.name = type.name.c_str();
    plain.help = type.help.c_str();
    plain.version = type.version;
    plain.flags = (type.concurrent ? 0u : PLINIAN_NODE_NOT_CONCURRENT) |
                  (type.hierarchical ? PLINIAN_NODE_HIERARCHICAL : 0u) |
                  (type.holds_children ? PLINIAN_NODE_HOLDS_CHILDREN : 0u) |
                  (type.follows ? PLINIAN_NODE_FOLLOWS : 0u);
    plain.attributes = attributes.data();
    plain.attribute_count = attributes.size();
    plain.aliases = detail::text_or_null(type.aliases);
    plain.user = &type;
    if (type.compute)
      plain.compute = [](void* user, const PlinianCompute* table, PlinianContext* context,
                         std::int32_t output) {
        detail::guarded(
            [&] {
              Context wrapped(*table, context);
              static_cast<NodeType*>(user)->compute(wrapped, Attribute{output});
            },
            [&](const char* message) { table->fail(context, message); });
      };
    if (type.migrate)
      plain.migrate = [](void* user, std::int32_t from, const PlinianMigrate* table,
                         PlinianMigration* migration) {
        detail::guarded(
            [&] {
              Migration wrapped(*table, migration);
              static_cast<NodeType*>(user)->migrate(from, wrapped);
            },
            [](const char*) {});
      };
    if (!host_.register_node_type(host_.self, &plain))
      throw Error("the host refuses the node type " + type.name);
  }

  inline void Plugin::add(Command added) {
    Command& command = detail::registered().commands.emplace_back(std::move(added));
    const auto parameters = detail::plain(command.parameters), flags = detail::plain(command.flags);
    PlinianCommand plain{};
    plain.size = sizeof(PlinianCommand);
    plain.name = command.name.c_str();
    plain.help = command.help.c_str();
    plain.parameters = parameters.data();
    plain.parameter_count = parameters.size();
    plain.flags = flags.data();
    plain.flag_count = flags.size();
    plain.user = &command;
    plain.run = [](void* user, const PlinianCommandContext* table, PlinianCall* call) {
      detail::guarded(
          [&] {
            Call wrapped(*table, call);
            static_cast<Command*>(user)->run(wrapped);
          },
          [&](const char* message) { table->fail(call, message); });
    };
    if (!host_.register_command(host_.self, &plain))
      throw Error("the host refuses the command " + command.name);
  }

  namespace detail {

  inline int initialise(const PlinianHost* host) {
    int success = 0;
    guarded(
        [&] {
          Plugin plugin(*host);
          sdk::initialise(plugin);
          success = 1;
        },
        [&](const char* message) { host->fail(host->self, message); });
    return success;
  }

  // An ELF note: name, description, type, as the System V ABI lays them out.
  template <std::size_t N>
  struct Note {
    std::uint32_t name_size = 8, text_size = N, type = 1;
    char name[8] = {'P', 'l', 'i', 'n', 'i', 'a', 'n', 0};
    char text[(N + 3) / 4 * 4] = {};
    constexpr explicit Note(const char (&source)[N]) {
      for (std::size_t i = 0; i < N; ++i) text[i] = source[i];
    }
  };

  }  // namespace detail
}  // namespace )
}  // namespace plinian

#define PLINIAN_STRING_(x) #x
#define PLINIAN_STRING(x) PLINIAN_STRING_(x)

/// Describes the plug-in, in a note of the library that is read without loading it. All arguments are string
/// literals; registers: "node:TYPE command:NAME ...".
#define PLINIAN_PLUGIN(plugin_name, plugin_version, plugin_vendor, registers)                            \
  __attribute__((section(".note.plinian"), used,                                                         \
                 aligned(4))) constinit const plinian::sdk::detail::Note plinian_plugin_note{            \
      "name " plugin_name "\nversion " plugin_version "\nvendor " plugin_vendor "\nabi " PLINIAN_STRING( \
          PLINIAN_ABI_MAJOR) "." PLINIAN_STRING(PLINIAN_ABI_MINOR) "\nregisters " registers "\n"};       \
  extern "C" int plinian_initialise(const PlinianHost* host) {                                           \
    return plinian::sdk::detail::initialise(host);                                                       \
  }                                                                                                      \
  extern "C" void plinian_uninitialise(const PlinianHost*) {                                             \
    plinian::sdk::detail::registered() = {};                                                             \
  }                                                                                                      \
  static_assert(true)
