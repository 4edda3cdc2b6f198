#include "morph/contour_pairs.h"

#include <algorithm>
#include <cmath>

#include "morph/length_center.h"
#include "tandem/curve/arc_length.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/match/assignment.h"
#include "tandem/shape/measures.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Nodes of the matches that only tell which contours are alike.
constexpr int kSurveySamples = 32;
// What things are worth, in units of the mean cost of a match.
constexpr double kPositionWeight = 2.0;  // times the distance, as a share of the drawing
constexpr double kSizeWeight = 0.25;     // times the logarithm of the ratio of lengths
constexpr double kChildWeight = 0.3;     // per hole that is too many
// Solids, holes and strokes may be paired with one another when nothing else is left; open with closed ones.
constexpr double kOtherKind = 4.0;
// Per contour that is left over.
constexpr double kLonely = 1.0;

/// A drawing's contours as pairing sees them.
struct Drawing {
  std::vector<Curve> curves;
  std::vector<NestedContour> nesting;
  std::vector<std::size_t> child_counts;
  std::vector<Point> centers;
  std::vector<double> lengths;
  Point center;
  double size = 0.0;

  explicit Drawing(std::span<const CubicPath> paths)
      : nesting(find_nesting(paths, FillRule::nonzero)), child_counts(paths.size(), 0) {
    Box box;
    for (const CubicPath& path : paths) {
      curves.push_back(to_curve(path));
      const Box own = bounding_box(curves.back());
      centers.push_back(own.center());
      lengths.push_back(arc_length(curves.back(), 1e-4));
      box.include(own);
    }
    for (const NestedContour& contour : nesting) {
      if (contour.parent) ++child_counts[*contour.parent];
    }
    center = length_center(curves);
    size = box.diagonal();
  }

  [[nodiscard]] std::vector<std::size_t> children(std::optional<std::size_t> parent) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < nesting.size(); ++i) {
      if (nesting[i].parent == parent) found.push_back(i);
    }
    return found;
  }
};

class Pairing {
 public:
  Pairing(const Drawing& a, const Drawing& b, const Rotation& turn, const MatchOptions& options)
      : a_(a), b_(b), turn_(turn), options_(options), partner_(a.curves.size()) {
    options_.samples = {kSurveySamples, kSurveySamples};
    options_.rotation = turn.values();
    options_.progress = {};
    options_.features.lenient = true;
    // What segments cost depends on the size, and is not to be weighed against distances.
    if (options_.method == Method::segments) options_.method = Method::elastic;
  }

  std::vector<std::optional<std::size_t>> run() {
    pair_up({}, {});
    return partner_;
  }
  /// Of the pairs that run() made.
  [[nodiscard]] double cost() const noexcept { return cost_; }

 private:
  void pair_up(std::optional<std::size_t> parent_a, std::optional<std::size_t> parent_b) {
    const std::vector<std::size_t> rows = a_.children(parent_a);
    const std::vector<std::size_t> columns = b_.children(parent_b);
    if (rows.empty() || columns.empty()) return;
    std::vector<double> costs;
    for (const std::size_t i : rows) {
      for (const std::size_t j : columns) costs.push_back(cost(i, j));
    }
    const auto assigned = assign(costs, rows.size(), columns.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (!assigned[r]) continue;
      const std::size_t j = columns[*assigned[r]];
      partner_[rows[r]] = j;
      cost_ += costs[r * columns.size() + *assigned[r]];
      pair_up(rows[r], j);
    }
  }

  [[nodiscard]] double cost(std::size_t i, std::size_t j) const {
    const Curve& a = a_.curves[i];
    const Curve& b = b_.curves[j];
    MatchOptions own = options_;
    if (a.is_closed() && b.is_closed()) own.direction = Direction::forward;
    double sum = survey(a, b, own);
    // Where j's centre would lie in the first drawing.
    std::vector<double> place(2);
    for (std::size_t c = 0; c < 2; ++c)
      place[c] = (b_.centers[j][c] - b_.center[c]) / std::max(b_.size, kTiny);
    turn_.inverse().apply(place, place);
    double square = 0.0;
    for (std::size_t c = 0; c < 2; ++c) {
      const double d = (a_.centers[i][c] - a_.center[c]) / std::max(a_.size, kTiny) - place[c];
      square += d * d;
    }
    sum += kPositionWeight * std::sqrt(square);
    if (a_.lengths[i] > 0.0 && b_.lengths[j] > 0.0) {
      sum += kSizeWeight * std::fabs(std::log(a_.lengths[i] / b_.lengths[j] * (b_.size / a_.size)));
    }
    const double more = static_cast<double>(a_.child_counts[i]) - static_cast<double>(b_.child_counts[j]);
    sum += kChildWeight * std::fabs(more);
    if (a_.nesting[i].role != b_.nesting[j].role) sum += kOtherKind;
    return sum;
  }

  static double survey(const Curve& a, const Curve& b, const MatchOptions& options) {
    if (!(a.extent() > 0.0 && b.extent() > 0.0)) return 1.0;
    return match(a, b, options).report.mean_cost;
  }

  static constexpr double kTiny = 1e-300;
  const Drawing& a_;
  const Drawing& b_;
  const Rotation& turn_;
  MatchOptions options_;
  std::vector<std::optional<std::size_t>> partner_;
  double cost_ = 0.0;
};

}  // namespace

ContourPairing pair_contours(std::span<const CubicPath> a, std::span<const CubicPath> b, const Rotation& turn,
                             const MatchOptions& options) {
  if (a.size() == 1 && b.size() == 1) return {{{std::size_t{0}, std::size_t{0}}}, 0.0};
  const Drawing first(a);
  const Drawing second(b);
  Pairing pairing(first, second, turn, options);
  const std::vector<std::optional<std::size_t>> partner = pairing.run();
  ContourPairing found{{}, pairing.cost()};
  std::vector<bool> taken(b.size(), false);
  for (std::size_t i = 0; i < a.size(); ++i) {
    found.pairs.push_back({i, partner[i]});
    if (partner[i]) {
      taken[*partner[i]] = true;
    } else {
      found.cost += kLonely;
    }
  }
  for (std::size_t j = 0; j < b.size(); ++j) {
    if (taken[j]) continue;
    found.pairs.push_back({{}, j});
    found.cost += kLonely;
  }
  return found;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
