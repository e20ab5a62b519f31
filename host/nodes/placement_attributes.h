// The attributes by which something has a place in the hierarchy: Maya's transform.
#pragma once

#include "core/scene/placement.h"
#include "host/sdk/plugin.h"

namespace plinian::nodes {

/// Declares translate, rotate, rotate_order, scale, pivot and visibility on a node type. Whoever makes the
/// picture reads them by these names, so that moving a node computes nothing. affects: outputs that read
/// them.
class PlacementAttributes {
 public:
  explicit PlacementAttributes(sdk::NodeType& type, const std::string& affects = "");
  Placement read(const sdk::Context& context) const;

 private:
  sdk::Attribute translate_[3], rotate_[3], scale_[3], pivot_[3], order_;
};

}  // namespace plinian::nodes
