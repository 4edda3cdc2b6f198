#include "tandem/rank/shape_descriptor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "match/vector.h"
#include "tandem/curve/arc_length.h"
#include "tandem/error.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {

namespace {

constexpr std::size_t kMostChords = 10'000;
/// Tangents come rounded to float, or were written by others; far off means that they are something else.
constexpr double kUnitTolerance = 1e-3;
/// The smallest 4 pi area / length^2 (1 for a circle) whose sign is trusted.
constexpr double kLeastRoundness = 0.01;
constexpr double kFourPi = 12.566370614359172;

double to_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

void check(bool closed, const Points& tangents, const std::vector<double>& lengths) {
  const std::size_t least = closed ? 3 : 1;
  if (lengths.size() < least || lengths.size() > kMostChords) {
    throw InvalidArgument(fmt::format("a descriptor of {} curve has {} to {} chords, not {}",
                                      closed ? "a closed" : "an open", least, kMostChords, lengths.size()));
  }
  if (tangents.size() != lengths.size()) {
    throw InvalidArgument(
        fmt::format("a descriptor of {} tangents cannot have {} lengths", tangents.size(), lengths.size()));
  }
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (!(lengths[i] > 0.0 && std::isfinite(lengths[i])))
      throw InvalidArgument(fmt::format("length {} is {}, expected a positive number", i, lengths[i]));
    const double size = detail::largest(tangents[i]) <= 2.0 ? std::sqrt(detail::dot(tangents[i], tangents[i]))
                                                            : detail::largest(tangents[i]);
    // Negated, so that NaN fails as well.
    if (!(std::fabs(size - 1.0) <= kUnitTolerance))
      throw InvalidArgument(fmt::format("tangent {} has length {}, expected 1", i, size));
  }
}

/// The area that the chords enclose, in shares of a circle of the same length; positive: counter-clockwise.
double roundness(const Points& tangents, const std::vector<double>& lengths) {
  double doubled = 0.0;
  double x = 0.0;
  double y = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double dx = tangents[i][0] * lengths[i];
    const double dy = tangents[i][1] * lengths[i];
    doubled += x * dy - y * dx;
    x += dx;
    y += dy;
  }
  return kFourPi * 0.5 * doubled;
}

void reverse(Points& tangents, std::vector<double>& lengths) {
  const std::size_t n = lengths.size();
  Points backward(tangents.dim(), n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto from = std::as_const(tangents)[n - 1 - i];
    const auto to = backward[i];
    for (std::size_t c = 0; c < to.size(); ++c) to[c] = -from[c];
  }
  tangents = std::move(backward);
  std::reverse(lengths.begin(), lengths.end());
}

}  // namespace

ShapeDescriptor::ShapeDescriptor(bool closed, Points tangents, std::vector<double> lengths, std::string name,
                                 std::string label)
    : name_(std::move(name)),
      label_(std::move(label)),
      closed_(closed),
      tangents_(std::move(tangents)),
      lengths_(std::move(lengths)) {
  check(closed_, tangents_, lengths_);
  for (double& c : tangents_.data()) c = to_float(c);
  const double total = std::accumulate(lengths_.begin(), lengths_.end(), 0.0);
  // A sum near 1 is rounding's: what was written to a file must read back equal.
  const double scale = std::fabs(total - 1.0) <= 1e-6 * static_cast<double>(size()) ? 1.0 : total;
  for (double& length : lengths_) length = to_float(std::max(length / scale, 1e-30));
  if (!closed_ || dim() != 2) return;
  if (roundness(tangents_, lengths_) <= -kLeastRoundness) reverse(tangents_, lengths_);
  // Asked again, since the sum of the reversed terms may be rounded to the other side of the limit.
  oriented_ = roundness(tangents_, lengths_) >= kLeastRoundness;
}

ShapeDescriptor describe(const Curve& curve, const DescribeOptions& options) {
  if (options.samples < 3 || static_cast<std::size_t>(options.samples) > kMostChords) {
    throw InvalidArgument(
        fmt::format("a descriptor takes 3 to {} samples, not {}", kMostChords, options.samples));
  }
  const bool closed = curve.is_closed();
  // An open curve has one node more than chords.
  const Samples samples =
      sample(curve, {.count = closed ? options.samples : options.samples + 1, .cyclic = closed});
  Points tangents(curve.dim(), 0);
  std::vector<double> lengths;
  for (std::size_t k = 0; k < samples.chords(); ++k) {
    // Where the curve stands still there is no direction.
    if (!(samples.chord_lengths[k] > 0.0) || detail::largest(samples.chord_tangents[k]) == 0.0) continue;
    tangents.push_back(samples.chord_tangents[k]);
    lengths.push_back(samples.chord_lengths[k]);
  }
  return {closed, std::move(tangents), std::move(lengths), options.name, options.label};
}

std::size_t outer_contour(const Shape& shape) {
  if (shape.contours.empty()) throw InvalidArgument("the shape has no contour");
  if (shape.contours.size() == 1) return 0;
  std::size_t best = 0;
  double most = -1.0;
  const bool any_closed =
      shape.dim() == 2 && std::any_of(shape.contours.begin(), shape.contours.end(),
                                      [](const Curve& contour) { return contour.is_closed(); });
  for (std::size_t i = 0; i < shape.contours.size(); ++i) {
    const Curve& contour = shape.contours[i];
    if (!(contour.extent() > 0.0) || (any_closed && !contour.is_closed())) continue;
    // Enough digits to tell contours apart, and cheap.
    constexpr double kAccuracy = 1e-6;
    // Several nodes on every piece of a composite path.
    const int count = static_cast<int>(std::clamp<std::size_t>(2 * contour.size(), 64, 4096));
    double size = 0.0;
    if (any_closed) {
      const Samples s = sample(contour, {.count = count, .sampling = Sampling::parameter, .cyclic = true});
      size = std::fabs(roundness(s.chord_tangents, s.chord_lengths)) * s.length * s.length;
    } else {
      size = arc_length(contour, kAccuracy);
    }
    if (size > most) {
      most = size;
      best = i;
    }
  }
  return best;
}

ShapeDescriptor describe(const Shape& shape, const DescribeOptions& options) {
  return describe(shape.contours[outer_contour(shape)], options);
}

}  // namespace v0
}  // namespace tandem
