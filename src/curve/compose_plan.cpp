#include "curve/compose_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/increasing.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// A value this close to a knot of the outer curve, as a share of its domain, is that knot.
constexpr double kSameValue = 1e-12;
constexpr double kUlp = std::numeric_limits<double>::epsilon();

double tolerance_of(const std::vector<Break>& outer) {
  const double lo = outer.front().value;
  const double hi = outer.back().value;
  return kSameValue * (hi - lo) + 4.0 * kUlp * std::max(std::abs(lo), std::abs(hi));
}

// Values of the inner function at its breaks, inside the outer domain and increasing.
std::vector<double> break_values(const std::vector<Break>& outer, const Pieces& inner) {
  const auto stride = static_cast<std::size_t>(inner.stride);
  const auto value = [&](std::size_t piece, std::size_t i) {
    const double* b = inner[piece] + i * stride;
    return inner.rational ? b[0] / b[1] : b[0];
  };
  std::vector<double> values(inner.breaks.size());
  const std::size_t last = inner.size();
  for (std::size_t j = 0; j < last; ++j) values[j] = value(j, 0);
  values[last] = value(last - 1, static_cast<std::size_t>(inner.degree));

  const double whole = inner.breaks.back().value - inner.breaks.front().value;
  for (std::size_t j = 0; j < last; ++j) {
    // Breaks this close together may share a value by rounding.
    const bool tiny = inner.breaks[j + 1].value - inner.breaks[j].value <= kSameValue * whole;
    if (values[j + 1] > values[j] || (tiny && values[j + 1] == values[j])) continue;
    throw InvalidArgument(fmt::format("the inner function is not increasing: {} at {}, then {} at {}",
                                      values[j], inner.breaks[j].value, values[j + 1],
                                      inner.breaks[j + 1].value));
  }
  const Interval domain{outer.front().value, outer.back().value};
  const double slack = tolerance_of(outer);
  for (const std::size_t end : {std::size_t{0}, last}) {
    if (values[end] >= domain.lo - slack && values[end] <= domain.hi + slack) continue;
    throw InvalidArgument(
        fmt::format("the inner function is {} at {}, outside the outer curve's domain [{}, {}]", values[end],
                    inner.breaks[end].value, domain.lo, domain.hi));
  }
  for (double& v : values) v = domain.clamp(v);
  return values;
}

// For each break of the inner function the outer break that its value is, or -1; the value is set to it.
std::vector<std::ptrdiff_t> snap_values(const std::vector<Break>& outer, std::vector<double>& values) {
  std::vector<std::ptrdiff_t> knot(values.size(), -1);
  const double slack = tolerance_of(outer);
  std::size_t j = 0;
  for (std::size_t k = 0; k < outer.size(); ++k) {
    const double wanted = outer[k].value;
    while (j + 1 < values.size() && std::abs(values[j + 1] - wanted) <= std::abs(values[j] - wanted)) ++j;
    // Two outer knots may be near the same value: the first one has it then, the other keeps its inverse
    // image.
    if (knot[j] >= 0 || std::abs(values[j] - wanted) > slack) continue;
    knot[j] = static_cast<std::ptrdiff_t>(k);
    values[j] = wanted;
  }
  return knot;
}

// Local parameter in (0, 1) at which a piece of the inner function, from value a to b, has the value
// `wanted`.
double inverse(const Pieces& inner, std::size_t piece, double a, double b, double wanted) {
  if (inner.degree == 1 && !inner.rational) return (wanted - a) / (b - a);
  const auto order = static_cast<std::size_t>(inner.degree) + 1;
  // Zero of the Bernstein polynomial with coefficients w_i (v_i - wanted): no cancellation but the given one.
  std::vector<double> signed_values(order);
  std::vector<double> work(order);
  const double* c = inner[piece];
  for (std::size_t i = 0; i < order; ++i) {
    signed_values[i] = inner.rational ? c[2 * i + 1] * (c[2 * i] / c[2 * i + 1] - wanted) : c[i] - wanted;
  }
  double lo = 0.0;
  double hi = 1.0;
  double x = (wanted - a) / (b - a);
  for (int step = 0; step < 200; ++step) {
    work = signed_values;
    for (std::size_t level = order - 1; level > 1; --level) {
      for (std::size_t i = 0; i < level; ++i) work[i] = (1.0 - x) * work[i] + x * work[i + 1];
    }
    const double value = (1.0 - x) * work[0] + x * work[1];
    const double slope = static_cast<double>(inner.degree) * (work[1] - work[0]);
    if (value == 0.0) break;
    (value > 0.0 ? hi : lo) = x;
    double next = x - value / slope;
    if (!(lo < next && next < hi)) next = 0.5 * (lo + hi);
    if (next <= lo || next >= hi || next == x) break;
    // The last Newton step is below the rounding of x: take it and be done.
    const bool settled = std::abs(next - x) <= kUlp * x;
    x = next;
    if (settled) break;
  }
  return x;
}

int smoothness_at(int degree, int multiplicity) {
  return std::max(0, degree - multiplicity);
}

}  // namespace

std::vector<Cut> plan_cuts(int outer_degree, const std::vector<Break>& outer, const Pieces& inner) {
  check_increasing(inner, tolerance_of(outer));
  std::vector<double> values = break_values(outer, inner);
  const std::vector<std::ptrdiff_t> knot = snap_values(outer, values);

  std::vector<Cut> cuts;
  cuts.reserve(inner.breaks.size() + outer.size());
  std::size_t piece = 0;       // of the outer curve
  bool forced_corner = false;  // the next break of the inner function took over an outer knot just before it
  for (std::size_t j = 0; j < inner.breaks.size(); ++j) {
    const bool end = j == inner.size();
    const double value = values[j];
    while (piece + 2 < outer.size() && outer[piece + 1].value <= value) ++piece;
    Cut cut{inner.breaks[j].value,
            value,
            value,
            smoothness_at(inner.degree, inner.breaks[j].multiplicity),
            j,
            piece};
    if (knot[j] >= 0) {
      const Break& coincident = outer[static_cast<std::size_t>(knot[j])];
      cut.smoothness = std::min(cut.smoothness, smoothness_at(outer_degree, coincident.multiplicity));
    }
    if (j == 0 || end || forced_corner) cut.smoothness = 0;
    forced_corner = false;
    cuts.push_back(cut);
    if (end) break;

    const double start = inner.breaks[j].value;
    const double stop = inner.breaks[j + 1].value;
    for (std::size_t k = piece + 1; k + 1 < outer.size() && outer[k].value < values[j + 1]; ++k) {
      if (outer[k].value <= value) continue;
      const double x = inverse(inner, j, value, values[j + 1], outer[k].value);
      const double u = start + x * (stop - start);
      piece = k;
      if (u > cuts.back().u && u < stop) {
        cuts.push_back(
            {u, outer[k].value, outer[k].value, smoothness_at(outer_degree, outer[k].multiplicity), j, k});
      } else if (u <= cuts.back().u) {
        // Too close to the cut before to be told apart: that becomes a corner which jumps over the knot.
        cuts.back().after = outer[k].value;
        cuts.back().outer = k;
        cuts.back().smoothness = 0;
      } else {
        values[j + 1] = outer[k].value;
        forced_corner = true;
        break;
      }
    }
  }
  return cuts;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
