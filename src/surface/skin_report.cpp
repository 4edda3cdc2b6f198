#include "surface/skin_report.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "curve/check_spline.h"
#include "curve/evaluator.h"
#include "curve/norm.h"
#include "surface/surface_evaluator.h"
#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Places per section at which costs are summed: some four per node of a match.
constexpr std::size_t kPlaces = 512;
/// Places per section at which the interpolation is checked.
constexpr std::size_t kProbes = 64;

double at_place(const Interval& domain, std::size_t i, std::size_t places) {
  return domain.lo + (static_cast<double>(i) + 0.5) / static_cast<double>(places) * domain.length();
}

/// Unit tangents, and shares of the length, at kPlaces places of a section.
struct Places {
  Points tangents;
  std::vector<double> lengths;
};

Places look_at(const Curve& section) {
  const auto dim = static_cast<std::size_t>(section.dim());
  const Evaluator evaluator(section);
  Places places{Points(section.dim(), kPlaces), std::vector<double>(kPlaces)};
  std::vector<double> rows(2 * dim);
  double length = 0.0;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    evaluator.derivatives(at_place(section.domain(), i, kPlaces), 1, Side::right, rows);
    const std::span<const double> d(rows.data() + dim, dim);
    const double speed = scaled_norm(d);
    for (std::size_t c = 0; c < dim && speed > 0.0; ++c) places.tangents[i][c] = d[c] / speed;
    places.lengths[i] = speed;
    length += speed / static_cast<double>(kPlaces);
  }
  for (double& x : places.lengths) x /= length * static_cast<double>(kPlaces);
  return places;
}

double cost_between(const Places& a, const Places& b, double lambda) {
  double cost = 0.0;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    double dot = 0.0;
    for (std::size_t c = 0; c < a.tangents[i].size(); ++c) dot += a.tangents[i][c] * b.tangents[i][c];
    const double sum = a.lengths[i] + b.lengths[i];
    const double difference = a.lengths[i] - b.lengths[i];
    if (sum > 0.0) cost += (1.0 - dot) * 0.5 * sum + lambda * difference * difference / sum;
  }
  return cost;
}

double angle_between(std::span<const double> a, std::span<const double> b) {
  double dot = 0.0;
  Point gap(a.size());
  for (std::size_t c = 0; c < a.size(); ++c) {
    dot += a[c] * b[c];
    gap[c] = a[c] - b[c];
  }
  // By the chord: the cosine knows no small angles.
  const double chord = std::min(1.0, 0.5 * scaled_norm(gap));
  return scaled_norm(a) == 0.0 || scaled_norm(b) == 0.0 ? 0.0 : 2.0 * std::asin(chord);
}

/// The turn of a section's tangent at u; `seam`: from the end of its domain to the start.
double turn_at(const Curve& section, double u, bool seam) {
  const double before = seam ? section.domain().hi : u;
  Points rows[2] = {section.derivatives(before, 1, Side::left), section.derivatives(u, 1, Side::right)};
  for (Points& row : rows) {
    const double speed = scaled_norm(row[1]);
    for (double& x : row[1]) x = speed > 0.0 ? x / speed : 0.0;
  }
  return angle_between(rows[0][1], rows[1][1]);
}

}  // namespace

std::vector<double> pair_costs(std::span<const Curve> sections, double lambda, bool ring) {
  std::vector<Places> places;
  for (const Curve& section : sections) places.push_back(look_at(section));
  std::vector<double> costs;
  for (std::size_t k = 0; k + (ring ? 0 : 1) < places.size(); ++k) {
    costs.push_back(cost_between(places[k], places[(k + 1) % places.size()], lambda));
  }
  return costs;
}

double crease_angle(const Surface& surface, std::span<const Curve> sections,
                    std::span<const double> parameters, double corner_angle) {
  if (surface.dim() != 3) return 0.0;
  std::vector<double> v;
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const double next = j + 1 < parameters.size() ? parameters[j + 1] : surface.domain(Along::v).hi;
    v.push_back(parameters[j]);
    if (next > parameters[j]) v.insert(v.end(), {0.75 * parameters[j] + 0.25 * next, 0.5 * parameters[j] + 0.5 * next});
  }
  const Interval domain = surface.domain(Along::u);
  double worst = 0.0;
  for (const Knot& knot : distinct_knots(surface.knots(Along::u))) {
    const bool seam = knot.value == domain.lo && surface.is_closed(Along::u);
    const bool inside = domain.lo < knot.value && knot.value < domain.hi;
    if (!seam && !(inside && knot.multiplicity >= surface.degree(Along::u))) continue;
    if (std::any_of(sections.begin(), sections.end(),
                    [&](const Curve& c) { return turn_at(c, knot.value, seam) > corner_angle; })) {
      continue;
    }
    for (const double at : v) {
      const Point left = surface.normal(seam ? domain.hi : knot.value, at, {Side::left, Side::right});
      const Point right = surface.normal(knot.value, at, {Side::right, Side::right});
      worst = std::max(worst, angle_between(left, right));
    }
  }
  return worst;
}

double interpolation_error(const Surface& surface, std::span<const Curve> sections,
                           std::span<const double> parameters) {
  const SurfaceEvaluator evaluator(surface);
  Point gap(static_cast<std::size_t>(surface.dim()));
  Point point(gap.size());
  double worst = 0.0;
  for (std::size_t j = 0; j < sections.size(); ++j) {
    const Evaluator section(sections[j]);
    for (std::size_t i = 0; i < kProbes; ++i) {
      const double u = at_place(sections[j].domain(), i, kProbes);
      section.point(u, point);
      evaluator.point(u, parameters[j], gap);
      for (std::size_t c = 0; c < gap.size(); ++c) gap[c] -= point[c];
      worst = std::max(worst, scaled_norm(gap));
    }
  }
  return worst / surface.extent();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
