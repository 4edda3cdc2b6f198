#include "match/sample_pair.h"

#include <algorithm>
#include <cstddef>
#include <string>

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
  SamplePair pair{sample_named("first", a, options_a), sample_named("second", b, options_b)};
  if (options.method == Method::paper) return pair;
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
