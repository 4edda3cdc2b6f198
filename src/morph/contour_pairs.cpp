#include "morph/contour_pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "morph/drawing_mirror.h"
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
// What it is worth to keep one of the axes of symmetry that both drawings have: as much as a contour, and
// more than any distance between a contour and its neighbour.
constexpr double kLopsided = 1.0;
// Axes of two drawings are parallel within this angle, in degrees.
constexpr double kParallel = 2.0;

/// A drawing's contours as pairing sees them.
struct Drawing {
  std::vector<Curve> curves;
  std::vector<NestedContour> nesting;
  std::vector<std::size_t> child_counts;
  std::vector<Point> centers;
  std::vector<double> lengths;
  std::vector<DrawingMirror> mirrors;
  Point center;
  double size = 0.0;

  explicit Drawing(std::span<const CubicPath> paths)
      : nesting(find_nesting(paths, FillRule::nonzero)),
        child_counts(paths.size(), 0),
        mirrors(find_drawing_mirrors(paths)) {
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

/// An axis that both drawings have: the mirror images of their contours.
struct CommonMirror {
  const std::vector<std::size_t>& of_a;
  const std::vector<std::size_t>& of_b;
};

/// Who becomes whom, and what that costs.
struct Partners {
  std::vector<std::optional<std::size_t>> of_a;
  double cost = 0.0;
  std::size_t lonely = 0;  ///< of both drawings, without a partner

  // Whether the mirror image of each contour becomes the mirror image of what the contour becomes.
  [[nodiscard]] bool keeps(const CommonMirror& mirror) const {
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      const std::optional<std::size_t> image = of_a[mirror.of_a[i]];
      if (of_a[i].has_value() != image.has_value()) return false;
      if (image && *image != mirror.of_b[*of_a[i]]) return false;
    }
    return true;
  }
};

class Pairing {
 public:
  Pairing(const Drawing& a, const Drawing& b, const Rotation& turn, const MatchOptions& options)
      : a_(a), b_(b), turn_(turn), options_(options) {
    options_.samples = {kSurveySamples, kSurveySamples};
    options_.rotation = turn.values();
    progress_ = std::exchange(options_.progress, {});
    options_.features.lenient = true;
    // What segments cost depends on the size, and is not to be weighed against distances.
    if (options_.method == Method::segments) options_.method = Method::elastic;
  }

  // The cheapest, or one that costs little more, leaves no more contours alone, and keeps an axis of
  // symmetry.
  Partners run() {
    Partners best = none();
    pair_up({}, {}, best);
    add_lonely(best);
    const std::vector<CommonMirror> mirrors = common_mirrors();
    const auto kept = [&](const CommonMirror& mirror) { return best.keeps(mirror); };
    if (mirrors.empty() || std::any_of(mirrors.begin(), mirrors.end(), kept)) return best;
    double most = best.cost + kLopsided;
    for (const CommonMirror& mirror : mirrors) {
      Partners even = none();
      pair_evenly({}, {}, mirror, even);
      add_lonely(even);
      if (even.lonely > best.lonely || !(even.cost < most)) continue;
      most = even.cost;
      best = std::move(even);
    }
    return best;
  }

  /// 0 once the caller wants to stop, who then looks at nothing that comes of it.
  double known_cost(std::size_t i, std::size_t j) {
    stopped_ = stopped_ || (progress_ && !progress_(0.0));
    if (stopped_) return 0.0;
    const auto known = costs_.find({i, j});
    return known != costs_.end() ? known->second : costs_.emplace(std::pair{i, j}, cost(i, j)).first->second;
  }

 private:
  using Members = std::vector<std::size_t>;

  [[nodiscard]] Partners none() const { return {std::vector<std::optional<std::size_t>>(a_.curves.size())}; }

  void add_lonely(Partners& partners) const {
    std::size_t pairs = 0;
    for (const auto& partner : partners.of_a) pairs += partner ? 1 : 0;
    partners.lonely = a_.curves.size() + b_.curves.size() - 2 * pairs;
    partners.cost += kLonely * static_cast<double>(partners.lonely);
  }

  [[nodiscard]] std::vector<CommonMirror> common_mirrors() const {
    std::vector<CommonMirror> found;
    for (const DrawingMirror& p : a_.mirrors) {
      for (const DrawingMirror& q : b_.mirrors) {
        const double apart = q.degrees - turn_.degrees() - p.degrees;
        if (std::fabs(apart - 180.0 * std::round(apart / 180.0)) <= kParallel) {
          found.push_back({p.images, q.images});
        }
      }
    }
    return found;
  }

  void pair(std::size_t i, std::size_t j, Partners& partners) {
    partners.of_a[i] = j;
    partners.cost += known_cost(i, j);
  }

  void pair_up(std::optional<std::size_t> parent_a, std::optional<std::size_t> parent_b, Partners& partners) {
    const Members rows = a_.children(parent_a);
    const Members columns = b_.children(parent_b);
    if (rows.empty() || columns.empty()) return;
    std::vector<double> costs;
    for (const std::size_t i : rows) {
      for (const std::size_t j : columns) costs.push_back(known_cost(i, j));
    }
    const auto assigned = assign(costs, rows.size(), columns.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (!assigned[r]) continue;
      pair(rows[r], columns[*assigned[r]], partners);
      pair_up(rows[r], columns[*assigned[r]], partners);
    }
  }

  // The same where parents are their own mirror images: contours that are so, too, with such ones, and two
  // that are each other's with two such.
  void pair_evenly(std::optional<std::size_t> parent_a, std::optional<std::size_t> parent_b,
                   const CommonMirror& mirror, Partners& partners) {
    for (const bool alone : {true, false}) {
      // Of two, the first.
      const auto kind = [alone](Members members, const std::vector<std::size_t>& images) {
        members.erase(std::remove_if(members.begin(), members.end(),
                                     [&](std::size_t i) { return alone ? images[i] != i : images[i] <= i; }),
                      members.end());
        return members;
      };
      const Members rows = kind(a_.children(parent_a), mirror.of_a);
      const Members columns = kind(b_.children(parent_b), mirror.of_b);
      if (rows.empty() || columns.empty()) continue;
      std::vector<double> costs;
      std::vector<bool> crossed;  // the first with the other one
      for (const std::size_t i : rows) {
        for (const std::size_t j : columns) {
          const std::size_t of_i = mirror.of_a[i];
          const std::size_t of_j = mirror.of_b[j];
          const double straight = known_cost(i, j) + (alone ? 0.0 : known_cost(of_i, of_j));
          const double across = alone ? straight : known_cost(i, of_j) + known_cost(of_i, j);
          crossed.push_back(across < straight - kRounding);
          costs.push_back(std::min(straight, across));
        }
      }
      const auto assigned = assign(costs, rows.size(), columns.size());
      for (std::size_t r = 0; r < rows.size(); ++r) {
        if (!assigned[r]) continue;
        const std::size_t i = rows[r];
        const std::size_t first = columns[*assigned[r]];
        const std::size_t j = crossed[r * columns.size() + *assigned[r]] ? mirror.of_b[first] : first;
        pair(i, j, partners);
        if (alone) {
          pair_evenly(i, j, mirror, partners);
        } else {
          pair(mirror.of_a[i], mirror.of_b[j], partners);
          pair_up(i, j, partners);
          mirror_children(i, mirror, partners);
        }
      }
    }
  }

  // What lies in the mirror image of a contour becomes the mirror images of what its own becomes.
  void mirror_children(std::size_t parent, const CommonMirror& mirror, Partners& partners) {
    for (const std::size_t child : a_.children(parent)) {
      if (!partners.of_a[child]) continue;
      pair(mirror.of_a[child], mirror.of_b[*partners.of_a[child]], partners);
      mirror_children(child, mirror, partners);
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
  static constexpr double kRounding = 1e-9;  // so that it does not choose
  const Drawing& a_;
  const Drawing& b_;
  const Rotation& turn_;
  MatchOptions options_;
  Progress progress_;
  bool stopped_ = false;
  std::map<std::pair<std::size_t, std::size_t>, double> costs_;
};

}  // namespace

ContourPairing pair_contours(std::span<const CubicPath> a, std::span<const CubicPath> b, const Rotation& turn,
                             const MatchOptions& options) {
  if (a.size() == 1 && b.size() == 1) return {{{0, 0, 0.0}}, 0.0};
  const Drawing first(a);
  const Drawing second(b);
  Pairing pairing(first, second, turn, options);
  const Partners partners = pairing.run();
  ContourPairing found{{}, partners.cost};
  std::vector<bool> taken(b.size(), false);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::optional<std::size_t> j = partners.of_a[i];
    found.pairs.push_back({i, j, j ? pairing.known_cost(i, *j) : 0.0});
    if (j) taken[*j] = true;
  }
  for (std::size_t j = 0; j < b.size(); ++j) {
    if (!taken[j]) found.pairs.push_back({{}, j, 0.0});
  }
  return found;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
