// Added attributes as lines of a scene: `float glow.amount min 0 max 1 default "0.5"`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "host/graph/types/attribute_spec.h"
#include "host/graph/values/words.h"

namespace plinian::graph {

/// One line for the attribute and one for each child, the compound first.
std::vector<std::string> write_declaration(const AttributeSpec& spec);

/// Reads one line. path: "glow.amount"; the children of a compound are declared by lines of their own. Throws
/// GraphError.
AttributeSpec read_declaration(std::span<const Word> words, std::string& path);

/// Puts a declaration under the compound that its path names, or at the end. Throws GraphError.
void add_declaration(std::vector<AttributeSpec>& specs, const std::string& path, AttributeSpec spec);

/// "off:0,low:10" or "off,low" as the choices of an enum. Throws GraphError.
std::vector<Choice> read_choices(const std::string& text);

}  // namespace plinian::graph
