#include "tandem/shape/hermite_segments.h"

#include <fmt/format.h>

#include <cstddef>
#include <utility>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

Point tripled_difference(std::span<const double> from, std::span<const double> to) {
  Point tangent(from.size());
  for (std::size_t k = 0; k < from.size(); ++k) tangent[k] = 3.0 * (to[k] - from[k]);
  return tangent;
}

void check_dimension(const HermiteSegment& segment, std::size_t dim, std::size_t i) {
  for (const Point* p : {&segment.start, &segment.end, &segment.start_tangent, &segment.end_tangent}) {
    if (p->size() != dim) {
      throw InvalidArgument(fmt::format(
          "Hermite segment {} has points and tangents of {} and {} dimensions, expected one dimension", i,
          p->size(), dim));
    }
  }
}

}  // namespace

std::vector<HermiteSegment> to_hermite_segments(const CubicPath& path) {
  std::vector<HermiteSegment> segments;
  segments.reserve(path.segment_count());
  for (std::size_t i = 0; i < path.segment_count(); ++i) {
    const auto [p0, p1, p2, p3] = path.segment(i);
    segments.push_back({Point(p0.begin(), p0.end()), Point(p3.begin(), p3.end()), tripled_difference(p0, p1),
                        tripled_difference(p2, p3)});
  }
  return segments;
}

CubicPath from_hermite_segments(std::span<const HermiteSegment> segments, bool closed) {
  if (segments.empty()) throw InvalidArgument("a path needs at least one Hermite segment");
  const std::size_t dim = segments.front().start.size();
  Points points;
  points.push_back(segments.front().start);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const HermiteSegment& segment = segments[i];
    check_dimension(segment, dim, i);
    if (i > 0 && segment.start != segments[i - 1].end) {
      throw InvalidArgument(fmt::format("Hermite segment {} does not start where segment {} ends", i, i - 1));
    }
    Point handle(dim);
    for (std::size_t k = 0; k < dim; ++k) handle[k] = segment.start[k] + segment.start_tangent[k] / 3.0;
    points.push_back(handle);
    for (std::size_t k = 0; k < dim; ++k) handle[k] = segment.end[k] - segment.end_tangent[k] / 3.0;
    points.push_back(handle);
    points.push_back(segment.end);
  }
  return CubicPath(std::move(points), closed);
}

}  // namespace v0
}  // namespace tandem
