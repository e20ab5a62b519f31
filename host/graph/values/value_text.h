// Values as words and words as values: the one text form that scenes, commands and the console share.
//
// Numbers are written in the shortest form that reads back to the same bits (std::to_chars).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "host/graph/types/attribute_spec.h"
#include "host/graph/values/words.h"

namespace plinian::graph {

/// How references to nodes are spelled. Either may be empty; a node without a name is written as "none".
struct NodeNames {
  std::function<std::string(NodeId)> name_of;
  std::function<NodeId(std::string_view)> id_of;  // 0 where there is none
};

/// The value in words that read_value takes, separated by spaces: `0.1`, `1 0.5 0`, `"ash column"`, `smooth`,
/// `0:1,1,1:linear 1:0,0,0:smooth`. Data whose type is not registered have no text: "".
std::string write_value(const AttributeSpec& spec, const Value& value, const NodeNames& names = {});

/// The value that the words stand for; vectors may be separated by commas as well, a colour may be one grey
/// number, a distance may end in mm, cm, m, km, in or ft, an angle in deg or rad, a time in f. Not clamped.
/// Throws GraphError, saying what is expected, for anything else.
Value read_value(const AttributeSpec& spec, std::span<const Word> words, const NodeNames& names = {});

/// A number in its shortest exact form.
std::string write_number(float number);
std::string write_number(double number);

/// A whole word as a finite number. Throws GraphError.
double read_number(std::string_view word);

/// "a number from 0 to 1", "one of ash, cloud", "3 numbers".
std::string expectation(const AttributeSpec& spec);

}  // namespace plinian::graph
