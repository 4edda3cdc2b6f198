#include "morph/step_blend.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "morph/measures.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// How chords come in from the outline: by this power of 1 - s. A quarter of the way in the first tenth of the
// time, and nearly all of it by half-time.
constexpr int kPushed = 3;

double power(double x) {
  double product = 1.0;
  for (int i = 0; i < kPushed; ++i) product *= x;
  return product;
}

bool is_point(const CubicPath& path) {
  const Points& p = path.control_points();
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (p[i][0] != p[0][0] || p[i][1] != p[0][1]) return false;
  }
  return true;
}

PlanarFrame frame_for(BlendKind kind, const PlanarFrame& frame) {
  if (kind == BlendKind::bezier) return {};
  if (kind == BlendKind::similarity) return frame;
  return {frame.first_center(), frame.second_center(), frame.degrees(), 1.0};
}

}  // namespace

StepBlend::StepBlend(BlendKind kind, const PlanarFrame& frame, std::span<const ContourEnds> contours)
    : frame_(frame_for(kind, frame)) {
  for (const ContourEnds& ends : contours) {
    ContourEnds seen{ends.a, frame_.from_second(ends.b)};
    // What grows from a point has no lengths or directions there: it grows evenly.
    const bool born = is_point(seen.a);
    const bool grows = born || is_point(seen.b);
    auto blend = make_contour_blend(grows ? BlendKind::affine : kind, seen.a, seen.b);
    const bool closed = ends.a.is_closed() && ends.b.is_closed();
    contours_.push_back({std::move(blend),
                         ends.a.control_points().data().size(),
                         closed,
                         born,
                         std::move(seen),
                         {},
                         {},
                         {},
                         {}});
  }
}

std::vector<ContourEnds> StepBlend::ends_in_frame() const {
  std::vector<ContourEnds> ends;
  for (const Contour& contour : contours_) ends.push_back(contour.ends);
  return ends;
}

void StepBlend::set_detour(std::size_t contour, const ContourDetour& detour) {
  Contour& c = contours_[contour];
  c.detour = detour;
  if (!(detour.width > 0.0)) {
    c.filter.reset();
  } else if (!c.filter) {
    c.filter.emplace(c.ends.a, c.ends.b);
  }
}

void StepBlend::set_outlines(std::size_t contour, const ContourEnds& drawn) {
  Contour& c = contours_[contour];
  const auto off = [](const CubicPath& to, const CubicPath& from) {
    const auto p = to.control_points().data();
    const auto q = from.control_points().data();
    std::vector<double> difference(p.size());
    std::transform(p.begin(), p.end(), q.begin(), difference.begin(), std::minus<>());
    return difference;
  };
  c.off_first = off(drawn.a, c.ends.a);
  c.off_last = off(frame_.from_second(drawn.b), c.ends.b);
  const auto any = [](const std::vector<double>& offsets) {
    return std::any_of(offsets.begin(), offsets.end(), [](double x) { return x != 0.0; });
  };
  parts_first_ = parts_first_ || any(c.off_first);
  parts_last_ = parts_last_ || any(c.off_last);
}

double StepBlend::progress(double s) const noexcept {
  if (s <= 0.0 || s >= 1.0) return s;
  if (parts_first_ && parts_last_) return s * s * (3.0 - 2.0 * s);
  if (parts_first_) return s * s;
  return parts_last_ ? s * (2.0 - s) : s;
}

StepBlend::OutlineShares StepBlend::outline_shares(double s) noexcept {
  return {power(std::clamp(1.0 - s, 0.0, 1.0)), power(std::clamp(s, 0.0, 1.0))};
}

bool StepBlend::is_linear() const noexcept {
  return frame_.scale() == 1.0 && std::all_of(contours_.begin(), contours_.end(), [](const Contour& c) {
           return c.blend->is_linear() && c.detour.is_none() && c.off_first.empty();
         });
}

void StepBlend::at(double s, std::size_t contour, std::span<double> points) const {
  const Contour& c = contours_[contour];
  const double done = progress(s);
  c.blend->at(done, points);
  if (!c.off_first.empty()) {
    const OutlineShares left = outline_shares(s);
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] += left.first * c.off_first[i] + left.last * c.off_last[i];
  }
  frame_.place(done, points);
  // Beyond the ends there is nothing to be avoided.
  if (c.detour.is_none() || s <= 0.0 || s >= 1.0) return;
  const double off = (2.0 * s - 1.0) * (2.0 * s - 1.0);
  // Gentle: as high nearly everywhere, and flat at both ends.
  const double bump =
      gentle_ ? (1.0 - off * off * off * off) * (1.0 - off * off * off * off) : 1.0 - off * off;
  if (c.filter) c.filter->apply(bump * c.detour.width, points);
  if (c.detour.shrink == 0.0 && c.detour.offset == Vec2{} && !c.detour.late) return;
  const Vec2 center = center_of_edges(points);
  double scale = 1.0 - bump * c.detour.shrink;
  if (c.detour.late) {
    const double grown = c.born ? s : 1.0 - s;
    scale *= gentle_ ? grown * grown * (3.0 - 2.0 * grown) : grown * grown;
  }
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
    points[i] = center.x + bump * c.detour.offset.x + scale * (points[i] - center.x);
    points[i + 1] = center.y + bump * c.detour.offset.y + scale * (points[i + 1] - center.y);
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
