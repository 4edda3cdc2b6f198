#include "rank/direction_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "shape/trigonometry.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

constexpr std::size_t kBinCount = 128;
constexpr double kDegreesPerBin = 360.0 / static_cast<double>(kBinCount);
/// In bins: a direction on the border of two may be counted to either by rounding.
constexpr double kBorder = 1e-6;
/// Tangents rounded to float are not quite of length 1, and fast programmes round their costs.
constexpr double kRounding = 2e-6;

/// Directions of the borders between the bins of the first octant.
std::vector<CosSin> first_octant() {
  std::vector<CosSin> borders;
  for (std::size_t k = 0; k <= kBinCount / 8; ++k)
    borders.push_back(cos_sin_degrees(kDegreesPerBin * static_cast<double>(k)));
  return borders;
}

/// The bin of a direction, counted counter-clockwise from the first axis, without library trigonometry.
std::size_t bin_of(double x, double y) {
  static const std::vector<CosSin> borders = first_octant();
  constexpr std::size_t kQuarter = kBinCount / 4;
  std::size_t quarter = 0;
  if (y < 0.0 || (y == 0.0 && x < 0.0)) {
    x = -x;
    y = -y;
    quarter = 2;
  }
  if (x <= 0.0) {
    const double turned = -x;
    x = y;
    y = turned;
    ++quarter;
  }
  // Now 0 <= angle < 90; beyond 45 the bins are those of the first octant, mirrored.
  const bool beyond = y > x;
  if (beyond) std::swap(x, y);
  const auto above = std::partition_point(borders.begin() + 1, borders.end(), [&](const CosSin& border) {
    return border.cosine * y >= border.sine * x;
  });
  const std::size_t within =
      std::min<std::size_t>(static_cast<std::size_t>(above - borders.begin()) - 1, kBinCount / 8 - 1);
  return (quarter * kQuarter + (beyond ? kQuarter - 1 - within : within)) % kBinCount;
}

/// 1 - cos of (distance - slack) bins, not below 0.
double least_cost(double distance, double slack) {
  const double apart = std::max(0.0, distance - slack - kBorder);
  return 1.0 - cos_sin_degrees(apart * kDegreesPerBin).cosine;
}

}  // namespace

DirectionBound::DirectionBound(const TangentPlanes& tangents, std::span<const double> weights)
    : nodes_(static_cast<double>(tangents.size())) {
  static_assert(kBins == kBinCount);
  // Costs by distance in half bins: an unknown turn puts the directions half way between two bins.
  static const std::vector<double> fixed = [] {
    std::vector<double> table;
    for (std::size_t d = 0; d <= kBins / 2; ++d) table.push_back(least_cost(static_cast<double>(d), 1.0));
    return table;
  }();
  static const std::vector<double> turned = [] {
    std::vector<double> table;
    for (std::size_t d = 0; d <= kBins / 2; ++d)
      table.push_back(least_cost(static_cast<double>(d) - 0.5, 1.5));
    return table;
  }();
  for (std::size_t i = 0; i < tangents.size(); ++i)
    weight_[bin_of(tangents.planes[0][i], tangents.planes[1][i])] += weights[i];
  // Distance to the nearest bin that is not empty, by two sweeps round the circle.
  std::array<std::size_t, kBins> distance{};
  distance.fill(kBins);
  for (std::size_t lap = 0; lap < 2 * kBins; ++lap) {
    const std::size_t up = lap % kBins;
    const std::size_t down = kBins - 1 - up;
    const auto relax = [&](std::size_t bin, std::size_t neighbour) {
      if (weight_[bin] > 0.0) distance[bin] = 0;
      distance[bin] = std::min(distance[bin], distance[neighbour] + 1);
    };
    relax(up, (up + kBins - 1) % kBins);
    relax(down, (down + 1) % kBins);
  }
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const std::size_t d = std::min(distance[bin], kBins / 2);
    nearest_fixed_[bin] = fixed[d];
    nearest_turned_[bin] = turned[d];
  }
}

double DirectionBound::lower_bound(const DirectionBound& a, const DirectionBound& b,
                                   const CompareOptions& options) {
  // rows[r], columns[r]: a turned by r bins (and up to one more).
  std::array<double, kBins> rows{};
  std::array<double, kBins> columns{};
  const std::size_t turns = options.rotate ? kBins : 1;
  const Bins& near_b = options.rotate ? b.nearest_turned_ : b.nearest_fixed_;
  const Bins& near_a = options.rotate ? a.nearest_turned_ : a.nearest_fixed_;
  std::array<double, 2 * kBins> twice_b;
  std::array<double, 2 * kBins> twice_a;  // backwards: a turned by r bins is seen from b turned by -r
  for (std::size_t k = 0; k < 2 * kBins; ++k) {
    twice_b[k] = near_b[k % kBins];
    twice_a[k] = near_a[(2 * kBins - k) % kBins];
  }
  for (std::size_t p = 0; p < kBins; ++p) {
    const double weight_a = a.weight_[p];
    if (weight_a > 0.0) {
      for (std::size_t r = 0; r < turns; ++r) rows[r] += weight_a * twice_b[p + r];
    }
    const double weight_b = b.weight_[p];
    if (weight_b > 0.0) {
      const std::size_t first = (kBins - p) % kBins;
      for (std::size_t r = 0; r < turns; ++r) columns[r] += weight_b * twice_a[first + r];
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < turns; ++r) {
    double bound = 0.0;
    switch (options.cost) {
      case RankCost::symmetric:
        bound =
            (rows[r] + columns[r] + options.charge * std::fabs(a.nodes_ - b.nodes_)) / (a.nodes_ + b.nodes_);
        break;
      case RankCost::paper:
        bound = std::max(rows[r], columns[r]) / (0.5 * (a.nodes_ + b.nodes_));
        break;
      case RankCost::elastic:
        bound = 0.5 * (rows[r] + columns[r]);
        break;
    }
    least = std::min(least, bound);
  }
  return least - kRounding;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
