#include "tandem/match/norm.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "match/vector.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace {

using detail::dot;

/// A pair is invalid for the elastic programme below this value: a little slack, so that tangents which are
/// merely perpendicular (a corner of 90 degrees, sampled) do not bar a match (spec C5).
constexpr double kElasticInvalid = -0.05;

/// The nodes or chords of one curve, as the norms see them.
struct Sites {
  const Points* tangents = nullptr;
  Points points;
  std::vector<bool> still;  ///< carries no tangent cost
  std::vector<double> curvatures;

  [[nodiscard]] std::size_t size() const { return tangents->size(); }
};

Sites node_sites(const Samples& s) {
  Sites sites{&s.tangents_out, s.positions, std::vector<bool>(s.size()), {}};
  for (std::size_t i = 0; i < s.size(); ++i) {
    // Spec C18. The tolerance is rounding of a speed that is meant to be 0, relative to size / domain.
    sites.still[i] = s.speeds[i] <= 1e-12 || detail::largest(s.tangents_out[i]) == 0.0;
    sites.curvatures.push_back(s.curvatures[std::min(i, s.chords() - 1)]);
  }
  return sites;
}

Sites chord_sites(const Samples& s) {
  Sites sites{&s.chord_tangents, Points(s.dim(), s.chords()), std::vector<bool>(s.chords()), s.curvatures};
  for (std::size_t k = 0; k < s.chords(); ++k) {
    const auto from = s.positions[k];
    const auto to = s.positions[(k + 1) % s.size()];
    for (std::size_t c = 0; c < from.size(); ++c) sites.points[k][c] = 0.5 * from[c] + 0.5 * to[c];
    sites.still[k] = detail::largest(s.chord_tangents[k]) == 0.0;
  }
  return sites;
}

/// Difference of two curvatures in [0,1]: relative to both, and to the curvature of a circle, so that small
/// ones do not count as features.
double curvature_difference(double x, double y) {
  return std::fabs(x - y) / (std::fabs(x) + std::fabs(y) + 2.0 * std::numbers::pi);
}

struct TableOptions {
  double invalid_below = 0.0;
  double distance_unit = 1.0;
  RuledSign sign = RuledSign::product;
  FeatureOptions features;
};

NodeTable empty_table(const Sites& a, const Sites& b) {
  NodeTable table;
  table.rows = a.size();
  table.cols = b.size();
  table.cost.resize(table.rows * table.cols);
  table.invalid.resize(table.rows * table.cols);
  return table;
}

void add_curvature(NodeTable& table, const Sites& a, const Sites& b, const FeatureOptions& features) {
  if (!features.curvature) return;
  std::size_t k = 0;
  for (std::size_t i = 0; i < table.rows; ++i) {
    for (std::size_t j = 0; j < table.cols; ++j, ++k) {
      table.cost[k] += features.curvature_weight * curvature_difference(a.curvatures[i], b.curvatures[j]);
    }
  }
}

/// The sites relative to the curve's centre (the mean over its chords' lengths), in units of the radius of
/// gyration about it.
Points normalized(Points points, const Samples& s) {
  const auto dim = static_cast<std::size_t>(points.dim());
  // Halves, so that the difference of two huge coordinates stays finite.
  Point center(dim, 0.0);
  for (std::size_t k = 0; k < s.chords(); ++k) {
    const auto from = s.positions[k];
    const auto to = s.positions[(k + 1) % s.size()];
    for (std::size_t c = 0; c < dim; ++c) center[c] += s.chord_lengths[k] * (0.25 * from[c] + 0.25 * to[c]);
  }
  double largest = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t c = 0; c < dim; ++c) points[k][c] = 0.5 * points[k][c] - center[c];
    largest = std::max(largest, detail::largest(points[k]));
  }
  if (!(largest > 0.0)) return points;
  for (double& x : points.data()) x /= largest;
  double sum = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double length = s.chord_lengths[std::min(k, s.chords() - 1)];
    sum += length * dot(points[k], points[k]);
  }
  const double radius = std::sqrt(sum);
  for (double& x : points.data()) x /= radius;
  return points;
}

/// The points' coordinates, each in a plane of its own, so that a row of a table is one loop over lanes.
class Planes {
 public:
  explicit Planes(const Points& points) : size_(points.size()) {
    const auto dim = static_cast<std::size_t>(points.dim());
    values_.resize(dim * size_);
    for (std::size_t j = 0; j < size_; ++j) {
      for (std::size_t c = 0; c < dim; ++c) values_[c * size_ + j] = points[j][c];
    }
  }
  [[nodiscard]] double* operator[](std::size_t c) { return values_.data() + c * size_; }
  [[nodiscard]] const double* operator[](std::size_t c) const { return values_.data() + c * size_; }

 private:
  std::size_t size_;
  std::vector<double> values_;
};

void add_positions(NodeTable& table, const Points& a, const Points& b, double weight) {
  const std::size_t cols = table.cols;
  const Planes planes(b);
  std::vector<double> sums(cols);
  for (std::size_t i = 0; i < table.rows; ++i) {
    std::fill(sums.begin(), sums.end(), 0.0);
    for (std::size_t c = 0; c < a[i].size(); ++c) {
      const double x = a[i][c];
      const double* plane = planes[c];
      for (std::size_t j = 0; j < cols; ++j) sums[j] += (x - plane[j]) * (x - plane[j]);
    }
    double* cost = table.cost.data() + table.index(i, 0);
    for (std::size_t j = 0; j < cols; ++j) cost[j] += weight * sums[j];
  }
}

/// Fills a table from value(i, j), which returns a NormValue.
template <class Value>
NodeTable fill_table(const Sites& a, const Sites& b, const FeatureOptions& features, const Value& value) {
  NodeTable table = empty_table(a, b);
  std::size_t k = 0;
  for (std::size_t i = 0; i < table.rows; ++i) {
    for (std::size_t j = 0; j < table.cols; ++j, ++k) {
      const NormValue v = value(i, j);
      table.cost[k] = v.cost;
      table.invalid[k] = v.invalid ? 1 : 0;
    }
  }
  add_curvature(table, a, b, features);
  return table;
}

/// sums[j] = <x, plane point j>.
void dot_row(std::span<const double> x, const Planes& planes, std::span<double> sums) {
  std::fill(sums.begin(), sums.end(), 0.0);
  for (std::size_t c = 0; c < x.size(); ++c) {
    const double* plane = planes[c];
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += x[c] * plane[j];
  }
}

/// A table from rows of values whose best is 1: fill_row(i, values).
template <class FillRow>
NodeTable table_of_rows(const Sites& a, const Sites& b, const TableOptions& options,
                        const FillRow& fill_row) {
  NodeTable table = empty_table(a, b);
  const double limit = options.invalid_below;
  for (std::size_t i = 0; i < table.rows; ++i) {
    if (a.still[i]) continue;
    double* cost = table.cost.data() + table.index(i, 0);
    std::uint8_t* invalid = table.invalid.data() + table.index(i, 0);
    fill_row(i, std::span<double>(cost, table.cols));
    for (std::size_t j = 0; j < table.cols; ++j) {
      invalid[j] = cost[j] < limit;
      // Rounding may lift a product of unit vectors above 1.
      cost[j] = cost[j] < 1.0 ? 1.0 - cost[j] : 0.0;
    }
  }
  for (std::size_t j = 0; j < table.cols; ++j) {
    if (!b.still[j]) continue;
    for (std::size_t i = 0; i < table.rows; ++i) {
      table.cost[table.index(i, j)] = 0.0;
      table.invalid[table.index(i, j)] = 0;
    }
  }
  add_curvature(table, a, b, options.features);
  return table;
}

/// <T1,T2> of all pairs.
NodeTable tangent_table(const Sites& a, const Sites& b, const TableOptions& options) {
  const Planes tangents(*b.tangents);
  return table_of_rows(a, b, options, [&](std::size_t i, std::span<double> values) {
    dot_row((*a.tangents)[i], tangents, values);
  });
}

/// Both clouds times one power of two, which is exact, so that their coordinates are below 1: squares of
/// differences neither overflow nor vanish.
void scale_to_unit(Points& a, Points& b) {
  const double most = std::max(detail::largest(a.data()), detail::largest(b.data()));
  if (!(most > 0.0)) return;
  const int exponent = -1 - std::ilogb(most);
  for (Points* points : {&a, &b}) {
    for (double& x : points->data()) x = std::scalbn(x, exponent);
  }
}

/// Unit vectors from a point to all of b, in `to`; zero where they coincide.
void directions(std::span<const double> from, const Planes& b, std::span<double> lengths, Planes& to) {
  std::fill(lengths.begin(), lengths.end(), 0.0);
  for (std::size_t c = 0; c < from.size(); ++c) {
    const double* plane = b[c];
    double* d = to[c];
    for (std::size_t j = 0; j < lengths.size(); ++j) {
      d[j] = plane[j] - from[c];
      lengths[j] += d[j] * d[j];
    }
  }
  for (double& length : lengths) length = std::sqrt(length);
  for (std::size_t c = 0; c < from.size(); ++c) {
    double* d = to[c];
    for (std::size_t j = 0; j < lengths.size(); ++j) d[j] = lengths[j] > 0.0 ? d[j] / lengths[j] : 0.0;
  }
}

/// [C] eqs. (4), (6) in any dimension, on values that hold <T1,T2>: <T1,T2> - <T1,d><T2,d> with unit d; d =
/// 0: <T1,T2> (spec C13). along: workspace.
void ruled_product(std::span<const double> t1, const Planes& t2, const Planes& d, std::span<double> along,
                   std::span<double> values) {
  const std::size_t cols = values.size();
  dot_row(t1, d, along);
  for (std::size_t c = 0; c < t1.size(); ++c) {
    const double* own = t2[c];
    const double* plane = d[c];
    for (std::size_t j = 0; j < cols; ++j) values[j] -= along[j] * own[j] * plane[j];
  }
}

/// The signed test: the product where both sides agree with the sign, else the worse of the two (spec C13);
/// values as above.
void ruled_signed(std::span<const double> t1, const Planes& t2, const Planes& d,
                  std::span<const double> lengths, double sign, std::span<double> values) {
  const double x1 = sign * t1[0];
  const double y1 = sign * t1[1];
  const double* x2 = t2[0];
  const double* y2 = t2[1];
  const double* dx = d[0];
  const double* dy = d[1];
  for (std::size_t j = 0; j < values.size(); ++j) {
    const double first = dx[j] * y1 - dy[j] * x1;
    const double second = sign * (dx[j] * y2[j] - dy[j] * x2[j]);
    const double worse = std::min(first, second);
    const double value = worse >= 0.0 ? first * second : worse;
    values[j] = lengths[j] > 0.0 ? value : values[j];
  }
}

NodeTable ruled_table(const Sites& a, const Sites& b, const TableOptions& options) {
  const bool by_sign = options.sign != RuledSign::product && a.tangents->dim() == 2;
  const double sign = options.sign == RuledSign::negative ? -1.0 : 1.0;
  Points from = a.points;
  Points to = b.points;
  scale_to_unit(from, to);
  const Planes tangents(*b.tangents);
  const Planes points(to);
  Planes d(to);
  std::vector<double> lengths(b.size());
  std::vector<double> along(b.size());
  return table_of_rows(a, b, options, [&](std::size_t i, std::span<double> values) {
    const auto t1 = (*a.tangents)[i];
    dot_row(t1, tangents, values);
    directions(from[i], points, lengths, d);
    if (by_sign) {
      ruled_signed(t1, tangents, d, lengths, sign, values);
    } else {
      ruled_product(t1, tangents, d, along, values);
    }
  });
}

NodeTable distance_table(const Sites& a, const Sites& b, const TableOptions& options) {
  return fill_table(a, b, options.features, [&](std::size_t i, std::size_t j) {
    return NormValue{detail::distance(a.points[i], b.points[j]) / options.distance_unit, false};
  });
}

NodeTable user_table(const Sites& a, const Sites& b, const UserNorm& norm, const TableOptions& options) {
  return fill_table(a, b, options.features, [&](std::size_t i, std::size_t j) {
    const NormValue v = norm({(*a.tangents)[i], (*b.tangents)[j], a.points[i], b.points[j]});
    if (!(v.cost >= 0.0) || !std::isfinite(v.cost)) {
      throw InvalidArgument("the user's norm returned " + std::to_string(v.cost) + " for samples " +
                            std::to_string(i) + " and " + std::to_string(j) +
                            "; expected a finite cost >= 0");
    }
    return v;
  });
}

NodeTable norm_table(const Sites& a, const Sites& b, const Norm& norm, const TableOptions& options) {
  if (a.tangents->dim() != b.tangents->dim()) {
    throw InvalidArgument("the curves have different dimensions: " + std::to_string(a.tangents->dim()) +
                          " and " + std::to_string(b.tangents->dim()));
  }
  if (const auto* user = std::get_if<UserNorm>(&norm)) return user_table(a, b, *user, options);
  switch (std::get<NormKind>(norm)) {
    case NormKind::ruled:
      return ruled_table(a, b, options);
    case NormKind::distance:
    case NormKind::bottleneck:
      return distance_table(a, b, options);
    case NormKind::tangent:
      break;
  }
  return tangent_table(a, b, options);
}

NodeTable make_table(const Samples& a, const Samples& b, Sites sites_a, Sites sites_b, const Norm& norm,
                     const TableOptions& options) {
  NodeTable table = norm_table(sites_a, sites_b, norm, options);
  if (options.features.position_weight > 0.0) {
    add_positions(table, normalized(std::move(sites_a.points), a), normalized(std::move(sites_b.points), b),
                  options.features.position_weight);
  }
  if (options.features.lenient) std::fill(table.invalid.begin(), table.invalid.end(), std::uint8_t{0});
  return table;
}

}  // namespace

NodeTable node_costs(const Samples& a, const Samples& b, const Norm& norm, const FeatureOptions& features,
                     RuledSign sign) {
  NodeTable table = make_table(a, b, node_sites(a), node_sites(b), norm, {0.0, 1.0, sign, features});
  for (std::size_t k = 0; k < table.cost.size(); ++k)
    table.cost[k] = table.invalid[k] != 0 ? 0.0 : table.cost[k];
  return table;
}

NodeTable chord_costs(const Samples& a, const Samples& b, const Norm& norm, const FeatureOptions& features,
                      RuledSign sign) {
  const double unit = 0.5 * a.length + 0.5 * b.length;
  return make_table(a, b, chord_sites(a), chord_sites(b), norm, {kElasticInvalid, unit, sign, features});
}

}  // namespace v0
}  // namespace tandem
