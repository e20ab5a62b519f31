// Parameters from JSON and from text.
#include "core/scene/parameter_json.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace plinian {

using nlohmann::json;

namespace {

[[noreturn]] void mismatch(const ParameterSpec& spec, const json& value, const std::string& where) {
  throw std::runtime_error(
      fmt::format("{}: expected {}, got {}", where, expectation(spec), short_text(value)));
}

// The words true, on, yes and false, off, no, as people type them after --set.
std::optional<bool> boolean_of(const json& value) {
  if (value.is_boolean()) return value.get<bool>();
  return std::nullopt;
}

double number_of(const ParameterSpec& spec, const json& value, const json& whole, const std::string& where) {
  if (!value.is_number()) mismatch(spec, whole, where);
  const double number = value.get<double>();
  if (!spec.range.contains(number)) mismatch(spec, whole, where);
  return number;
}

// Line and column (from 1) of a byte offset.
std::pair<int, int> position(const std::string& text, std::size_t offset) {
  int line = 1, column = 1;
  for (std::size_t i = 0; i + 1 < offset && i < text.size(); ++i) {
    if (text[i] == '\n') {
      ++line;
      column = 1;
    } else {
      ++column;
    }
  }
  return {line, column};
}

}  // namespace

std::string short_text(const json& value) {
  // Replacing what is not UTF-8 keeps dump() from throwing in the middle of an error message.
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

json read_json_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": no such file, or it cannot be read");
  std::ostringstream stream;
  stream << file.rdbuf();
  const std::string text = stream.str();
  if (text.empty()) throw std::runtime_error(path + ": the file is empty (or a folder)");

  // nlohmann-json keeps the last of two equal keys without a word; a person who wrote both wants to know.
  std::vector<std::set<std::string>> open_objects;
  std::string twice;
  const auto watch = [&](int, json::parse_event_t event, json& parsed) {
    if (event == json::parse_event_t::object_start) open_objects.emplace_back();
    if (event == json::parse_event_t::object_end) open_objects.pop_back();
    if (event == json::parse_event_t::key) {
      const std::string key = parsed.get<std::string>();
      if (!key.starts_with('_') && !open_objects.back().insert(key).second) twice = key;
    }
    return true;
  };
  try {
    json result = json::parse(text, watch);
    if (!twice.empty())
      throw std::runtime_error(fmt::format("{}: {}: the key stands there twice", path, twice));
    return result;
  } catch (const json::parse_error& error) {
    const auto [line, column] = position(text, error.byte);
    // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while ...": keep the
    // end.
    std::string reason = error.what();
    if (const auto at = reason.find("syntax error"); at != std::string::npos) reason = reason.substr(at);
    throw std::runtime_error(fmt::format("{}:{}:{}: not JSON: {}", path, line, column, reason));
  } catch (const json::exception& error) {
    throw std::runtime_error(fmt::format("{}: not JSON: {}", path, error.what()));
  }
}

ParameterValue read_parameter(const ParameterSpec& spec, const json& value, const std::string& where) {
  switch (spec.type) {
    case ParameterType::boolean:
      if (const auto boolean = boolean_of(value)) return *boolean;
      mismatch(spec, value, where);
    case ParameterType::integer: {
      const double number = number_of(spec, value, value, where);
      if (number != std::floor(number) || std::abs(number) > 2147483647.0) mismatch(spec, value, where);
      return int(number);
    }
    case ParameterType::real:
      return number_of(spec, value, value, where);
    case ParameterType::choice:
      if (value.is_string())
        for (std::size_t i = 0; i < spec.choices.size(); ++i)
          if (spec.choices[i] == value.get_ref<const std::string&>()) return int(i);
      mismatch(spec, value, where);
    case ParameterType::text:
      if (!value.is_string()) mismatch(spec, value, where);
      return value.get<std::string>();
    case ParameterType::real2: {
      if (!value.is_array() || value.size() != 2) mismatch(spec, value, where);
      return dvec2(number_of(spec, value[0], value, where), number_of(spec, value[1], value, where));
    }
    case ParameterType::real3: {
      if (spec.grey && value.is_number()) return dvec3(number_of(spec, value, value, where));
      if (!value.is_array() || value.size() != 3) mismatch(spec, value, where);
      return dvec3(number_of(spec, value[0], value, where), number_of(spec, value[1], value, where),
                   number_of(spec, value[2], value, where));
    }
  }
  mismatch(spec, value, where);
}

json json_from_text(const std::string& text) {
  if (text == "on" || text == "yes") return true;
  if (text == "off" || text == "no") return false;
  const auto parse = [](const std::string& t) { return json::parse(t, nullptr, false); };
  if (json value = parse(text); !value.is_discarded()) return value;
  if (text.find(',') != std::string::npos)
    if (json value = parse("[" + text + "]"); !value.is_discarded()) return value;
  return text;
}

json to_json(const ParameterSpec& spec, const ParameterValue& value) {
  // Through the shortest decimal that is the same float: 0.01, not 0.009999999776482582.
  const auto number = [](double x) { return json::parse(fmt::format("{}", float(x))); };
  switch (spec.type) {
    case ParameterType::boolean:
      return std::get<bool>(value);
    case ParameterType::integer:
      return std::get<int>(value);
    case ParameterType::real:
      return number(std::get<double>(value));
    case ParameterType::choice:
      return spec.choices.at(std::size_t(std::get<int>(value)));
    case ParameterType::text:
      return std::get<std::string>(value);
    case ParameterType::real2: {
      const dvec2 v = std::get<dvec2>(value);
      return {number(v.x), number(v.y)};
    }
    case ParameterType::real3: {
      const dvec3 v = std::get<dvec3>(value);
      return {number(v.x), number(v.y), number(v.z)};
    }
  }
  return {};
}

}  // namespace plinian
