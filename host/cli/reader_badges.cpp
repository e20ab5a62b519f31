#include "host/cli/reader_badges.h"

#include "host/graph/model/conversion.h"

namespace plinian::cli {

namespace {

// Empty where there is nothing to say.
std::string badge_line(graph::Session& session, const graph::Node& reader) {
  const auto badge = reader_output(session, reader, "badge");
  if (!badge || std::get<std::string>(*badge).empty()) return "";
  return reader.name + ": " + std::get<std::string>(*badge);
}

}  // namespace

std::vector<const graph::Node*> volume_readers(const graph::Graph& graph) {
  std::vector<const graph::Node*> readers;
  for (const graph::Node* node : graph.nodes())
    if (node->type->name() == "volumeRead" && !node->type->is_unknown()) readers.push_back(node);
  return readers;
}

std::optional<graph::Value> reader_output(graph::Session& session, const graph::Node& reader,
                                          const char* output) {
  const graph::ResultPtr result = session.evaluator().evaluate(session.graph().plug(reader, output));
  return result->error ? std::nullopt : std::optional(result->value);
}

std::vector<std::string> reader_badges(graph::Session& session) {
  std::vector<std::string> lines;
  for (const graph::Node* node : volume_readers(session.graph()))
    if (std::string line = badge_line(session, *node); !line.empty()) lines.push_back(std::move(line));
  return lines;
}

std::vector<std::string> missing_files(graph::Session& session) {
  std::vector<std::string> lines;
  for (const graph::Node* node : volume_readers(session.graph())) {
    const auto missing = reader_output(session, *node, "frame_missing");
    const bool fills = session.execute("getAttr " + node->name + ".missing").front() == "hold";
    if (missing && graph::number_of(*missing) != 0.0 && !fills) lines.push_back(badge_line(session, *node));
  }
  return lines;
}

}  // namespace plinian::cli
