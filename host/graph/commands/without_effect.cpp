// Attributes that count only while another one of their node reads so: what is keyed or driven in vain.
#include <algorithm>

#include "core/scene/nearest_word.h"
#include "host/graph/commands/session.h"
#include "host/graph/values/value_text.h"

namespace plinian::graph {

std::string without_effect(const Graph& graph, const Plug& plug) {
  const Node& node = *graph.find(plug.node);
  const AttributeLayout& layout = graph.attribute(plug).spec.layout;
  const AttributeIndex other =
      layout.shown_when.empty() ? no_attribute : node.schema->find(layout.shown_when);
  // What is driven may read so at another time.
  if (other == no_attribute || node.input(other)) return "";
  const AttributeSpec& spec = (*node.schema)[other].spec;
  const std::string now = write_value(spec, node.value(other), graph.names());
  const auto& words = layout.shown_words;
  const bool counts = words.empty() ? !now.empty() && now != "false" && now != "0"
                                    : std::find(words.begin(), words.end(), now) != words.end();
  if (counts) return "";
  const std::string name = node.name + "." + layout.shown_when;
  return graph.name_of(plug) + " does nothing while " + name + " is " + (now.empty() ? "empty" : now) +
         (words.size() == 1 ? ": setAttr " + name + " " + words[0]
                            : ": it counts where that is " + (words.empty() ? "set" : join(words, " or ")));
}

}  // namespace plinian::graph
