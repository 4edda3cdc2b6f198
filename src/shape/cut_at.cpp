#include "tandem/shape/cut_at.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "shape/sub_path.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

/// The segment that holds the middle of [from, to], and where both ends lie in it.
SegmentPart part_between(const CubicPath& path, double from, double to) {
  const double n = static_cast<double>(path.segment_count());
  const double middle = std::floor(0.5 * from + 0.5 * to);
  const double lap = path.is_closed() ? std::floor(middle / n) * n : 0.0;
  const double segment = std::clamp(middle - lap, 0.0, n - 1.0);
  const auto local = [&](double parameter) { return std::clamp(parameter - lap - segment, 0.0, 1.0); };
  return {static_cast<std::size_t>(segment), local(from), local(to)};
}

}  // namespace

CubicPath cut_at(const CubicPath& path, const std::vector<double>& cuts, bool closed) {
  if (cuts.size() < 2) throw InvalidArgument("cut_at: fewer than two cuts");
  std::vector<SegmentPart> parts;
  parts.reserve(cuts.size() - 1);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) parts.push_back(part_between(path, cuts[i], cuts[i + 1]));
  return join_parts(path, parts, closed);
}

}  // namespace v0
}  // namespace tandem
