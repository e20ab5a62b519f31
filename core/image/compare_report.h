// A comparison as one HTML file that needs nothing else: both pictures under a wipe, side by side or
// flickering, heat maps of the error, the figures and how the pictures were made.
#pragma once

#include <string>
#include <vector>

#include "core/image/compare.h"
#include "core/image/view_transform.h"

namespace plinian {

struct ReportText {
  std::string name_a, name_reference;  // what the pictures are called: their paths
  std::vector<Limit> limits;           // that were asked for; the report says whether they hold
};

/// The report as HTML. The pictures are shown through `view` at each exposure of the comparison's FLIP
/// figures (added to the view's own), the first at the start. Throws ImageError.
std::string compare_report(const Image& a, const Image& reference, const CompareResult& result,
                           const ReportText& text, const ViewSettings& view = parse_view("srgb"));

/// Writes it, whole or not at all. Throws FileError.
void write_compare_report(const std::string& path, const Image& a, const Image& reference,
                          const CompareResult& result, const ReportText& text,
                          const ViewSettings& view = parse_view("srgb"));

}  // namespace plinian
