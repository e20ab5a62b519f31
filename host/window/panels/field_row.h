// A row of the attribute editor: a label, its field, and room for a mark.
#pragma once

#include <string>

namespace plinian::window {

/// Writes the label and goes to where the field begins; returns how wide that is. [points] strong: of what is
/// not at its default.
float field_label(const std::string& label, bool strong, const std::string& help);

/// What is kept free behind the field. [points]
float field_mark_width();

}  // namespace plinian::window
