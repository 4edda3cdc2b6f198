#include "tandem/surface/edit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr Along across(Along along) {
  return along == Along::u ? Along::v : Along::u;
}

// The surface as one curve along a parameter, in the space of whole lines of control points: what is exact
// for curves is exact for surfaces. Rational ones with their coordinates premultiplied, the weight last, and
// the largest weight 1, since weights count up to a common factor only.
Curve sheaf(const Surface& surface, Along along) {
  const std::size_t n = surface.size(along);
  const std::size_t others = surface.size(across(along));
  const auto dim = static_cast<std::size_t>(surface.dim());
  const std::size_t stride = dim + (surface.is_rational() ? 1 : 0);
  const std::vector<double>& weights = surface.weights();
  const double largest = weights.empty() ? 1.0 : *std::max_element(weights.begin(), weights.end());
  Points lines(static_cast<int>(others * stride), n);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t o = 0; o < others; ++o) {
      const std::size_t at = along == Along::u ? k * others + o : o * n + k;
      const double w = weights.empty() ? 1.0 : weights[at] / largest;
      double* out = lines[k].data() + o * stride;
      for (std::size_t c = 0; c < dim; ++c) out[c] = w * surface.control_points()[at][c];
      if (!weights.empty()) out[dim] = w;
    }
  }
  return Curve(surface.degree(along), surface.knots(along), std::move(lines));
}

// Control points and weights of one line of a sheaf.
struct Line {
  Points points;
  std::vector<double> weights;
};

Line to_line(std::span<const double> line, int dim, bool rational) {
  const auto d = static_cast<std::size_t>(dim);
  const std::size_t stride = d + (rational ? 1 : 0);
  Line result{Points(dim, line.size() / stride), std::vector<double>(rational ? line.size() / stride : 0)};
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const double* from = line.data() + i * stride;
    const double w = rational ? from[d] : 1.0;
    for (std::size_t c = 0; c < d; ++c) result.points[i][c] = from[c] / w;
    if (rational) result.weights[i] = w;
  }
  return result;
}

Surface to_surface(const Curve& sheaf, Along along, const Surface& like) {
  const std::size_t n = sheaf.size();
  const std::size_t others = like.size(across(along));
  Points points(like.dim(), n * others);
  std::vector<double> weights(like.is_rational() ? points.size() : 0);
  for (std::size_t k = 0; k < n; ++k) {
    const Line line = to_line(sheaf.control_points()[k], like.dim(), like.is_rational());
    for (std::size_t o = 0; o < others; ++o) {
      const std::size_t at = along == Along::u ? k * others + o : o * n + k;
      std::copy(line.points[o].begin(), line.points[o].end(), points[at].begin());
      if (like.is_rational()) weights[at] = line.weights[o];
    }
  }
  if (along == Along::u) {
    return Surface({sheaf.degree(), like.degree(Along::v)}, {sheaf.knots(), like.knots(Along::v)},
                   std::move(points), std::move(weights));
  }
  return Surface({like.degree(Along::u), sheaf.degree()}, {like.knots(Along::u), sheaf.knots()},
                 std::move(points), std::move(weights));
}

// The surface after an exact change of all its curves along a parameter.
template <class Edit>
Surface edited(const Surface& surface, Along along, Edit edit) {
  return to_surface(edit(sheaf(surface, along)), along, surface);
}

}  // namespace

Curve iso_curve(const Surface& surface, Along along, double t) {
  const Point line = sheaf(surface, across(along)).evaluate(t);
  Line made = to_line(line, surface.dim(), surface.is_rational());
  return Curve(surface.degree(along), surface.knots(along), std::move(made.points), std::move(made.weights));
}

Surface insert_knot(const Surface& surface, Along along, double t, int times) {
  return edited(surface, along, [&](const Curve& c) { return insert_knot(c, t, times); });
}

Surface refine(const Surface& surface, Along along, std::span<const double> knots) {
  return edited(surface, along, [&](const Curve& c) { return refine(c, knots); });
}

Surface elevate_degree(const Surface& surface, Along along, int times) {
  return edited(surface, along, [&](const Curve& c) { return elevate_degree(c, times); });
}

Surface part_of(const Surface& surface, Along along, Interval part) {
  return edited(surface, along, [&](const Curve& c) { return subcurve(c, part); });
}

Surface clamp(const Surface& surface) {
  const auto clamp_curve = [](const Curve& c) { return clamp(c); };
  return edited(edited(surface, Along::u, clamp_curve), Along::v, clamp_curve);
}

Surface reverse(const Surface& surface, Along along) {
  return edited(surface, along, [](const Curve& c) { return reverse(c); });
}

Surface with_domain(const Surface& surface, Along along, Interval domain) {
  return edited(surface, along, [&](const Curve& c) { return with_domain(c, domain); });
}

Surface transpose(const Surface& surface) {
  const std::size_t m = surface.size(Along::u);
  const std::size_t n = surface.size(Along::v);
  Points points(surface.dim(), m * n);
  std::vector<double> weights(surface.weights().size());
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const auto from = surface.control_point(i, j);
      std::copy(from.begin(), from.end(), points[j * m + i].begin());
      if (surface.is_rational()) weights[j * m + i] = surface.weights()[i * n + j];
    }
  }
  return Surface({surface.degree(Along::v), surface.degree(Along::u)},
                 {surface.knots(Along::v), surface.knots(Along::u)}, std::move(points), std::move(weights));
}

BezierPatches bezier_patches(const Surface& surface) {
  BezierPatches result;
  for (const Curve& strip : bezier_segments(sheaf(surface, Along::u))) {
    const Surface row = to_surface(strip, Along::u, surface);
    ++result.rows;
    for (const Curve& patch : bezier_segments(sheaf(row, Along::v))) {
      result.patches.push_back(to_surface(patch, Along::v, row));
    }
  }
  result.columns = result.patches.size() / result.rows;
  return result;
}

}  // namespace v0
}  // namespace tandem
