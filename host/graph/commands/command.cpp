// Parses and prints calls.
#include "host/graph/commands/command.h"

#include <algorithm>
#include <cmath>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"
#include "host/graph/values/value_text.h"

namespace plinian::graph {

namespace {

// "-time", but not "-5" or "-.5"; also what is none and was meant for one, "--time" and "-level-set".
bool is_flag(const Word& word) {
  if (word.quoted || !word.text.starts_with('-')) return false;
  const std::size_t begin = word.text.find_first_not_of('-');
  std::string name = begin == word.text.npos ? "" : word.text.substr(begin);
  std::replace(name.begin(), name.end(), '-', '_');
  return is_identifier(name);
}

// A flag as others spell it: "--level-set" and "-level_set" for -levelSet.
std::string in_camel_case(std::string_view word) {
  std::string name;
  bool raised = false;
  for (const char c : word.substr(word.find_first_not_of('-'))) {
    const bool mark = c == '-' || c == '_';
    if (!mark) name += raised ? char(std::toupper((unsigned char)c)) : c;
    raised = mark;
  }
  return name;
}

bool is_number(const Word& word) {
  try {
    read_number(word.text);
    return !word.quoted;
  } catch (const GraphError&) {
    return false;
  }
}

std::string upper(std::string text) {
  for (char& c : text) c = char(std::toupper((unsigned char)c));
  return text;
}

void check_word(const CommandSpec& spec, const std::string& name, ArgumentKind kind, const Word& word) {
  if (kind != ArgumentKind::number && kind != ArgumentKind::integer) return;
  try {
    const double number = read_number(word.text);
    constexpr double largest = 2147483647.0;
    if (kind == ArgumentKind::integer && number != std::floor(number))
      throw GraphError("expects an integer, not " + shown(word.text));
    if (kind == ArgumentKind::integer && std::abs(number) > largest)
      throw GraphError("expects an integer of at most " + write_number(largest) + ", not " +
                       shown(word.text));
  } catch (const GraphError& error) {
    throw GraphError(spec.name + ": " + name + " " + error.what());
  }
}

}  // namespace

const std::vector<Word>& Arguments::words(const std::string& name) const {
  static const std::vector<Word> none;
  const auto found = words_.find(name);
  return found == words_.end() ? none : found->second;
}

std::vector<std::string> Arguments::texts(const std::string& name) const {
  std::vector<std::string> result;
  for (const Word& word : words(name)) result.push_back(word.text);
  return result;
}

std::string Arguments::text(const std::string& name, const std::string& otherwise) const {
  const auto& found = words(name);
  return found.empty() ? otherwise : found.front().text;
}

std::optional<double> Arguments::number(const std::string& name) const {
  const auto& found = words(name);
  return found.empty() ? std::nullopt : std::optional(read_number(found.front().text));
}

Arguments parse_arguments(const CommandSpec& spec, const std::vector<Word>& words) {
  Arguments arguments;
  std::vector<Word> rest;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!is_flag(words[i])) {
      rest.push_back(words[i]);
      continue;
    }
    const std::string name = words[i].text.substr(1);
    const auto flag = std::find_if(spec.flags.begin(), spec.flags.end(),
                                   [&](const CommandFlag& other) { return other.name == name; });
    if (flag == spec.flags.end()) {
      std::vector<std::string> known;
      for (const CommandFlag& other : spec.flags) known.push_back("-" + other.name);
      const std::string spelled = "-" + in_camel_case(words[i].text);
      const std::string meant = std::ranges::count(known, spelled) ? " (did you mean '" + spelled + "'?)"
                                                                   : did_you_mean(words[i].text, known);
      throw GraphError(spec.name + ": unknown flag " + shown(words[i].text) +
                       (!meant.empty()  ? meant
                        : known.empty() ? "; it takes none"
                                        : "; there are: " + join(known)));
    }
    if (arguments.has(name) && !flag->many) throw GraphError(spec.name + ": -" + name + " is given twice");
    if (!flag->takes) {
      arguments.set(name, {});
      continue;
    }
    if (i + 1 == words.size() || is_flag(words[i + 1]))
      throw GraphError(spec.name + ": -" + name + " needs a word behind it");
    std::vector<Word> taken = arguments.words(name);
    taken.push_back(words[++i]);
    while (flag->vector && i + 1 < words.size() && is_number(words[i + 1])) taken.push_back(words[++i]);
    for (const Word& word : taken) check_word(spec, "-" + name, *flag->takes, word);
    arguments.set(name, std::move(taken));
  }

  std::size_t next = 0, needed_later = 0;
  for (const CommandParameter& parameter : spec.parameters) needed_later += !parameter.optional;
  for (const CommandParameter& parameter : spec.parameters) {
    needed_later -= !parameter.optional;
    const std::size_t left = rest.size() - next;
    std::size_t take = left > needed_later ? (parameter.many ? left - needed_later : 1) : 0;
    // Too few: those that are there are the first ones.
    if (take == 0 && !parameter.optional && left > 0) take = 1;
    if (take == 0 && !parameter.optional)
      throw GraphError(spec.name + ": " + upper(parameter.name) + " is missing: " + usage(spec));
    if (take == 0) continue;
    for (std::size_t i = next; i < next + take; ++i)
      check_word(spec, upper(parameter.name), parameter.kind, rest[i]);
    arguments.set(parameter.name,
                  {rest.begin() + std::ptrdiff_t(next), rest.begin() + std::ptrdiff_t(next + take)});
    next += take;
  }
  if (next < rest.size())
    throw GraphError(spec.name + ": " + shown(rest[next].text) + " is one word too many: " + usage(spec));
  return arguments;
}

std::string write_call(const CommandSpec& spec, const Arguments& arguments) {
  std::string line = spec.name;
  const auto add = [&](const Word& word) {
    // What was quoted stays quoted: it may look like a flag.
    line += ' ';
    line += word.quoted ? quote(word.text) : word.text;
  };
  for (const CommandFlag& flag : spec.flags) {
    if (!arguments.has(flag.name)) continue;
    bool first = true;
    for (const Word& word : arguments.words(flag.name)) {
      if (flag.many || first) line += " -" + flag.name;
      first = false;
      add(word);
    }
    if (first) line += " -" + flag.name;
  }
  for (const CommandParameter& parameter : spec.parameters)
    for (const Word& word : arguments.words(parameter.name)) add(word);
  return line;
}

std::string usage(const CommandSpec& spec) {
  std::string text = spec.name;
  for (const CommandParameter& parameter : spec.parameters) {
    const std::string name = upper(parameter.name) + (parameter.many ? "..." : "");
    text += parameter.optional ? " [" + name + "]" : " " + name;
  }
  return text;
}

std::vector<std::string> help_lines(const CommandSpec& spec) {
  std::vector<std::string> lines = {usage(spec), "  " + spec.help};
  const auto padded = [](std::string text) {
    text.resize(std::max<std::size_t>(text.size() + 1, 18), ' ');
    return text;
  };
  for (const CommandParameter& parameter : spec.parameters)
    lines.push_back("    " + padded(upper(parameter.name)) + parameter.help);
  for (const CommandFlag& flag : spec.flags)
    lines.push_back("    " + padded("-" + flag.name + (flag.takes ? " " + upper(flag.name) : "")) +
                    flag.help + (flag.many ? "; may be repeated" : ""));
  return lines;
}

void CommandRegistry::add(CommandSpec spec) {
  const std::string name = spec.name;
  if (!commands_.emplace(name, std::move(spec)).second)
    throw GraphError("the command '" + name + "' is already registered");
}

void CommandRegistry::add_flags(const std::string& name, const std::vector<CommandFlag>& flags) {
  std::vector<CommandFlag>& there = commands_.at(name).flags;
  for (const CommandFlag& flag : flags)
    if (std::ranges::none_of(there, [&](const CommandFlag& other) { return other.name == flag.name; }))
      there.push_back(flag);
}

const CommandSpec& CommandRegistry::get(const std::string& name) const {
  const auto found = commands_.find(name);
  if (found != commands_.end()) return found->second;
  throw GraphError("unknown command " + shown(name) + elsewhere.hint(name, names()));
}

std::vector<std::string> CommandRegistry::names() const {
  std::vector<std::string> result;
  for (const auto& [name, spec] : commands_) result.push_back(name);
  return result;
}

}  // namespace plinian::graph
