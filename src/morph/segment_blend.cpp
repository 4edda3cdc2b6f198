#include "tandem/morph/segment_blend.h"

#include <fmt/format.h>

#include <utility>

#include "morph/hermite_plan.h"
#include "shape/third.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

void check_compatible(const CubicPath& a, const CubicPath& b) {
  if (a.dim() != b.dim()) {
    throw InvalidArgument(
        fmt::format("blend: the paths have dimensions {} and {}, expected one", a.dim(), b.dim()));
  }
  if (a.segment_count() != b.segment_count()) {
    throw InvalidArgument(fmt::format("blend: the paths have {} and {} segments, expected as many",
                                      a.segment_count(), b.segment_count()));
  }
  if (a.is_closed() != b.is_closed()) {
    throw InvalidArgument("blend: one path is closed, the other open; expected both alike");
  }
}

}  // namespace

CubicPath bezier_blend(const CubicPath& a, const CubicPath& b, double s) {
  check_compatible(a, b);
  Points points = a.control_points();
  const auto from = a.control_points().data();
  const auto to = b.control_points().data();
  for (std::size_t k = 0; k < from.size(); ++k) points.data()[k] = (1.0 - s) * from[k] + s * to[k];
  return CubicPath(std::move(points), a.is_closed());
}

HermiteBlend::HermiteBlend(const CubicPath& a, const CubicPath& b) {
  check_compatible(a, b);
  plan_ = std::make_shared<const detail::HermitePlan>(detail::plan_hermite_blend(a, b));
}

int HermiteBlend::dim() const noexcept {
  return plan_->a.dim();
}

std::size_t HermiteBlend::segment_count() const noexcept {
  return plan_->straight.size();
}

bool HermiteBlend::is_straight(std::size_t i) const noexcept {
  return plan_->straight[i] != 0;
}

void HermiteBlend::at(double s, std::span<double> points) const {
  const std::size_t n = static_cast<std::size_t>(dim());
  if (points.size() != plan_->a.data().size()) {
    throw InvalidArgument(
        fmt::format("blend: room for {} coordinates, expected {}", points.size(), plan_->a.data().size()));
  }
  const std::size_t segments = segment_count();
  const auto point = [&](std::size_t i) { return points.subspan(i * n, n); };
  for (std::size_t j = 0; j <= segments; ++j) {
    for (std::size_t k = 0; k < n; ++k) {
      point(3 * j)[k] = (1.0 - s) * plan_->a[3 * j][k] + s * plan_->b[3 * j][k];
    }
  }
  for (std::size_t i = 0; i < segments; ++i) {
    const auto [start, first] = std::pair(point(3 * i), point(3 * i + 1));
    const auto [second, end] = std::pair(point(3 * i + 2), point(3 * i + 3));
    if (plan_->straight[i] != 0) {
      for (std::size_t k = 0; k < n; ++k) {
        first[k] = third(start[k], end[k]);
        second[k] = third(end[k], start[k]);
      }
      continue;
    }
    plan_->handle_at(2 * i, s, first);
    plan_->handle_at(2 * i + 1, s, second);
    for (std::size_t k = 0; k < n; ++k) {
      first[k] += start[k];
      second[k] = end[k] - second[k];
    }
  }
}

CubicPath HermiteBlend::at(double s) const {
  Points points(dim(), plan_->a.size());
  at(s, points.data());
  return CubicPath(std::move(points), plan_->closed);
}

}  // namespace v0
}  // namespace tandem
