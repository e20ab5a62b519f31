// Flattens declarations and checks that they make sense.
#include "host/graph/types/schema.h"

#include <algorithm>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

// What a declaration may get wrong by itself.
void check(const AttributeSpec& spec, const std::string& path) {
  const auto wrong = [&](const std::string& why) { throw GraphError("attribute '" + path + "': " + why); };
  if (!is_identifier(spec.name)) wrong("a name is a letter or _, then letters, digits and _");
  if ((spec.type == AttributeType::compound) == spec.children.empty())
    wrong(spec.children.empty() ? "a compound needs children" : "only a compound has children");
  if (spec.type == AttributeType::choice && spec.choices.empty()) wrong("an enum needs choices");
  if (spec.type == AttributeType::data && spec.data_type.empty()) wrong("data need a data type");
  if (spec.minimum && spec.maximum && *spec.minimum > *spec.maximum)
    wrong("its minimum is above its maximum");
  if (spec.output && spec.array) wrong("an output cannot be an array");
  if (spec.output && !spec.affects.empty()) wrong("an output affects nothing in its own node");
  for (std::size_t i = 0; i < spec.choices.size(); ++i) {
    if (spec.choices[i].word.empty()) wrong("a choice has no word");
    for (std::size_t k = 0; k < i; ++k)
      if (spec.choices[i].value == spec.choices[k].value || spec.choices[i].word == spec.choices[k].word)
        wrong("the choice '" + spec.choices[i].word + "' is there twice");
  }
}

// A default is what the attribute would hold if it were set to it.
Value checked_default(const AttributeSpec& spec, const std::string& path) {
  if (spec.type == AttributeType::compound || spec.type == AttributeType::data) return std::monostate();
  Value value = spec.default_value;
  if (std::holds_alternative<std::monostate>(value)) {
    value = zero_value(spec.type);
    if (spec.type == AttributeType::choice) value = spec.choices.front().value;
    if (!is_number(spec.type) && component_count(spec.type) == 0) return value;
    return fitted(spec, value);
  }
  bool clamped = false;
  try {
    value = fitted(spec, value, &clamped);
  } catch (const GraphError& error) {
    throw GraphError("attribute '" + path + "': its default " + error.what());
  }
  if (clamped) throw GraphError("attribute '" + path + "': its default is out of its range");
  return value;
}

}  // namespace

Schema::Schema(const std::vector<AttributeSpec>& specs) {
  for (const AttributeSpec& spec : specs) add(spec, no_attribute, false);
  connect_affects();
}

AttributeIndex Schema::add(const AttributeSpec& spec, AttributeIndex parent, bool dynamic) {
  SchemaAttribute attribute;
  attribute.path = parent == no_attribute ? spec.name : (*this)[parent].path + "." + spec.name;
  check(spec, attribute.path);
  if (by_path_.contains(attribute.path))
    throw GraphError("attribute '" + attribute.path + "' is there twice");
  const AttributeIndex index = size();
  attribute.spec = spec;
  attribute.spec.children.clear();
  attribute.parent = parent;
  attribute.dynamic = dynamic;
  attribute.array = spec.array ? index : no_attribute;
  if (parent != no_attribute) {
    const SchemaAttribute& compound = (*this)[parent];
    if (spec.array && compound.array != no_attribute)
      throw GraphError("attribute '" + attribute.path + "': an array cannot hold arrays");
    if (!spec.array) attribute.array = compound.array;
    // What is true of a compound is true of all that it holds.
    attribute.spec.output |= compound.spec.output;
    attribute.spec.storable &= compound.spec.storable;
    attribute.spec.keyable &= compound.spec.keyable;
    attribute.spec.connectable &= compound.spec.connectable;
    attribute.spec.hidden |= compound.spec.hidden;
    attribute.spec.read_only |= compound.spec.read_only;
    attribute.spec.affects.insert(attribute.spec.affects.end(), compound.spec.affects.begin(),
                                  compound.spec.affects.end());
  }
  if (attribute.spec.output) {
    attribute.spec.read_only = true;
    attribute.spec.storable = attribute.spec.keyable = false;
  }
  attribute.spec.default_value = checked_default(attribute.spec, attribute.path);
  if (spec.type != AttributeType::compound && attribute.spec.output) outputs_.push_back(index);
  by_path_.emplace(attribute.path, index);
  attributes_.push_back(std::move(attribute));
  if (parent == no_attribute)
    top_.push_back(index);
  else
    attributes_[std::size_t(parent)].children.push_back(index);
  for (const AttributeSpec& child : spec.children) add(child, index, dynamic);
  return index;
}

void Schema::connect_affects() {
  for (AttributeIndex index = 0; index < size(); ++index) {
    SchemaAttribute& attribute = attributes_[std::size_t(index)];
    if (attribute.spec.type == AttributeType::compound) continue;
    for (const std::string& name : attribute.spec.affects) {
      const AttributeIndex target = find(name);
      if (target == no_attribute || !(*this)[target].spec.output)
        throw GraphError("attribute '" + attribute.path + "' affects '" + name + "', which is no output" +
                         did_you_mean(name, paths()));
      for (const AttributeIndex output : leaves(target)) {
        auto& affects = attribute.affects;
        if (std::find(affects.begin(), affects.end(), output) != affects.end()) continue;
        affects.push_back(output);
        attributes_[std::size_t(output)].affected_by.push_back(index);
      }
    }
  }
}

Schema Schema::with_dynamic(const AttributeSpec& spec) const {
  if (spec.output || !spec.affects.empty())
    throw GraphError("attribute '" + spec.name +
                     "': an added attribute neither is computed nor affects anything");
  Schema result = *this;
  result.add(spec, no_attribute, true);
  return result;
}

Schema Schema::without_last_dynamic() const {
  Schema result = *this;
  const AttributeIndex last = result.top_.back();
  for (AttributeIndex index = last; index < size(); ++index) result.by_path_.erase((*this)[index].path);
  result.attributes_.resize(std::size_t(last));
  result.top_.pop_back();
  return result;
}

AttributeSpec Schema::declaration(AttributeIndex index) const {
  AttributeSpec spec = (*this)[index].spec;
  for (const AttributeIndex child : (*this)[index].children) spec.children.push_back(declaration(child));
  return spec;
}

AttributeIndex Schema::find(std::string_view path) const {
  const auto found = by_path_.find(path);
  return found == by_path_.end() ? no_attribute : found->second;
}

std::vector<std::string> Schema::paths() const {
  std::vector<std::string> result;
  for (const SchemaAttribute& attribute : attributes_) result.push_back(attribute.path);
  return result;
}

std::vector<AttributeIndex> Schema::leaves(AttributeIndex index) const {
  if ((*this)[index].children.empty()) return {index};
  std::vector<AttributeIndex> result;
  for (const AttributeIndex child : (*this)[index].children)
    for (const AttributeIndex leaf : leaves(child)) result.push_back(leaf);
  return result;
}

}  // namespace plinian::graph
