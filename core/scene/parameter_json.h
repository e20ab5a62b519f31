// Parameters from JSON and from the text of --set, with errors that say where and what was expected.
// For .cpp files: the callers include <nlohmann/json.hpp> themselves.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>

#include "core/scene/parameter.h"

namespace plinian {

/// Reads a JSON file. Throws std::runtime_error with one line (file, line and column, reason) where it is
/// missing, not JSON, or names a key twice.
nlohmann::json read_json_file(const std::string& path);

/// The value of `spec` in `value`. where: "smoke.json: lights[0].irradiance", the start of the error line.
/// Throws std::runtime_error "WHERE: expected ..., got ...".
ParameterValue read_parameter(const ParameterSpec& spec, const nlohmann::json& value,
                              const std::string& where);

/// Text as --set takes it (12, 0.5, true, word, 1,2,3, [1,2,3]) as JSON.
nlohmann::json json_from_text(const std::string& text);

/// A value as JSON, the counterpart of read_parameter.
nlohmann::json to_json(const ParameterSpec& spec, const ParameterValue& value);

/// JSON in one short line, for error messages.
std::string short_text(const nlohmann::json& value);

}  // namespace plinian
