#include "tandem/surface/loft.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "curve/check_spline.h"
#include "curve/norm.h"
#include "surface/check_loft.h"
#include "surface/loft_rows.h"
#include "tandem/curve/compatible.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::kHighestDegree;
// Neighbours nearer than this share of the size of all are one section: their distance would be rounding, and
// its ratio to the other distances is how unevenly the surface would be spaced.
constexpr double kCoincident = 1e-9;

// Sections in one function space, as lines of numbers: coordinates, or premultiplied ones with the weight.
struct Lines {
  std::vector<Curve> sections;
  bool homogeneous = false;

  [[nodiscard]] const Curve& first() const { return sections.front(); }
  [[nodiscard]] std::size_t stride() const {
    return static_cast<std::size_t>(first().dim()) + (homogeneous ? 1 : 0);
  }
};

bool same_weights(std::span<const Curve> sections) {
  return std::all_of(sections.begin(), sections.end(),
                     [&](const Curve& c) { return c.weights() == sections.front().weights(); });
}

// Weights count up to a common factor: without it, those of different sections are alike.
Curve with_mean_weight_one(const Curve& curve) {
  std::vector<double> weights = curve.weights();
  double mean = 0.0;
  for (const double w : weights) mean += w / static_cast<double>(weights.size());
  for (double& w : weights) w /= mean;
  return Curve(curve.degree(), curve.knots(), curve.control_points(), std::move(weights));
}

Lines in_one_space(std::span<const Curve> sections) {
  std::vector<Curve> compatible = make_compatible(sections);
  if (!compatible.front().is_rational()) return {std::move(compatible), false};
  const auto n = static_cast<long>(sections.size());
  if (same_weights(compatible) || n * compatible.front().degree() <= kHighestDegree) {
    return {with_common_denominator(sections), false};
  }
  for (Curve& curve : compatible) curve = with_mean_weight_one(curve);
  return {std::move(compatible), true};
}

Points to_rows(const Lines& lines) {
  const std::size_t m = lines.first().size();
  const std::size_t stride = lines.stride();
  Points rows(static_cast<int>(m * stride), lines.sections.size());
  for (std::size_t j = 0; j < rows.size(); ++j) {
    const Curve& section = lines.sections[j];
    for (std::size_t i = 0; i < m; ++i) {
      double* out = rows[j].data() + i * stride;
      const double w = lines.homogeneous ? section.weights()[i] : 1.0;
      const auto from = section.control_points()[i];
      for (std::size_t c = 0; c < from.size(); ++c) out[c] = w * from[c];
      if (lines.homogeneous) out[from.size()] = w;
    }
  }
  return rows;
}

Surface to_surface(const Lines& lines, const Curve& across) {
  const Curve& first = lines.first();
  const std::size_t m = first.size();
  const std::size_t n = across.size();
  const std::size_t stride = lines.stride();
  const auto dim = static_cast<std::size_t>(first.dim());
  Points points(first.dim(), m * n);
  std::vector<double> weights(first.is_rational() ? m * n : 0);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double* from = across.control_points()[j].data() + i * stride;
      const double w = lines.homogeneous ? from[dim] : 1.0;
      if (!(w > 0.0)) {
        throw InvalidArgument(
            "the weights change too much from section to section for a surface of this degree along v; "
            "expected more sections, or degree 1");
      }
      for (std::size_t c = 0; c < dim; ++c) points[i * n + j][c] = from[c] / w;
      if (first.is_rational()) weights[i * n + j] = lines.homogeneous ? w : first.weights()[i];
    }
  }
  return Surface({first.degree(), across.degree()}, {first.knots(), across.knots()}, std::move(points),
                 std::move(weights));
}

// Mean distances of neighbouring sections' control points, each to the power that the options ask for.
std::vector<double> steps(std::span<const Curve> sections, const LoftOptions& options) {
  double extent = 0.0;
  for (const Curve& curve : sections) extent = std::max(extent, curve.extent());
  const std::size_t n = sections.size();
  std::vector<double> steps;
  for (std::size_t j = 0; j + (options.closed ? 0 : 1) < n; ++j) {
    const std::size_t next = (j + 1) % n;
    const double distance = detail::mean_distance(sections[j].control_points(), sections[next].control_points());
    if (!(distance > kCoincident * extent)) {
      throw InvalidArgument(fmt::format("sections {} and {} coincide, expected distinct neighbours", j, next));
    }
    steps.push_back(options.parameters == LoftParameters::chord         ? distance
                    : options.parameters == LoftParameters::centripetal ? std::sqrt(distance)
                                                                        : 1.0);
  }
  return steps;
}

// Running sums as shares of the whole; of a closed loft the end, 1, is left out.
std::vector<double> parameters_of(const std::vector<double>& steps, bool closed) {
  // Scaled first, so that huge distances do not overflow as they add up.
  const double largest = *std::max_element(steps.begin(), steps.end());
  std::vector<double> v{0.0};
  for (const double step : steps) v.push_back(v.back() + step / largest);
  const double whole = v.back();
  for (double& x : v) x /= whole;
  v.back() = 1.0;
  if (closed) v.pop_back();
  return v;
}

double diagonal_of_all(std::span<const Curve> sections) {
  double largest = 0.0;
  Points all(sections.front().dim(), 0);
  for (const Curve& curve : sections) {
    for (std::size_t i = 0; i < curve.size(); ++i) all.push_back(curve.control_points()[i]);
    largest = std::max(largest, curve.extent());
  }
  return std::max(largest, detail::box_diagonal(all));
}

// The farthest that any section's control point lies from where the surface has it.
double deviation_of(const Lines& lines, const Points& rows, std::span<const double> v, const Curve& across) {
  const std::size_t stride = lines.stride();
  const auto dim = static_cast<std::size_t>(lines.first().dim());
  double worst = 0.0;
  for (std::size_t j = 0; j < v.size(); ++j) {
    const Point found = across.evaluate(v[j]);
    for (std::size_t i = 0; i < rows[j].size(); i += stride) {
      Point gap(dim);
      const double w0 = lines.homogeneous ? rows[j][i + dim] : 1.0;
      const double w1 = lines.homogeneous ? found[i + dim] : 1.0;
      for (std::size_t c = 0; c < dim; ++c) gap[c] = rows[j][i + c] / w0 - found[i + c] / w1;
      worst = std::max(worst, detail::scaled_norm(gap));
    }
  }
  return worst;
}

// More and more rows until the sections are met.
Curve within_tolerance(const Lines& lines, const Points& rows, std::span<const double> v, int degree,
                       double tolerance) {
  for (std::size_t n = static_cast<std::size_t>(degree) + 1; n < rows.size(); ++n) {
    Curve across = detail::approximate_rows(rows, v, degree, n);
    if (deviation_of(lines, rows, v, across) <= tolerance) return across;
  }
  return detail::interpolate_rows(rows, v, degree);
}

}  // namespace

Loft loft(std::span<const Curve> sections, const LoftOptions& options) {
  const int degree = detail::check_loft(sections, options);
  const Lines lines = in_one_space(sections);
  std::vector<double> v = parameters_of(steps(lines.sections, options), options.closed);
  const Points rows = to_rows(lines);

  const auto make = [&]() -> Curve {
    if (options.closed) return detail::interpolate_loop(rows, v, degree);
    if (options.tolerance) {
      return within_tolerance(lines, rows, v, degree, *options.tolerance * diagonal_of_all(lines.sections));
    }
    if (options.rows && static_cast<std::size_t>(*options.rows) < rows.size()) {
      return detail::approximate_rows(rows, v, degree, static_cast<std::size_t>(*options.rows));
    }
    return detail::interpolate_rows(rows, v, degree);
  };
  const Curve across = make();
  const double deviation = deviation_of(lines, rows, v, across);
  return {to_surface(lines, across), std::move(v), deviation, !lines.homogeneous};
}

}  // namespace v0
}  // namespace tandem
