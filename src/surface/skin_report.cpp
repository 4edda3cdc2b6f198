#include "surface/skin_report.h"

#include <algorithm>
#include <array>
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
constexpr int kPlaces = 512;
/// Speeds that differ by a smaller share make no crease that anybody sees.
constexpr double kSameSpeed = 1e-6;
/// Places per section at which the interpolation is checked.
constexpr int kProbes = 64;

double at_place(const Interval& domain, int i, int places) {
  return domain.lo + (i + 0.5) / places * domain.length();
}

double angle_between(std::span<const double> a, std::span<const double> b) {
  Point gap(a.size());
  for (std::size_t c = 0; c < a.size(); ++c) gap[c] = a[c] - b[c];
  // By the chord: the cosine knows no small angles.
  const double chord = std::min(1.0, 0.5 * scaled_norm(gap));
  return scaled_norm(a) == 0.0 || scaled_norm(b) == 0.0 ? 0.0 : 2.0 * std::asin(chord);
}

/// What a section does at a parameter.
struct Joint {
  double turn = 0.0;  ///< of its tangent, in radians
  double jump = 0.0;  ///< of its speed, as a share of the larger one
};

/// `seam`: from the end of its domain to the start.
Joint joint_at(const Curve& section, double u, bool seam) {
  const double before = seam ? section.domain().hi : u;
  Points rows[2] = {section.derivatives(before, 1, Side::left), section.derivatives(u, 1, Side::right)};
  double speeds[2];
  for (std::size_t side = 0; side < 2; ++side) {
    speeds[side] = scaled_norm(rows[side][1]);
    for (double& x : rows[side][1]) x = speeds[side] > 0.0 ? x / speeds[side] : 0.0;
  }
  const double larger = std::max(speeds[0], speeds[1]);
  return {angle_between(rows[0][1], rows[1][1]),
          larger > 0.0 ? std::abs(speeds[0] - speeds[1]) / larger : 0.0};
}

/// All sections' together: the largest turn, the largest jump.
Joint joint_at(std::span<const Curve> sections, double u, bool seam) {
  Joint worst;
  for (const Curve& section : sections) {
    const Joint own = joint_at(section, u, seam);
    worst = {std::max(worst.turn, own.turn), std::max(worst.jump, own.jump)};
  }
  return worst;
}

/// Places per span at which signs are looked at, for the middle of each share of a span.
constexpr int kSigns = 4;

/// The middles of parts of all spans, and how long the parts are.
std::vector<std::array<double, 2>> middles(const Surface& surface, Along along) {
  std::vector<std::array<double, 2>> result;
  double from = surface.domain(along).lo;
  for (const Knot& knot : distinct_knots(surface.knots(along))) {
    if (!(knot.value > from) || knot.value > surface.domain(along).hi) continue;
    const double part = (knot.value - from) / kSigns;
    for (int i = 0; i < kSigns; ++i) result.push_back({from + (i + 0.5) * part, part});
    from = knot.value;
  }
  return result;
}

}  // namespace

SectionLook look_at(const Curve& section) {
  const auto dim = static_cast<std::size_t>(section.dim());
  const Evaluator evaluator(section);
  SectionLook look{Points(section.dim(), kPlaces), std::vector<double>(kPlaces)};
  std::vector<double> rows(2 * dim);
  double mean = 0.0;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    evaluator.derivatives(at_place(section.domain(), static_cast<int>(i), kPlaces), 1, Side::right, rows);
    const std::span<const double> d(rows.data() + dim, dim);
    const double speed = scaled_norm(d);
    for (std::size_t c = 0; c < dim && speed > 0.0; ++c) look.tangents[i][c] = d[c] / speed;
    look.speeds[i] = speed;
    mean += speed / kPlaces;
  }
  for (double& x : look.speeds) x /= mean;
  return look;
}

PairCost cost_between(const SectionLook& a, const SectionLook& b, double lambda) {
  PairCost sum;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    const double speeds = a.speeds[i] + b.speeds[i];
    if (!(speeds > 0.0)) continue;
    double dot = 0.0;
    for (std::size_t c = 0; c < a.tangents[i].size(); ++c) dot += a.tangents[i][c] * b.tangents[i][c];
    const double difference = a.speeds[i] - b.speeds[i];
    sum.cost += ((1.0 - dot) * 0.5 * speeds + lambda * difference * difference / speeds) / kPlaces;
    if (!(dot > 0.0)) sum.invalid += 0.5 * speeds / kPlaces;
  }
  return sum;
}

Creases find_creases(const Surface& surface, std::span<const Curve> sections,
                     std::span<const double> parameters, double corner_angle) {
  if (surface.dim() != 3) return {};
  std::vector<double> v;
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const double next = j + 1 < parameters.size() ? parameters[j + 1] : surface.domain(Along::v).hi;
    v.push_back(parameters[j]);
    if (next > parameters[j])
      v.insert(v.end(), {0.75 * parameters[j] + 0.25 * next, 0.5 * parameters[j] + 0.5 * next});
  }
  const Interval domain = surface.domain(Along::u);
  Creases creases;
  for (const Knot& knot : distinct_knots(surface.knots(Along::u))) {
    const bool seam = knot.value == domain.lo && surface.is_closed(Along::u);
    const bool inside = domain.lo < knot.value && knot.value < domain.hi;
    if (!seam && !(inside && knot.multiplicity >= surface.degree(Along::u))) continue;
    const Joint joint = joint_at(sections, knot.value, seam);
    if (joint.turn > corner_angle) continue;
    double& worst = joint.jump > kSameSpeed ? creases.laws : creases.sections;
    for (const double at : v) {
      const Point left = surface.normal(seam ? domain.hi : knot.value, at, {Side::left, Side::right});
      const Point right = surface.normal(knot.value, at, {Side::right, Side::right});
      worst = std::max(worst, angle_between(left, right));
    }
  }
  return creases;
}

double wrong_sign_share(const Surface& surface) {
  if (surface.dim() != 2) return 0.0;
  double positive = 0.0;
  double negative = 0.0;
  for (const auto& [u, of_u] : middles(surface, Along::u)) {
    for (const auto& [v, of_v] : middles(surface, Along::v)) {
      const Points d = surface.derivatives(u, v, 1);
      const double jacobian = d[1][0] * d[2][1] - d[1][1] * d[2][0];
      (jacobian > 0.0 ? positive : negative) += std::abs(jacobian) * of_u * of_v;
    }
  }
  const double all = positive + negative;
  return all > 0.0 ? std::min(positive, negative) / all : 0.0;
}

double interpolation_error(const Surface& surface, std::span<const Curve> sections,
                           std::span<const double> parameters) {
  const SurfaceEvaluator evaluator(surface);
  Point gap(static_cast<std::size_t>(surface.dim()));
  Point point(gap.size());
  double worst = 0.0;
  for (std::size_t j = 0; j < sections.size(); ++j) {
    const Evaluator section(sections[j]);
    for (int i = 0; i < kProbes; ++i) {
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
