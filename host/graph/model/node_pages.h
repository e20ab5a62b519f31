// Nodes by their numbers, in pages that a snapshot shares with the living graph until one of them changes: a
// snapshot costs a pointer for each page, and an edit the copy of one page.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "host/graph/model/node.h"

namespace plinian::graph {

class NodePages {
 public:
  /// The node of that number, or null.
  const Node* find(NodeId id) const {
    const std::size_t page = id.value / page_size;
    return page < pages_.size() ? pages_[page]->nodes[id.value % page_size].get() : nullptr;
  }
  /// The place of a node, made where there is none yet. epoch: counts snapshots; pages of an older one may be
  /// shared, and are copied.
  std::shared_ptr<Node>& place(NodeId id, std::uint64_t epoch) {
    const std::size_t page = id.value / page_size;
    while (pages_.size() <= page) pages_.push_back(std::make_shared<Page>(Page{{}, epoch}));
    std::shared_ptr<Page>& found = pages_[page];
    if (found->epoch < epoch) {
      found = std::make_shared<Page>(*found);
      found->epoch = epoch;
    }
    return found->nodes[id.value % page_size];
  }
  /// One more than any number in use.
  std::uint32_t end() const { return std::uint32_t(pages_.size() * page_size); }

 private:
  static constexpr std::size_t page_size = 64;
  struct Page {
    std::array<std::shared_ptr<Node>, page_size> nodes;
    std::uint64_t epoch = 0;
  };
  std::vector<std::shared_ptr<Page>> pages_;
};

}  // namespace plinian::graph
