// Reads and writes values.
#include "host/graph/values/value_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

template <class Number>
std::string shortest(Number number) {
  std::array<char, 40> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  return {buffer.data(), end};
}

template <class Number>
bool parse_number(std::string_view word, Number& number) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

struct Unit {
  std::string_view suffix;
  double factor;  // to metres, degrees, frames
};

std::span<const Unit> units_of(AttributeType type) {
  static constexpr Unit distances[] = {{"km", 1000.0}, {"cm", 0.01},   {"mm", 0.001},
                                       {"in", 0.0254}, {"ft", 0.3048}, {"m", 1.0}};
  static constexpr Unit angles[] = {{"deg", 1.0}, {"rad", 57.295779513082320877}};
  static constexpr Unit times[] = {{"f", 1.0}};
  if (type == AttributeType::distance) return distances;
  if (type == AttributeType::angle) return angles;
  if (type == AttributeType::time) return times;
  return {};
}

std::string together(std::span<const Word> words) {
  std::string text;
  for (const Word& word : words) text += (text.empty() ? "" : " ") + word.text;
  return text;
}

[[noreturn]] void refuse(const AttributeSpec& spec, std::span<const Word> words) {
  throw GraphError("expects " + expectation(spec) + ", not " + shown(together(words)));
}

// Components of a vector: words, each of which may hold several with commas between.
std::vector<std::string_view> components(std::span<const Word> words) {
  std::vector<std::string_view> parts;
  for (const Word& word : words) {
    std::string_view rest = word.text;
    while (true) {
      const std::size_t comma = rest.find(',');
      parts.push_back(rest.substr(0, comma));
      if (comma == rest.npos) break;
      rest.remove_prefix(comma + 1);
    }
  }
  return parts;
}

// A single-precision number, read as such: through double it could be rounded twice.
float read_float(std::string_view word) {
  float number = 0.0f;
  if (!parse_number(word, number) || !std::isfinite(number)) throw GraphError("expects a finite number");
  return number;
}

template <class Vector>
Value read_vector(const AttributeSpec& spec, std::span<const Word> words) {
  const auto parts = components(words);
  Vector result(0.0f);
  const bool grey = spec.type == AttributeType::colour && parts.size() == 1;
  if (!grey && int(parts.size()) != result.length()) refuse(spec, words);
  for (int i = 0; i < result.length(); ++i) {
    try {
      result[i] = read_float(parts[grey ? 0 : std::size_t(i)]);
    } catch (const GraphError&) {
      refuse(spec, words);
    }
  }
  return result;
}

template <class Vector>
std::string write_vector(const Vector& vector, const char* separator) {
  std::string text;
  for (int i = 0; i < vector.length(); ++i) {
    if (i) text += separator;
    text += shortest(vector[i]);
  }
  return text;
}

constexpr std::array<const char*, 3> interpolation_words = {"stepped", "linear", "smooth"};

// Without a word, or of an empty text, no points.
Value read_ramp(const AttributeSpec& spec, std::span<const Word> words) {
  std::vector<Word> unquoted;
  for (const Word& word : words)
    for (Word& one : split_words(word.text)) unquoted.push_back(std::move(one));
  Ramp ramp;
  for (const Word& word : unquoted) {
    const std::size_t first = word.text.find(':'), last = word.text.rfind(':');
    if (first == word.text.npos || first == last) refuse(spec, words);
    RampPoint point;
    const std::vector<Word> value = {{word.text.substr(first + 1, last - first - 1), false}};
    const std::string kind = word.text.substr(last + 1);
    const AttributeSpec colour = {.name = spec.name, .type = AttributeType::colour};
    std::size_t interpolation = 0;
    while (interpolation < 3 && kind != interpolation_words[interpolation]) ++interpolation;
    try {
      point.position = read_float(std::string_view(word.text).substr(0, first));
      point.value = std::get<vec3>(read_vector<vec3>(colour, value));
    } catch (const GraphError&) {
      refuse(spec, words);
    }
    if (interpolation == 3 || (!ramp.points.empty() && point.position <= ramp.points.back().position))
      refuse(spec, words);
    point.interpolation = Interpolation(interpolation);
    ramp.points.push_back(point);
  }
  return Boxed<Ramp>(std::move(ramp));
}

std::string write_ramp(const Ramp& ramp) {
  std::string text;
  for (const RampPoint& point : ramp.points) {
    const bool grey = point.value.x == point.value.y && point.value.x == point.value.z;
    if (!text.empty()) text += ' ';
    text += shortest(point.position);
    text += ':';
    text += grey ? shortest(point.value.x) : write_vector(point.value, ",");
    text += ':';
    text += interpolation_words[std::size_t(point.interpolation)];
  }
  return text;
}

Value read_choice(const AttributeSpec& spec, std::span<const Word> words) {
  std::vector<std::string> known;
  for (const Choice& choice : spec.choices) {
    if (words[0].text == choice.word) return choice.value;
    known.push_back(choice.word);
  }
  int number = 0;
  if (parse_number(words[0].text, number))
    for (const Choice& choice : spec.choices)
      if (number == choice.value) return number;
  throw GraphError(shown(words[0].text) + " is none of " + choices_text(spec) +
                   did_you_mean(words[0].text, known));
}

Value read_one_number(const AttributeSpec& spec, std::span<const Word> words) {
  if (words.size() != 1) refuse(spec, words);
  std::string_view word = words[0].text;
  if (spec.type == AttributeType::boolean) {
    for (const std::string_view yes : {"true", "on", "yes", "1"})
      if (word == yes) return true;
    for (const std::string_view no : {"false", "off", "no", "0"})
      if (word == no) return false;
    refuse(spec, words);
  }
  if (spec.type == AttributeType::choice) return read_choice(spec, words);
  if (spec.type == AttributeType::integer) {
    int number = 0;
    if (!parse_number(word, number)) refuse(spec, words);
    return number;
  }
  double factor = 1.0;
  for (const Unit& unit : units_of(spec.type))
    if (word.ends_with(unit.suffix)) {
      word.remove_suffix(unit.suffix.size());
      factor = unit.factor;
      break;
    }
  try {
    if (spec.type == AttributeType::float1) return read_float(word);
    const double number = read_number(word) * factor;
    if (std::isfinite(number)) return number;
  } catch (const GraphError&) {
  }
  refuse(spec, words);
}

Value read_matrix(const AttributeSpec& spec, std::span<const Word> words) {
  const auto parts = components(words);
  if (parts.size() != 16) refuse(spec, words);
  dmat4 matrix;
  for (int i = 0; i < 16; ++i) {
    try {
      matrix[i / 4][i % 4] = read_number(parts[std::size_t(i)]);
    } catch (const GraphError&) {
      refuse(spec, words);
    }
  }
  return Boxed<dmat4>(matrix);
}

Value read_node(const AttributeSpec& spec, std::span<const Word> words, const NodeNames& names) {
  if (words.size() != 1) refuse(spec, words);
  if (words[0].text == "none") return NodeId();
  const NodeId id = names.id_of ? names.id_of(words[0].text) : NodeId();
  if (!id) throw GraphError("expects a node or none, and there is no node " + shown(words[0].text));
  return id;
}

}  // namespace

std::string write_number(float number) {
  return shortest(number);
}
std::string write_number(double number) {
  return shortest(number);
}

double read_number(std::string_view word) {
  double number = 0.0;
  if (!parse_number(word, number) || !std::isfinite(number))
    throw GraphError("expects a number, not " + shown(word));
  return number;
}

std::string write_value(const AttributeSpec& spec, const Value& value, const NodeNames& names) {
  return std::visit(
      [&](const auto& held) -> std::string {
        using T = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<T, bool>) return held ? "true" : "false";
        if constexpr (std::is_same_v<T, int>) {
          if (spec.type == AttributeType::choice)
            for (const Choice& choice : spec.choices)
              if (choice.value == held) return choice.word;
          return std::to_string(held);
        }
        if constexpr (std::is_same_v<T, float> || std::is_same_v<T, double>) return shortest(held);
        if constexpr (std::is_same_v<T, std::string>) return quote(held);
        if constexpr (std::is_same_v<T, vec2> || std::is_same_v<T, vec3> || std::is_same_v<T, vec4>)
          return write_vector(held, " ");
        if constexpr (std::is_same_v<T, Boxed<dmat4>>) {
          std::string text;
          for (int column = 0; column < 4; ++column) {
            if (column) text += ' ';
            text += write_vector((*held)[column], " ");
          }
          return text;
        }
        if constexpr (std::is_same_v<T, NodeId>) {
          const std::string name = held && names.name_of ? names.name_of(held) : "";
          return name.empty() ? "none" : name;
        }
        if constexpr (std::is_same_v<T, Boxed<Ramp>>) return write_ramp(*held);
        if constexpr (std::is_same_v<T, DataPtr>) return write_data(spec.data_slot, held);
        return "";
      },
      value);
}

Value read_value(const AttributeSpec& spec, std::span<const Word> words, const NodeNames& names) {
  if (is_number(spec.type)) return read_one_number(spec, words);
  switch (spec.type) {
    case AttributeType::string:
    case AttributeType::path:
      if (words.size() > 1) throw GraphError("expects one text: put it in quotes, " + quote(together(words)));
      if (words.empty()) refuse(spec, words);
      return words[0].text;
    case AttributeType::float2:
      return read_vector<vec2>(spec, words);
    case AttributeType::float3:
    case AttributeType::colour:
      return read_vector<vec3>(spec, words);
    case AttributeType::float4:
      return read_vector<vec4>(spec, words);
    case AttributeType::matrix:
      return read_matrix(spec, words);
    case AttributeType::node:
      return read_node(spec, words, names);
    case AttributeType::ramp:
      return read_ramp(spec, words);
    case AttributeType::compound:
      throw GraphError("is a compound: set its children");
    default:
      if (words.size() != 1) refuse(spec, words);
      return read_data(spec.data_slot, spec.data_type, words[0]);
  }
}

namespace {

// The end of an open range is the float next to it: 0 for 1e-45. Empty for a closed one.
std::string open_end(double end, float outside) {
  const float next = float(end);
  if (double(next) != end) return "";
  const std::string beyond = shortest(std::nextafter(next, outside));
  return beyond.size() + 3 <= shortest(next).size() ? beyond : "";
}

std::string range_text(const AttributeSpec& spec) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const std::string above = spec.minimum ? open_end(*spec.minimum, -infinity) : "",
                    below = spec.maximum ? open_end(*spec.maximum, infinity) : "";
  if (spec.minimum && spec.maximum && above.empty() && below.empty())
    return " from " + shortest(*spec.minimum) + " to " + shortest(*spec.maximum);
  std::string text;
  if (spec.minimum) text = above.empty() ? " >= " + shortest(*spec.minimum) : " above " + above;
  if (!spec.maximum) return text;
  text += text.empty() ? "" : " and";
  return text + (below.empty() ? " <= " + shortest(*spec.maximum) : " below " + below);
}

std::string units_text(AttributeType type) {
  std::vector<std::string> suffixes;
  for (const Unit& unit : units_of(type)) suffixes.emplace_back(unit.suffix);
  return suffixes.empty() ? "" : ", or one with a unit (" + join(suffixes) + ")";
}

}  // namespace

std::string expectation(const AttributeSpec& spec) {
  const std::string range = range_text(spec);
  const int count = component_count(spec.type);
  if (count > 0)
    return (spec.type == AttributeType::colour ? "a number or " : "") + std::to_string(count) + " numbers" +
           range;
  switch (spec.type) {
    case AttributeType::boolean:
      return "true or false";
    case AttributeType::integer:
      return "an integer" + range;
    case AttributeType::choice:
      return "one of " + choices_text(spec);
    case AttributeType::string:
      return "a text";
    case AttributeType::path:
      return "a file path";
    case AttributeType::matrix:
      return "16 numbers, column by column";
    case AttributeType::node:
      return "a node or none";
    case AttributeType::ramp:
      return "points POSITION:VALUE:INTERPOLATION (stepped, linear or smooth) in ascending order, or \"\" "
             "for "
             "none";
    case AttributeType::compound:
      return "values for its children";
    case AttributeType::data:
      return "data of type " + spec.data_type;
    default:
      return "a number" + range + units_text(spec.type);
  }
}

}  // namespace plinian::graph
