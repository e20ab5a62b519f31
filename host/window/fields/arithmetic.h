// Arithmetic in number fields.
#pragma once

#include <optional>
#include <string>

namespace plinian::window {

/// The value of what was typed: numbers with + - * / ( ), or a change of the value that was there: `+=2`,
/// `-=2`, `*=2`, `/=2`, `*2`, `/2`. None where it is nothing of that, or not finite.
std::optional<double> typed_number(const std::string& text, double current);

}  // namespace plinian::window
