#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <vector>

#include "tandem/match/correspondence.h"

/// Generators of monotone paths with everything that is nasty about them: flat and vertical runs, tiny and
/// large steps, domains far from 0, huge and tiny units.
namespace tandem::testing {

/// Increments >= 0 of at least one positive one, drawn from whole numbers so that runs of zeros are common.
inline rc::Gen<std::vector<double>> increments(std::size_t n) {
  return rc::gen::map(rc::gen::container<std::vector<int>>(
                          n, rc::gen::weightedElement<int>({{4, 0}, {8, 1}, {3, 2}, {1, 40}, {1, 1000}})),
                      [](const std::vector<int>& whole) {
                        std::vector<double> result(whole.begin(), whole.end());
                        double sum = 0.0;
                        for (const double step : result) sum += step;
                        if (sum == 0.0) result.front() = 1.0;
                        return result;
                      });
}

inline Interval domain_of_any_size() {
  const double lo = *rc::gen::element(0.0, -3.5, 1e6, -1e6, 1e-290, -1e290);
  const double length = lo == 1e-290   ? 1e-290
                        : lo == -1e290 ? *rc::gen::element(1e290, 7e289)
                                       : *rc::gen::element(1.0, 0.3, 12.0);
  return {lo, lo + length};
}

/// Values of a running sum, scaled onto the domain; both ends exact.
inline std::vector<double> onto(const Interval& domain, const std::vector<double>& steps) {
  double total = 0.0;
  for (const double step : steps) total += step;
  std::vector<double> values{domain.lo};
  double sum = 0.0;
  for (const double step : steps) {
    sum += step;
    values.push_back(sum == total ? domain.hi : domain.lo + sum / total * domain.length());
  }
  return values;
}

/// An open path over domains of unit-like size (`plain`) or of any.
inline Correspondence open_correspondence(bool plain, bool reversed) {
  const auto n = *rc::gen::inRange<std::size_t>(1, 40);
  Correspondence c;
  c.domain_u = plain ? Interval{0.0, 1.0} : domain_of_any_size();
  c.domain_v = plain ? Interval{0.0, 1.0} : domain_of_any_size();
  c.reversed = reversed;
  const std::vector<double> u = onto(c.domain_u, *increments(n));
  const std::vector<double> v = onto(c.domain_v, *increments(n));
  for (std::size_t i = 0; i <= n; ++i) c.points.push_back({u[i], reversed ? v[n - i] : v[i]});
  return c;
}

/// A closed path that starts anywhere.
inline Correspondence closed_correspondence(bool plain, bool reversed) {
  Correspondence c = open_correspondence(plain, reversed);
  c.closed = true;
  const double du = *rc::gen::element(0.0, 0.25, 0.77, -1.4, 3.0) * c.domain_u.length();
  const double dv = *rc::gen::element(0.0, 0.5, 0.13, -2.2, 1.0) * c.domain_v.length();
  for (ParameterPair& point : c.points) point = {point.u + du, point.v + dv};
  const ParameterPair first = c.points.front();
  c.points.back() = {first.u + c.domain_u.length(),
                     first.v + (reversed ? -c.domain_v.length() : c.domain_v.length())};
  // Adding an offset may have rounded a step away, never turned it round; the last point is set, so look at
  // it.
  for (ParameterPair& point : c.points) {
    point.u = point.u > c.points.back().u ? c.points.back().u : point.u;
    const double last = c.points.back().v;
    point.v = reversed ? (point.v < last ? last : point.v) : (point.v > last ? last : point.v);
  }
  return c;
}

inline Correspondence any_correspondence(bool plain = false) {
  const bool reversed = *rc::gen::arbitrary<bool>();
  return *rc::gen::arbitrary<bool>() ? closed_correspondence(plain, reversed)
                                     : open_correspondence(plain, reversed);
}

}  // namespace tandem::testing
