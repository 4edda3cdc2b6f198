#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "curve/spline.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Every distinct knot once more.
std::vector<double> elevated_knots(const std::vector<double>& knots) {
  std::vector<double> more;
  more.reserve(2 * knots.size());
  for (std::size_t i = 0; i < knots.size(); ++i) {
    more.push_back(knots[i]);
    if (i + 1 == knots.size() || knots[i + 1] != knots[i]) more.push_back(knots[i]);
  }
  return more;
}

// One degree more. The blossom of the elevated curve at u_1 .. u_(p+1) is the mean of the curve's own at all
// but one of them (Ramshaw, Blossoming, 1987); each of those is a coefficient after knot insertion, so that
// only convex combinations are formed and multiplicities come out exactly.
Spline elevated_once(const Spline& spline) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const auto stride = static_cast<std::size_t>(spline.stride);
  Spline result;
  result.degree = spline.degree + 1;
  result.stride = spline.stride;
  result.rational = spline.rational;
  result.scale = spline.scale;
  result.knots = elevated_knots(spline.knots);
  const std::size_t n = result.knots.size() - p - 2;
  result.coefficients.assign(n * stride, 0.0);
  Blossom blossom(spline);
  std::vector<double> args(p);
  std::vector<double> value(stride);
  for (std::size_t i = 0; i < n; ++i) {
    const double* u = result.knots.data() + i + 1;
    for (std::size_t skip = 0; skip <= p;) {
      std::size_t copies = 1;
      while (skip + copies <= p && u[skip + copies] == u[skip]) ++copies;
      std::copy(u, u + skip, args.begin());
      std::copy(u + skip + 1, u + p + 1, args.begin() + static_cast<std::ptrdiff_t>(skip));
      blossom(args.data(), value.data());
      const double share = static_cast<double>(copies) / static_cast<double>(p + 1);
      // All arguments alike: the coefficient is the point itself, not a rounded mean.
      if (copies == p + 1) {
        std::copy(value.begin(), value.end(), result[i]);
      } else {
        for (std::size_t c = 0; c < stride; ++c) result[i][c] += share * value[c];
      }
      skip += copies;
    }
  }
  return result;
}

}  // namespace

Spline elevated(Spline spline, int times) {
  if (times <= 0) return spline;
  spline = clamped(std::move(spline));
  for (int i = 0; i < times; ++i) spline = elevated_once(spline);
  return spline;
}

}  // namespace detail

Curve elevate_degree(const Curve& curve, int times) {
  if (times < 0) throw InvalidArgument(fmt::format("the degree raised by {}, expected at least 0", times));
  if (times == 0) return curve;
  return detail::euclidean(detail::elevated(detail::premultiplied(curve), times));
}

}  // namespace v0
}  // namespace tandem
