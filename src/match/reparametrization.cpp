#include "tandem/match/reparametrization.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "match/fit_kinds.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

/// Far beyond any use; larger numbers are typing errors that would only fill the memory.
constexpr int kMostCoefficients = 1'000'000;
constexpr int kHighestOrder = 32;

void check_options(const ReductionOptions& options) {
  if (options.order < 2 || options.order > kHighestOrder) {
    throw InvalidArgument(
        fmt::format("the order of v is {}, expected 2 .. {}", options.order, kHighestOrder));
  }
  if (!(options.min_slope > 0.0 && options.min_slope <= 1.0)) {
    throw InvalidArgument(fmt::format(
        "the least slope of v is {}, expected more than 0 and at most 1 (the mean)", options.min_slope));
  }
  if (options.coefficients) {
    if (*options.coefficients < options.order || *options.coefficients > kMostCoefficients) {
      throw InvalidArgument(fmt::format("{} coefficients for v of order {}, expected {} .. {}",
                                        *options.coefficients, options.order, options.order,
                                        kMostCoefficients));
    }
  } else if (!(options.tolerance > 0.0)) {
    throw InvalidArgument(fmt::format("the tolerance is {}, expected more than 0", options.tolerance));
  }
}

void check_path(const std::vector<ParameterPair>& points) {
  if (points.size() < 2) {
    throw InvalidArgument(fmt::format("the path has {} points, expected at least 2", points.size()));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [u, v] = points[i];
    if (!std::isfinite(u) || !std::isfinite(v)) {
      throw InvalidArgument(
          fmt::format("point {} of the path is ({}, {}), expected finite numbers", i, u, v));
    }
    if (i > 0 && (u < points[i - 1].u || v < points[i - 1].v)) {
      throw InvalidArgument(fmt::format("point {} of the path is ({}, {}), which steps back from ({}, {})", i,
                                        u, v, points[i - 1].u, points[i - 1].v));
    }
  }
  const auto [u0, v0] = points.front();
  const auto [u1, v1] = points.back();
  if (!(u1 > u0) || !(v1 > v0) || !std::isfinite(u1 - u0) || !std::isfinite(v1 - v0)) {
    throw InvalidArgument(fmt::format(
        "the path leads from ({}, {}) to ({}, {}), expected to rise in u and in v by finite lengths", u0, v0,
        u1, v1));
  }
}

}  // namespace

Reparametrization fit(const FitPath& path, const ReductionOptions& options, bool reversed) {
  check_options(options);
  check_path(path.points);
  const detail::SlopeRange range{options.min_slope, 1.0 / options.min_slope};
  Reparametrization result = options.coefficients ? detail::fit_coefficients(path, options, range)
                             : options.order == 2 ? detail::fit_polyline(path, options, range)
                                                  : detail::fit_smooth(path, options, range);
  result.reversed = reversed;
  return result;
}

}  // namespace v0
}  // namespace tandem
