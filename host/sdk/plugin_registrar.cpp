// Translates between plain C and the graph. No exception leaves a function that a plug-in calls.
#include "host/sdk/plugin_registrar.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <forward_list>
#include <sstream>

#include "host/graph/commands/session.h"
#include "host/graph/evaluation/compute_context.h"
#include "host/graph/files/attribute_declaration.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"
#include "host/graph/values/value_text.h"

namespace plinian::sdk {

using graph::AttributeSpec;
using graph::DataPtr;
using graph::GraphError;
using graph::Value;

namespace {

std::atomic<std::size_t> live_data{0};

// A structure of a plug-in that may have been built with an older, shorter one: what it lacks is zero.
template <class T>
T whole(const T* from) {
  T result{};
  if (from) std::memcpy(&result, from, std::min(sizeof(T), from->size));
  return result;
}

std::string text_of(const char* text) {
  return text ? text : "";
}

std::vector<std::string> words_of(const char* text) {
  std::istringstream words(text_of(text));
  std::vector<std::string> result;
  for (std::string word; words >> word;) result.push_back(word);
  return result;
}

AttributeSpec attribute_from(const PlinianAttribute* plain) {
  const PlinianAttribute from = whole(plain);
  const auto number = [](const double* value) { return value ? std::optional(*value) : std::nullopt; };
  AttributeSpec spec;
  spec.name = text_of(from.name);
  spec.type = graph::type_of_name(text_of(from.type));
  spec.nice_name = text_of(from.nice_name);
  spec.help = text_of(from.help);
  spec.unit = text_of(from.unit);
  spec.layout.group = text_of(from.group);
  if (from.choices) spec.choices = graph::read_choices(from.choices);
  spec.data_type = text_of(from.data_type);
  spec.affects = words_of(from.affects);
  spec.minimum = number(from.minimum);
  spec.maximum = number(from.maximum);
  spec.soft_minimum = number(from.soft_minimum);
  spec.soft_maximum = number(from.soft_maximum);
  spec.array = from.flags & PLINIAN_ATTRIBUTE_ARRAY;
  spec.output = from.flags & PLINIAN_ATTRIBUTE_OUTPUT;
  spec.hidden = from.flags & PLINIAN_ATTRIBUTE_HIDDEN;
  spec.read_only = from.flags & PLINIAN_ATTRIBUTE_READ_ONLY;
  spec.keyable = !(from.flags & PLINIAN_ATTRIBUTE_NOT_KEYABLE);
  spec.storable = !(from.flags & PLINIAN_ATTRIBUTE_NOT_STORABLE);
  spec.connectable = !(from.flags & PLINIAN_ATTRIBUTE_NOT_CONNECTABLE);
  if (from.default_value) {
    const bool text = spec.type == graph::AttributeType::string || spec.type == graph::AttributeType::path;
    const std::vector<graph::Word> words =
        text ? std::vector<graph::Word>{{from.default_value, true}} : graph::split_words(from.default_value);
    try {
      spec.default_value = graph::read_value(spec, words);
    } catch (const GraphError& error) {
      throw GraphError("attribute '" + spec.name + "': its default " + error.what());
    }
  }
  const auto* child = reinterpret_cast<const char*>(from.children);
  for (std::size_t i = 0; i < from.child_count; ++i) {
    const auto* next = reinterpret_cast<const PlinianAttribute*>(child);
    spec.children.push_back(attribute_from(next));
    child += next->size;
  }
  return spec;
}

// ---- compute

struct ComputeState {
  graph::ComputeContext& context;
  std::string error, failure;
  std::forward_list<Value> held;  // texts and data whose addresses were handed out
  std::vector<std::int32_t> elements;
};

ComputeState& state_of(PlinianContext* context) {
  return *reinterpret_cast<ComputeState*>(context);
}

template <class Action>
int guarded(PlinianContext* context, const Action& action) {
  ComputeState& state = state_of(context);
  try {
    action(state);
    return 1;
  } catch (const std::bad_variant_access&) {
    state.error = "an attribute was read as what it is not";
  } catch (const std::exception& error) {
    state.error = error.what();
  }
  return 0;
}

const Value& input_of(ComputeState& state, std::int32_t attribute, std::int32_t element, const double* time) {
  if (!time) return state.context.input(attribute, element);
  state.held.push_front(state.context.input_at(*time, attribute, element));
  return state.held.front();
}

int read_number(PlinianContext* c, std::int32_t attribute, std::int32_t element, const double* time,
                double* value) {
  return guarded(c,
                 [&](ComputeState& s) { *value = graph::number_of(input_of(s, attribute, element, time)); });
}

int read_vector(PlinianContext* c, std::int32_t attribute, std::int32_t element, const double* time,
                float* value) {
  return guarded(c, [&](ComputeState& s) {
    const Value& input = input_of(s, attribute, element, time);
    const int count = std::holds_alternative<vec2>(input) ? 2 : std::holds_alternative<vec4>(input) ? 4 : 3;
    for (int i = 0; i < 4; ++i)
      value[i] = i < count ? float(graph::number_of(graph::component_of(input, i))) : 0.0f;
  });
}

int read_matrix(PlinianContext* c, std::int32_t attribute, std::int32_t element, const double* time,
                double* value) {
  return guarded(c, [&](ComputeState& s) {
    const dmat4& matrix = *std::get<graph::Boxed<dmat4>>(input_of(s, attribute, element, time));
    for (int i = 0; i < 16; ++i) value[i] = matrix[i / 4][i % 4];
  });
}

int read_text(PlinianContext* c, std::int32_t attribute, std::int32_t element, const double* time,
              const char** value) {
  return guarded(c, [&](ComputeState& s) {
    s.held.push_front(std::get<std::string>(input_of(s, attribute, element, time)));
    *value = std::get<std::string>(s.held.front()).c_str();
  });
}

int read_data(PlinianContext* c, std::int32_t attribute, std::int32_t element, const double* time,
              const void** object) {
  return guarded(c, [&](ComputeState& s) {
    const Value& input = input_of(s, attribute, element, time);
    *object = nullptr;
    if (std::holds_alternative<std::monostate>(input)) return;
    s.held.push_front(input);
    if (const DataPtr& data = std::get<DataPtr>(input)) *object = data->object.get();
  });
}

std::size_t elements(PlinianContext* c, std::int32_t array, const std::int32_t** found) {
  guarded(c, [&](ComputeState& s) { s.elements = s.context.elements(array); });
  *found = state_of(c).elements.data();
  return state_of(c).elements.size();
}

int write_number(PlinianContext* c, std::int32_t attribute, double value) {
  return guarded(c, [&](ComputeState& s) { s.context.set_output(attribute, value); });
}

int write_vector(PlinianContext* c, std::int32_t attribute, const float* value, std::int32_t count) {
  return guarded(c, [&](ComputeState& s) {
    if (count == 2)
      s.context.set_output(attribute, vec2(value[0], value[1]));
    else if (count == 3)
      s.context.set_output(attribute, vec3(value[0], value[1], value[2]));
    else if (count == 4)
      s.context.set_output(attribute, vec4(value[0], value[1], value[2], value[3]));
    else
      throw GraphError("a vector has 2 to 4 numbers");
  });
}

int write_matrix(PlinianContext* c, std::int32_t attribute, const double* value) {
  return guarded(c, [&](ComputeState& s) {
    dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = value[i];
    s.context.set_output(attribute, graph::Boxed<dmat4>(matrix));
  });
}

int write_text(PlinianContext* c, std::int32_t attribute, const char* value) {
  return guarded(c, [&](ComputeState& s) { s.context.set_output(attribute, text_of(value)); });
}

int write_data(PlinianContext* c, std::int32_t attribute, const PlinianData* plain) {
  const PlinianData from = whole(plain);
  ++live_data;
  const auto release = [free = from.release](const void* object) {
    if (free) free(object);
    --live_data;
  };
  const std::shared_ptr<const void> object(from.object, release);
  return guarded(c, [&](ComputeState& s) {
    s.context.set_output(attribute, std::make_shared<const graph::Data>(
                                        graph::Data{text_of(from.type), object, from.bytes, from.content}));
  });
}

int cancelled(PlinianContext* c) {
  return state_of(c).context.cancelled();
}

void progress(PlinianContext* c, double fraction, const char* what) {
  guarded(c, [&](ComputeState& s) { s.context.progress(fraction, text_of(what)); });
}

void fail(PlinianContext* c, const char* message) {
  state_of(c).failure = text_of(message);
}

const char* last_error(PlinianContext* c) {
  return state_of(c).error.c_str();
}

const PlinianCompute compute_table = {sizeof(PlinianCompute),
                                      read_number,
                                      read_vector,
                                      read_matrix,
                                      read_text,
                                      read_data,
                                      elements,
                                      write_number,
                                      write_vector,
                                      write_matrix,
                                      write_text,
                                      write_data,
                                      cancelled,
                                      progress,
                                      fail,
                                      last_error};

// ---- migration

struct MigrationState {
  graph::StoredAttributes& attributes;
  std::string text;
  graph::StoredAttribute* find(const char* path) {
    for (graph::StoredAttribute& attribute : attributes)
      if (attribute.path == text_of(path)) return &attribute;
    return nullptr;
  }
};

MigrationState& state_of(PlinianMigration* migration) {
  return *reinterpret_cast<MigrationState*>(migration);
}

const PlinianMigrate migrate_table = {
    sizeof(PlinianMigrate),
    [](PlinianMigration* m, const char* path) -> const char* {
      const graph::StoredAttribute* found = state_of(m).find(path);
      if (!found) return nullptr;
      state_of(m).text = found->text;
      return state_of(m).text.c_str();
    },
    [](PlinianMigration* m, const char* path, const char* text) {
      if (graph::StoredAttribute* found = state_of(m).find(path))
        found->text = text_of(text);
      else
        state_of(m).attributes.push_back({text_of(path), text_of(text)});
    },
    [](PlinianMigration* m, const char* path) {
      std::erase_if(state_of(m).attributes,
                    [&](const graph::StoredAttribute& attribute) { return attribute.path == text_of(path); });
    }};

graph::NodeTypeSpec node_type_from(const PlinianNodeType* plain) {
  const PlinianNodeType from = whole(plain);
  graph::NodeTypeSpec spec;
  spec.name = text_of(from.name);
  spec.help = text_of(from.help);
  spec.version = from.version;
  spec.concurrent = !(from.flags & PLINIAN_NODE_NOT_CONCURRENT);
  spec.hierarchical = from.flags & PLINIAN_NODE_HIERARCHICAL;
  spec.holds_children = from.flags & PLINIAN_NODE_HOLDS_CHILDREN;
  spec.follows = from.flags & PLINIAN_NODE_FOLLOWS;
  const auto* attribute = reinterpret_cast<const char*>(from.attributes);
  for (std::size_t i = 0; i < from.attribute_count; ++i) {
    const auto* next = reinterpret_cast<const PlinianAttribute*>(attribute);
    spec.attributes.push_back(attribute_from(next));
    attribute += next->size;
  }
  for (const std::string& alias : words_of(from.aliases)) {
    const std::size_t equals = alias.find('=');
    if (equals == alias.npos) throw GraphError("node type '" + spec.name + "': an alias is written old=new");
    spec.aliases.push_back({alias.substr(0, equals), alias.substr(equals + 1)});
  }
  if (from.compute)
    spec.compute = [compute = from.compute, user = from.user](graph::ComputeContext& context,
                                                              graph::AttributeIndex output) {
      ComputeState state{context, "", "", {}, {}};
      compute(user, &compute_table, reinterpret_cast<PlinianContext*>(&state), output);
      if (!state.failure.empty()) throw GraphError(state.failure);
    };
  if (from.migrate)
    for (int version = 1; version < spec.version; ++version)
      spec.migrators.push_back(
          {version, [migrate = from.migrate, user = from.user, version](graph::StoredAttributes& attributes) {
             MigrationState state{attributes, ""};
             migrate(user, version, &migrate_table, reinterpret_cast<PlinianMigration*>(&state));
           }});
  return spec;
}

// ---- commands

struct CallState {
  graph::Session& session;
  const graph::Arguments& arguments;
  graph::CommandResult result;
  std::string error, failure, answers;
};

CallState& state_of(PlinianCall* call) {
  return *reinterpret_cast<CallState*>(call);
}

const PlinianCommandContext command_table = {
    sizeof(PlinianCommandContext),
    [](PlinianCall* c, const char* name) { return state_of(c).arguments.words(text_of(name)).size(); },
    [](PlinianCall* c, const char* name) { return int(state_of(c).arguments.has(text_of(name))); },
    [](PlinianCall* c, const char* name, std::size_t index) -> const char* {
      const auto& words = state_of(c).arguments.words(text_of(name));
      return index < words.size() ? words[index].text.c_str() : "";
    },
    [](PlinianCall* c, const char* line, const char** answers) {
      CallState& state = state_of(c);
      try {
        state.answers.clear();
        for (const std::string& answer : state.session.execute(text_of(line)))
          state.answers += (state.answers.empty() ? "" : "\n") + answer;
        if (answers) *answers = state.answers.c_str();
        return 1;
      } catch (const std::exception& error) {
        state.error = error.what();
        return 0;
      }
    },
    [](PlinianCall* c, const char* line) { state_of(c).result.push_back(text_of(line)); },
    [](PlinianCall* c, const char* message) { state_of(c).failure = text_of(message); },
    [](PlinianCall* c) { return state_of(c).error.c_str(); }};

graph::ArgumentKind kind_from(const std::string& kind) {
  using enum graph::ArgumentKind;
  if (kind == "number") return number;
  if (kind == "integer") return integer;
  if (kind == "node") return node;
  if (kind == "plug") return plug;
  if (kind == "path") return path;
  if (kind == "text") return text;
  throw GraphError("unknown kind of argument " + graph::shown(kind));
}

std::vector<PlinianArgument> arguments_from(const PlinianArgument* first, std::size_t count) {
  std::vector<PlinianArgument> result;
  const auto* next = reinterpret_cast<const char*>(first);
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(whole(reinterpret_cast<const PlinianArgument*>(next)));
    next += result.back().size;
  }
  return result;
}

graph::CommandSpec command_from(const PlinianCommand* plain) {
  const PlinianCommand from = whole(plain);
  graph::CommandSpec spec;
  spec.name = text_of(from.name);
  spec.help = text_of(from.help);
  if (!graph::is_identifier(spec.name)) throw GraphError(graph::shown(spec.name) + " cannot name a command");
  if (!from.run) throw GraphError("the command '" + spec.name + "' does nothing");
  for (const PlinianArgument& a : arguments_from(from.parameters, from.parameter_count))
    spec.parameters.push_back(
        {text_of(a.name), kind_from(text_of(a.kind)), text_of(a.help), a.optional != 0, a.many != 0});
  for (const PlinianArgument& a : arguments_from(from.flags, from.flag_count)) {
    const std::string kind = text_of(a.kind);
    spec.flags.push_back(
        {text_of(a.name), text_of(a.help), kind.empty() ? std::nullopt : std::optional(kind_from(kind))});
  }
  spec.run = [run = from.run, user = from.user](graph::Session& session, const graph::Arguments& arguments) {
    CallState state{session, arguments, {}, "", "", ""};
    run(user, &command_table, reinterpret_cast<PlinianCall*>(&state));
    if (!state.failure.empty()) throw GraphError(state.failure);
    return std::move(state.result);
  };
  return spec;
}

template <class Action>
int registered(void* self, const Action& action) {
  auto& registrar = *static_cast<PluginRegistrar*>(self);
  try {
    action(registrar);
    return 1;
  } catch (const std::exception& error) {
    if (registrar.error.empty()) registrar.error = error.what();
    return 0;
  }
}

}  // namespace

PluginRegistrar::PluginRegistrar() {
  host_.size = sizeof(PlinianHost);
  host_.abi_major = PLINIAN_ABI_MAJOR;
  host_.abi_minor = PLINIAN_ABI_MINOR;
  host_.self = this;
  host_.register_node_type = [](void* self, const PlinianNodeType* type) {
    return registered(self, [&](PluginRegistrar& r) { r.node_types.push_back(node_type_from(type)); });
  };
  host_.register_command = [](void* self, const PlinianCommand* command) {
    return registered(self, [&](PluginRegistrar& r) { r.commands.push_back(command_from(command)); });
  };
  host_.fail = [](void* self, const char* message) {
    auto& registrar = *static_cast<PluginRegistrar*>(self);
    if (registrar.error.empty()) registrar.error = text_of(message);
  };
}

std::size_t live_plugin_data() {
  return live_data;
}

}  // namespace plinian::sdk
