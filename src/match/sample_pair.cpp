#include "match/sample_pair.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "match/pins.h"
#include "tandem/curve/arc_length.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

constexpr int kOpenSamples = 100;
constexpr int kClosedSamples = 128;
constexpr int kFewestCoarseSamples = 32;

/// The elastic steps bridge ratios up to the longest step; beyond half of that the default counts are evened
/// out.
constexpr std::size_t kLargestRatio = 3;

SampleOptions sample_options(const MatchOptions& options, int requested, bool cyclic, int divisor) {
  const bool paper = options.method == Method::paper;
  SampleOptions s;
  const int count = requested > 0 ? requested : (cyclic && !paper ? kClosedSamples : kOpenSamples);
  s.count = divisor == 1 ? count : std::max(kFewestCoarseSamples, count / divisor);
  s.sampling = options.sampling.value_or(paper ? Sampling::parameter : Sampling::arc);
  s.cyclic = cyclic;
  s.corner_angle = options.corner_angle;
  s.low_pass = options.low_pass;
  return s;
}

/// Parameters of the nodes that pins want, in their own order and without the ends.
std::vector<double> pinned_nodes(const std::vector<ParameterPair>& pins, double ParameterPair::*member,
                                 const Curve& curve, bool cyclic) {
  std::vector<double> nodes;
  for (const ParameterPair& pin : pins) {
    const double t = pin.*member;
    if (cyclic || (t > curve.domain().lo && t < curve.domain().hi)) nodes.push_back(t);
  }
  return nodes;
}

void sort_once(std::vector<double>& nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

/// The length of a stretch of a curve from one parameter to another, on a loop past its end.
struct Stretch {
  double start;
  double length;
};

Stretch stretch_of(const ArcLength& arc, const Interval& domain, const Interval& t) {
  const double from = arc.length_to(t.lo);
  if (t.hi < t.lo) return {from, arc.length() - from + arc.length_to(t.hi)};  // the two ends of an open curve
  if (t.hi <= domain.hi) return {from, arc.length_to(t.hi) - from};
  return {from, arc.length() - from + arc.length_to(t.hi - domain.length())};
}

/// Nodes that divide a stretch into equal parts.
void divide(std::vector<double>& nodes, const ArcLength& arc, const Stretch& stretch, double parts) {
  for (double k = 1.0; k < parts; k += 1.0) {
    const double s = stretch.start + stretch.length * k / parts;
    nodes.push_back(arc.parameter_at(s < arc.length() ? s : s - arc.length()));
  }
}

/// Nodes that leave a stretch no more than kLargestRatio times fewer chords than its partner has: the elastic
/// steps could not bridge that. Chords are as long as the whole curve's number of samples makes them.
void even_out(std::vector<double>& nodes, const ArcLength& arc, const Stretch& stretch, double own,
              double other) {
  const double wanted = std::ceil(other / 2.0);
  if (own * static_cast<double>(kLargestRatio) <= other) divide(nodes, arc, stretch, wanted);
}

/// The nodes of both curves where pins want them.
void add_pinned_nodes(const Curve& a, const Curve& b, const MatchOptions& options, Layout layout,
                      SampleOptions& options_a, SampleOptions& options_b) {
  options_a.nodes = pinned_nodes(options.pins, &ParameterPair::u, a, options_a.cyclic);
  options_b.nodes = pinned_nodes(options.pins, &ParameterPair::v, b, options_b.cyclic);
  const ArcLength arc_a(a);
  const ArcLength arc_b(b);
  if (layout == Layout::cut_a || layout == Layout::cut_b) {
    // Room to cut the loop beyond the pins.
    const PinnedStretch beyond =
        stretches(options, layout, a.domain(), b.domain(), options.direction == Direction::reversed).back();
    constexpr double kParts = 4.0;
    if (layout == Layout::cut_a) {
      divide(options_a.nodes, arc_a, stretch_of(arc_a, a.domain(), beyond.u), kParts);
    } else {
      divide(options_b.nodes, arc_b, stretch_of(arc_b, b.domain(), beyond.v), kParts);
    }
  }
  if (options.method != Method::paper) {
    for (const bool reversed : {false, true}) {
      if (options.direction == (reversed ? Direction::forward : Direction::reversed)) continue;
      for (const PinnedStretch& both : stretches(options, layout, a.domain(), b.domain(), reversed)) {
        const Stretch on_a = stretch_of(arc_a, a.domain(), both.u);
        const Stretch on_b = stretch_of(arc_b, b.domain(), both.v);
        const double count_a = on_a.length / arc_a.length() * options_a.count;
        const double count_b = on_b.length / arc_b.length() * options_b.count;
        even_out(options_a.nodes, arc_a, on_a, count_a, count_b);
        even_out(options_b.nodes, arc_b, on_b, count_b, count_a);
      }
    }
  }
  sort_once(options_a.nodes);
  sort_once(options_b.nodes);
}

/// Errors say which of the two curves they are about.
Samples sample_named(const char* which, const Curve& curve, const SampleOptions& options) {
  try {
    return sample(curve, options);
  } catch (const InvalidArgument& e) {
    throw InvalidArgument(std::string("the ") + which + " curve cannot be sampled: " + e.what());
  }
}

}  // namespace

Layout choose_layout(const Curve& a, const Curve& b, ClosedMode mode) {
  const bool both = a.is_closed() && b.is_closed();
  switch (mode) {
    case ClosedMode::no:
      return Layout::open;
    case ClosedMode::yes:
    case ClosedMode::pinned:
      if (!both) {
        throw InvalidArgument(std::string("the ") + (a.is_closed() ? "second" : "first") +
                              " curve is open; matching as loops needs two closed curves");
      }
      return mode == ClosedMode::yes ? Layout::toroidal : Layout::pinned;
    case ClosedMode::automatic:
      break;
  }
  if (both) return Layout::toroidal;
  if (a.is_closed()) return Layout::cut_a;
  return b.is_closed() ? Layout::cut_b : Layout::open;
}

SamplePair sample_pair(const Curve& a, const Curve& b, const MatchOptions& options, Layout layout,
                       int divisor) {
  // The elastic pinned form cuts the second loop against the first one, which is open at its seam.
  const bool pinned_open = layout == Layout::pinned && options.method == Method::elastic;
  const bool cyclic_a =
      layout == Layout::toroidal || layout == Layout::cut_a || (layout == Layout::pinned && !pinned_open);
  const bool cyclic_b = layout == Layout::toroidal || layout == Layout::cut_b || layout == Layout::pinned;
  SampleOptions options_a = sample_options(options, options.samples[0], cyclic_a, divisor);
  SampleOptions options_b = sample_options(options, options.samples[1], cyclic_b, divisor);
  if (!options.pins.empty()) add_pinned_nodes(a, b, options, layout, options_a, options_b);
  SamplePair pair{sample_named("first", a, options_a), sample_named("second", b, options_b)};
  if (options.method == Method::paper || !options.pins.empty()) return pair;
  const auto too_few = [](const Samples& few, const Samples& many) {
    return few.chords() * kLargestRatio < many.chords();
  };
  if (options.samples[0] == 0 && too_few(pair.a, pair.b)) {
    options_a.count = static_cast<int>(pair.b.size() / 2);
    pair.a = sample(a, options_a);
  } else if (options.samples[1] == 0 && too_few(pair.b, pair.a)) {
    options_b.count = static_cast<int>(pair.a.size() / 2);
    pair.b = sample(b, options_b);
  }
  return pair;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
