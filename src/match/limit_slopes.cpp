#include "match/limit_slopes.h"

#include <algorithm>
#include <limits>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// A function is admissible when every slope lies in the range. The greatest admissible function below y is
// min_j y_j + d(j, i), where d is range.hi * distance for i after j and -range.lo * distance for i before j:
// the greatest change that the slopes allow. It obeys the triangle inequality, so that two sweeps find the
// minimum.

/// Lowers y to the greatest admissible function below it.
void lower_to_admissible(std::span<const double> x, std::span<double> y, const SlopeRange& range) {
  for (std::size_t i = 1; i < y.size(); ++i) {
    y[i] = std::min(y[i], y[i - 1] + range.hi * (x[i] - x[i - 1]));
  }
  for (std::size_t i = y.size(); i-- > 1;) {
    y[i - 1] = std::min(y[i - 1], y[i] - range.lo * (x[i] - x[i - 1]));
  }
}

/// Raises y to the least admissible function above it.
void raise_to_admissible(std::span<const double> x, std::span<double> y, const SlopeRange& range) {
  for (std::size_t i = 1; i < y.size(); ++i) {
    y[i] = std::max(y[i], y[i - 1] + range.lo * (x[i] - x[i - 1]));
  }
  for (std::size_t i = y.size(); i-- > 1;) {
    y[i - 1] = std::max(y[i - 1], y[i] - range.hi * (x[i] - x[i - 1]));
  }
}

struct Envelope {
  std::vector<double> low;
  std::vector<double> high;
};

/// Where an admissible function through the fixed values can run.
Envelope through_fixed(std::span<const double> x, std::span<const double> values,
                       std::span<const std::size_t> fixed, const SlopeRange& range) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Envelope envelope{std::vector<double>(x.size(), -kInfinity), std::vector<double>(x.size(), kInfinity)};
  for (const std::size_t i : fixed) envelope.low[i] = envelope.high[i] = values[i];
  raise_to_admissible(x, envelope.low, range);
  lower_to_admissible(x, envelope.high, range);
  // The neighbours' sweeps may move a fixed value by rounding.
  for (const std::size_t i : fixed) envelope.low[i] = envelope.high[i] = values[i];
  for (std::size_t i = 0; i < x.size(); ++i) envelope.high[i] = std::max(envelope.low[i], envelope.high[i]);
  return envelope;
}

}  // namespace

std::vector<double> limit_slopes(std::span<const double> x, std::span<const double> values,
                                 std::span<const std::size_t> fixed, const SlopeRange& range) {
  return limit_slopes(x, values, values, values, fixed, range);
}

std::vector<double> limit_slopes(std::span<const double> x, std::span<const double> values,
                                 std::span<const double> low, std::span<const double> high,
                                 std::span<const std::size_t> fixed, const SlopeRange& range) {
  const std::size_t n = x.size();
  const Envelope envelope = through_fixed(x, values, fixed, range);

  // Narrow the intervals to what the slopes allow. Where the two bounds cross there is no room inside: any
  // function between them is then as good as can be, up to a factor of two.
  std::vector<double> above(n);
  std::vector<double> below(n);
  for (std::size_t i = 0; i < n; ++i) {
    above[i] = std::clamp(low[i], envelope.low[i], envelope.high[i]);
    below[i] = std::clamp(high[i], envelope.low[i], envelope.high[i]);
  }
  raise_to_admissible(x, above, range);
  lower_to_admissible(x, below, range);
  for (std::size_t i = 0; i < n; ++i) {
    const double value = std::clamp(values[i], std::min(above[i], below[i]), std::max(above[i], below[i]));
    above[i] = below[i] = value;
  }

  raise_to_admissible(x, above, range);
  lower_to_admissible(x, below, range);
  for (std::size_t i = 0; i < n; ++i)
    above[i] = above[i] == below[i] ? above[i] : 0.5 * above[i] + 0.5 * below[i];
  for (const std::size_t i : fixed) above[i] = values[i];
  return above;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
