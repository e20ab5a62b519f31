// An attribute is declared once: its name, type, default, ranges, unit, help and layout. Files, commands and
// the attribute editor derive from the declaration.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/graph/types/data_type.h"
#include "host/graph/values/value.h"

namespace plinian::graph {

/// A word of an enum and the number it stands for; numbers may have gaps.
struct Choice {
  int value = 0;
  std::string word;   // as files and commands spell it
  std::string label;  // as the interface shows it; empty: the word
};

/// Where and how the attribute editor shows an attribute.
struct AttributeLayout {
  std::string group;                     // heading it stands under
  std::string widget;                    // e.g. "slider"; empty: what the type suggests
  std::string shown_when;                // name of another attribute of the node; empty: always shown
  std::vector<std::string> shown_words;  // ... shown while that one reads as one of these
};

struct AttributeSpec {
  std::string name;  // as files and commands spell it
  AttributeType type = AttributeType::float1;
  Value default_value;  // empty: the zero value of the type
  std::string nice_name, help, unit;
  AttributeLayout layout;
  std::vector<Choice> choices;                       // enum
  std::string data_type;                             // data: what connects to it
  DataSlotPtr data_slot;                             // ... and how it is stored; given by the registry
  std::optional<double> minimum, maximum;            // of each number: clamped when set
  std::optional<double> soft_minimum, soft_maximum;  // ends of the slider, no more
  double step = 0.0;                                 // of the slider; 0: smooth
  bool array = false;   // sparse: elements exist where they were set or connected
  bool output = false;  // computed; neither set nor stored
  bool keyable = true, storable = true, connectable = true;
  bool hidden = false, read_only = false;
  std::vector<AttributeSpec> children;  // compound
  std::vector<std::string> affects;     // outputs whose computation reads this
};

/// The choices of an enum with their numbers: "off (0), low (10)".
std::string choices_text(const AttributeSpec& spec);

/// Whether a word may name an attribute or a type: letters, digits and _, not a digit first.
bool is_identifier(std::string_view word);

/// The value as the attribute would hold it: numbers converted where nothing is lost, those out of the hard
/// range clamped (then *clamped is set). Throws GraphError, naming what it expects, for another kind of
/// value, for a number that is not finite and for one that is no choice of an enum.
Value fitted(const AttributeSpec& spec, const Value& value, bool* clamped = nullptr);

}  // namespace plinian::graph
