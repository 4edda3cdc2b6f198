#include "tandem/morph/motion_morph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tandem/curve/compose.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// Nodes per motion: motions have more to put in step than outlines have, some cycles of all joints.
constexpr int kSamples = 300;
// Of v: C2, as splines of data are.
constexpr int kOrder = 4;
// Places that the spread of a coordinate is taken from.
constexpr int kSpreadSamples = 512;
// A coordinate that varies by less than this share of its size does not vary but for rounding.
constexpr double kConstant = 1e-12;
constexpr int kHalvings = 60;  // to the last bits

void check(std::span<const Curve> motions, const MotionOptions& options) {
  if (motions.size() < 2) {
    throw InvalidArgument(fmt::format("motions: {} motions, expected at least 2", motions.size()));
  }
  for (std::size_t i = 1; i < motions.size(); ++i) {
    if (motions[i].dim() == motions[0].dim()) continue;
    throw InvalidArgument(fmt::format("motions: motion {} has {} coordinates, expected {} as motion 0", i,
                                      motions[i].dim(), motions[0].dim()));
  }
  const auto dim = static_cast<std::size_t>(motions[0].dim());
  if (!options.weights.empty() && options.weights.size() != dim) {
    throw InvalidArgument(fmt::format("motions: {} weights, expected one for each of the {} coordinates",
                                      options.weights.size(), dim));
  }
  std::vector<double> weights = options.weights;
  weights.push_back(options.time_weight);
  for (const double weight : weights) {
    if (weight >= 0.0 && std::isfinite(weight)) continue;
    throw InvalidArgument(fmt::format("motions: a weight is {}, expected a finite number >= 0", weight));
  }
}

/// Per coordinate one by its spread; 0 where it does not change.
std::vector<double> spread_weights(std::span<const Curve> motions) {
  const auto dim = static_cast<std::size_t>(motions[0].dim());
  std::vector<double> variance(dim, 0.0);
  std::vector<double> size(dim, 0.0);
  for (const Curve& motion : motions) {
    const Interval domain = motion.domain();
    std::vector<Point> points;
    Point mean(dim);
    for (int i = 0; i < kSpreadSamples; ++i) {
      points.push_back(motion.evaluate(domain.lo + domain.length() * (i + 0.5) / kSpreadSamples));
      for (std::size_t c = 0; c < dim; ++c) mean[c] += points.back()[c] / kSpreadSamples;
    }
    for (const Point& point : points) {
      for (std::size_t c = 0; c < dim; ++c) {
        const double off = point[c] - mean[c];
        variance[c] += off * off / kSpreadSamples / static_cast<double>(motions.size());
        size[c] = std::max(size[c], std::fabs(point[c]));
      }
    }
  }
  std::vector<double> weights;
  for (std::size_t c = 0; c < dim; ++c) {
    const double spread = std::sqrt(variance[c]);
    weights.push_back(spread > kConstant * size[c] ? 1.0 / spread : 0.0);
  }
  return weights;
}

Curve weighted(const Curve& graph, std::span<const double> weights, double time_weight) {
  Points points = graph.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i][0] *= time_weight;
    for (std::size_t c = 0; c < weights.size(); ++c) points[i][c + 1] *= weights[c];
  }
  return Curve(graph.degree(), graph.knots(), std::move(points));
}

MatchOptions match_options(const MotionOptions& options) {
  MatchOptions own = options.match;
  if (own.samples == std::array<int, 2>{0, 0} && own.method == Method::elastic)
    own.samples = {kSamples, kSamples};
  if (own.direction == Direction::automatic) own.direction = Direction::forward;
  if (own.closed == ClosedMode::automatic) own.closed = ClosedMode::no;
  if (!own.rotate) own.rotate = false;
  if (!own.reduction) own.reduction = ReductionOptions{.order = kOrder};
  return own;
}

/// The motions' graphs, all over the domain of the first one and in step; nothing when cancelled.
std::optional<std::vector<Curve>> put_in_step(std::span<const Curve> motions, const MotionOptions& options,
                                              std::vector<Match>& matches) {
  check(motions, options);
  const std::vector<double> weights = options.weights.empty() ? spread_weights(motions) : options.weights;
  std::vector<Curve> graphs;
  std::optional<Curve> previous;  // as it is matched
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Curve graph = graph_of(motions[i]);
    Curve now = weighted(graph, weights, options.time_weight / motions[i].domain().length());
    if (i == 0) {
      graphs.push_back(graph);
      previous = std::move(now);
      continue;
    }
    MatchOptions own = match_options(options);
    if (own.progress) {
      const double steps = static_cast<double>(motions.size() - 1);
      own.progress = [&progress = options.match.progress, i, steps](double fraction) {
        return progress((static_cast<double>(i) - 1.0 + fraction) / steps);
      };
    }
    matches.push_back(match(*previous, now, own));
    if (matches.back().report.cancelled) return std::nullopt;
    graphs.push_back(compose(graph, matches.back().reparametrization.v));
    previous = matches.back().curve;
  }
  return graphs;
}

/// Reversing a motion would run its time backwards.
void refuse_reversed(const MotionOptions& options) {
  if (options.match.direction == Direction::reversed) {
    throw InvalidArgument("motions: the direction is reversed, expected forward: time runs one way");
  }
}

Morph make_morph(std::span<const Curve> motions, const MotionOptions& options, std::vector<Match>& matches,
                 bool& cancelled) {
  refuse_reversed(options);
  std::optional<std::vector<Curve>> graphs = put_in_step(motions, options, matches);
  cancelled = !graphs;
  if (cancelled) {  // something that exists: the first motion, standing
    const Curve graph = graph_of(motions[0]);
    return Morph::in_step(std::vector<Curve>{graph, graph});
  }
  return Morph::in_step(*graphs, {.times = options.times, .smooth = options.smooth});
}

/// The first coordinate.
Curve time_of(const Curve& graph) {
  Points times(1, graph.size());
  for (std::size_t i = 0; i < graph.size(); ++i) times[i][0] = graph.control_points()[i][0];
  return Curve(graph.degree(), graph.knots(), std::move(times));
}

}  // namespace

Curve graph_of(const Curve& motion) {
  if (motion.is_rational()) {
    throw InvalidArgument("motions: a rational curve, expected a polynomial one");
  }
  const auto degree = static_cast<std::size_t>(motion.degree());
  Points points(motion.dim() + 1, motion.size());
  for (std::size_t i = 0; i < motion.size(); ++i) {
    // The parameter as a spline: Greville's abscissae.
    double sum = 0.0;
    for (std::size_t k = 1; k <= degree; ++k) sum += motion.knots()[i + k];
    points[i][0] = sum / static_cast<double>(degree);
    const auto values = motion.control_points()[i];
    std::copy(values.begin(), values.end(), points[i].begin() + 1);
  }
  return Curve(motion.degree(), motion.knots(), std::move(points));
}

MotionMorph::MotionMorph(std::span<const Curve> motions, const MotionOptions& options)
    : morph_(make_morph(motions, options, matches_, cancelled_)) {}

Curve MotionMorph::graph(double s) const {
  return morph_.at(s).contours.front();
}

Interval MotionMorph::duration(double s) const {
  const Curve graph = this->graph(s);
  return {graph.evaluate(graph.domain().lo)[0], graph.evaluate(graph.domain().hi)[0]};
}

Points MotionMorph::rows(double s, std::size_t count) const {
  if (count < 2) throw InvalidArgument(fmt::format("motions: {} rows, expected at least 2", count));
  const Curve graph = this->graph(s);
  const Curve time = time_of(graph);
  const Interval domain = graph.domain();
  const double first = time.evaluate(domain.lo)[0];
  const double last = time.evaluate(domain.hi)[0];
  double latest = first;
  for (std::size_t i = 1; i <= 4 * count; ++i) {
    const double now = time.evaluate(domain.lo + domain.length() * static_cast<double>(i) /
                                                     static_cast<double>(4 * count))[0];
    if (!(now > latest)) {
      throw InvalidArgument(fmt::format("motions: at s = {} time runs back, expected s nearer to [0,1]", s));
    }
    latest = now;
  }
  Points rows(graph.dim(), count);
  double from = domain.lo;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double wanted = (1.0 - share) * first + share * last;
    double lo = from;
    double hi = domain.hi;
    for (int k = 0; k < kHalvings && i > 0; ++k) {
      const double middle = 0.5 * (lo + hi);
      (time.evaluate(middle)[0] < wanted ? lo : hi) = middle;
    }
    from = i == 0 ? domain.lo : i + 1 == count ? domain.hi : lo;
    const Point point = graph.evaluate(from);
    std::copy(point.begin(), point.end(), rows[i].begin());
    rows[i][0] = wanted;
  }
  return rows;
}

}  // namespace v0
}  // namespace tandem
