#include "match/node_placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "curve/evaluator.h"
#include "match/tangent.h"
#include "match/vector.h"
#include "shape/trigonometry.h"
#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Harmonics that give a loop without corners its phase. A shape of k-fold symmetry has only each k-th in the
/// distances that it covers; a circle has the first in its coordinates.
constexpr int kHighestReach = 16;
constexpr int kHighestCoordinate = 4;
/// Samples that the harmonics are taken from, and the amplitude (as a share of the extent) below which one
/// does not count: then the aliasing of the higher ones, which fall with the third power where the curvature
/// jumps, stays a thousand times smaller.
constexpr int kPhaseSamples = 256;
constexpr double kFaintest = 1e-4;

/// A stretch of the curve between two corners (or ends), in arc length.
struct Section {
  double start = 0.0;
  double length = 0.0;
  double parameter = 0.0;  ///< where it starts
};

/// Turning and length along a section, tabulated densely enough to place nodes by.
class Monitor {
 public:
  Monitor(const Curve& curve, const ArcLength& arc, const Section& section, double total, int steps) {
    const Evaluator evaluator(curve);
    const auto dim = static_cast<std::size_t>(curve.dim());
    std::vector<double> last(dim);
    std::vector<double> next(dim);
    for (int k = 0; k <= steps; ++k) {
      const double s = section.start + section.length * k / steps;
      const double t = arc.parameter_at(std::fmod(s, total));
      one_sided_tangent(evaluator, t, k == steps ? Side::left : Side::right, curve.extent(), next);
      // The chord between two unit vectors stands for the angle; corners are at the ends of a section only.
      turning_.push_back(k == 0 ? 0.0 : turning_.back() + distance(last, next));
      std::swap(last, next);
    }
  }

  [[nodiscard]] double turning() const { return turning_.back(); }

  /// n nodes (without the section's end) that share length and turning equally; offsets from the section's
  /// start.
  [[nodiscard]] std::vector<double> place(const Section& section, int n, double total,
                                          double total_turning) const {
    const int steps = static_cast<int>(turning_.size()) - 1;
    const auto measure = [&](int k) {
      const double by_turning =
          total_turning > 0.0 ? turning_[static_cast<std::size_t>(k)] / total_turning : 0.0;
      return 0.5 * section.length / total * k / steps + 0.5 * by_turning;
    };
    std::vector<double> offsets;
    int k = 0;
    for (int i = 0; i < n; ++i) {
      const double target = measure(steps) * i / n;
      while (k + 1 < steps && measure(k + 1) < target) ++k;
      const double width = measure(k + 1) - measure(k);
      const double local = width > 0.0 ? std::clamp((target - measure(k)) / width, 0.0, 1.0) : 0.0;
      offsets.push_back(section.length * (k + local) / steps);
    }
    return offsets;
  }

 private:
  std::vector<double> turning_;
};

/// The share of a period, in [0, 1), that the lowest harmonic of the signals lies behind their start; nothing
/// if they have no harmonic up to `highest`. The signal in which the harmonic is strongest decides.
std::optional<double> lowest_harmonic(const Points& signals, int highest) {
  const int samples = static_cast<int>(signals.size());
  for (int harmonic = 1; harmonic <= highest; ++harmonic) {
    double best = 0.0;
    double best_re = 0.0;
    double best_im = 0.0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(signals.dim()); ++c) {
      double re = 0.0;
      double im = 0.0;
      for (int k = 0; k < samples; ++k) {
        const CosSin w = cos_sin_degrees(360.0 * ((harmonic * k) % samples) / samples);
        const double x = signals[static_cast<std::size_t>(k)][c] - signals[0][c];
        re += x * w.cosine;
        im += x * w.sine;
      }
      const double amplitude = re * re + im * im;
      // A later signal must be clearly stronger, so that equal ones do not flip with rounding.
      if (amplitude > best * 1.000001) {
        best = amplitude;
        best_re = re;
        best_im = im;
      }
    }
    if (best <= kFaintest * kFaintest * samples * samples) continue;
    const double turn = angle_degrees(best_re, best_im) / 360.0 / harmonic;
    return turn - std::floor(turn);
  }
  return std::nullopt;
}

/// The phase of the curve, as an arc length from `start`, where its sampling begins. What decides is how far
/// the curve gets within a quarter of its length, place by place, since a turned curve is to get the same
/// nodes; a circle gets equally far everywhere, and its coordinates decide.
double harmonic_offset(const Curve& curve, const ArcLength& arc, double start) {
  const Evaluator evaluator(curve);
  const auto dim = static_cast<std::size_t>(curve.dim());
  const std::size_t n = kPhaseSamples;
  Points points(curve.dim(), n);
  for (std::size_t k = 0; k < n; ++k) {
    const double s = start + arc.length() * static_cast<double>(k) / kPhaseSamples;
    const auto point = points[k];
    evaluator.point(arc.parameter_at(s < arc.length() ? s : s - arc.length()), point);
    for (std::size_t c = 0; c < dim; ++c) point[c] /= curve.extent();
  }
  Points reaches(1, n);
  for (std::size_t k = 0; k < n; ++k) {
    // As far ahead as behind, so that the reversed curve gets the same nodes, too.
    const auto ahead = points[(k + n / 8) % n];
    const auto behind = points[(k + n - n / 8) % n];
    for (std::size_t c = 0; c < dim; ++c) {
      reaches[k][0] += (ahead[c] - behind[c]) * (ahead[c] - behind[c]);
    }
  }
  if (const auto phase = lowest_harmonic(reaches, kHighestReach)) return arc.length() * *phase;
  return arc.length() * lowest_harmonic(points, kHighestCoordinate).value_or(0.0);
}

/// Where the loop without corners starts: its phase, which depends on the shape alone (spec C10). A sum over
/// samples knows the phase only up to their aliasing, which depends on where they start: they start at the
/// phase itself, found by repetition. Each round shrinks what is left by 1e-3 or more.
double harmonic_phase(const Curve& curve, const ArcLength& arc) {
  constexpr int kMostRounds = 8;
  constexpr double kSettled = 1e-11;  // share of the length
  double phase = 0.0;
  for (int round = 0; round < kMostRounds; ++round) {
    const double offset = harmonic_offset(curve, arc, phase);
    phase += offset;
    if (phase >= arc.length()) phase -= arc.length();
    if (std::min(offset, arc.length() - offset) <= kSettled * arc.length()) break;
  }
  return phase;
}

std::vector<Section> cut_sections(const Curve& curve, const ArcLength& arc,
                                  const std::vector<double>& corners, const SampleOptions& options) {
  const double total = arc.length();
  std::vector<Section> sections;
  if (!options.cyclic) sections.push_back({0.0, 0.0, curve.domain().lo});
  for (double t : corners) sections.push_back({arc.length_to(t), 0.0, t});
  if (sections.empty()) {
    const double phase = harmonic_phase(curve, arc);
    sections.push_back({phase, 0.0, arc.parameter_at(phase)});
  }
  const double end = options.cyclic ? sections.front().start + total : total;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    sections[k].length = (k + 1 < sections.size() ? sections[k + 1].start : end) - sections[k].start;
  }
  // Corners a rounding error apart are one.
  std::erase_if(sections, [&](const Section& section) { return section.length <= 1e-12 * total; });
  return sections;
}

}  // namespace

std::vector<double> find_corners(const Curve& curve, double angle, bool cyclic, int most) {
  struct Corner {
    double parameter;
    double cosine;
  };
  const Evaluator evaluator(curve);
  const auto dim = static_cast<std::size_t>(curve.dim());
  const Interval domain = curve.domain();
  const double limit = cos_sin_degrees(angle * (180.0 / std::numbers::pi)).cosine;
  std::vector<double> in(dim);
  std::vector<double> out(dim);
  std::vector<Corner> corners;
  const auto examine = [&](double t, double arrive) {
    one_sided_tangent(evaluator, arrive, Side::left, curve.extent(), in);
    one_sided_tangent(evaluator, t, Side::right, curve.extent(), out);
    const double cosine = dot(in, out);
    if (cosine < limit && largest(in) > 0.0 && largest(out) > 0.0) corners.push_back({t, cosine});
  };
  if (cyclic) examine(domain.lo, domain.hi);
  for (const Knot& knot : distinct_knots(curve.knots())) {
    if (knot.value > domain.lo && knot.value < domain.hi) examine(knot.value, knot.value);
  }
  if (corners.size() > static_cast<std::size_t>(most)) {
    std::stable_sort(corners.begin(), corners.end(),
                     [](const Corner& x, const Corner& y) { return x.cosine < y.cosine; });
    corners.resize(static_cast<std::size_t>(most));
  }
  std::vector<double> parameters;
  parameters.reserve(corners.size());
  for (const Corner& c : corners) parameters.push_back(c.parameter);
  std::sort(parameters.begin(), parameters.end());
  return parameters;
}

std::vector<PlacedNode> place_by_length(const Curve& curve, const ArcLength& arc,
                                        const std::vector<double>& corners, const SampleOptions& options) {
  const double total = arc.length();
  const bool cyclic = options.cyclic;
  const std::vector<Section> sections = cut_sections(curve, arc, corners, options);
  const int intervals = cyclic ? options.count : options.count - 1;

  std::vector<Monitor> monitors;
  double total_turning = 0.0;
  if (options.sampling == Sampling::curvature) {
    for (const Section& section : sections) {
      const int steps = std::max(16, static_cast<int>(8 * intervals * section.length / total));
      monitors.emplace_back(curve, arc, section, total, steps);
      total_turning += monitors.back().turning();
    }
  }

  std::vector<PlacedNode> nodes;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const Section& section = sections[k];
    const double share = options.sampling == Sampling::curvature && total_turning > 0.0
                             ? 0.5 * section.length / total + 0.5 * monitors[k].turning() / total_turning
                             : section.length / total;
    // Halves go down, by more than rounding can lift them: a copy of the curve gets as many nodes.
    constexpr double kSlack = 1e-6;
    const int n = std::max(1, static_cast<int>(std::floor(intervals * share + 0.5 - kSlack)));
    std::vector<double> offsets;
    if (options.sampling == Sampling::curvature) {
      offsets = monitors[k].place(section, n, total, total_turning);
    } else {
      for (int i = 0; i < n; ++i) offsets.push_back(section.length * i / n);
    }
    for (int i = 0; i < n; ++i) {
      const double end = i + 1 < n ? offsets[static_cast<std::size_t>(i) + 1] : section.length;
      // Equal chords are equal to the bit: the elastic programme shares its quadrature among them.
      const double chord =
          options.sampling == Sampling::arc ? section.length / n : end - offsets[static_cast<std::size_t>(i)];
      double s = section.start + offsets[static_cast<std::size_t>(i)];
      if (s >= total) s -= total;
      nodes.push_back({i == 0 ? section.parameter : arc.parameter_at(s), chord});
    }
  }
  if (!cyclic) {
    nodes.push_back({curve.domain().hi, 0.0});
  } else {
    // Node 0 is the first one behind the seam.
    const auto first =
        std::min_element(nodes.begin(), nodes.end(),
                         [](const PlacedNode& x, const PlacedNode& y) { return x.parameter < y.parameter; });
    std::rotate(nodes.begin(), first, nodes.end());
  }
  return nodes;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
