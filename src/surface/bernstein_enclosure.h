#pragma once

#include <cstddef>
#include <utility>

#include "surface/enclosed_spline.h"
#include "surface/enclosure.h"

/// Polynomials on [0,1] by enclosures of their Bernstein coefficients, n + 1 of them for degree n. The
/// polynomial lies between the smallest and the largest; the first and the last are its values at the ends.
namespace tandem {
inline namespace v0 {
namespace detail {

/// Row n of Pascal's triangle; exact up to n = 56, enclosed above.
[[nodiscard]] const Enclosures& binomial_row(std::size_t n);

[[nodiscard]] Enclosures product(const Enclosures& f, const Enclosures& g);
/// Of the same degree.
[[nodiscard]] Enclosures sum(Enclosures f, const Enclosures& g);
[[nodiscard]] Enclosures difference(Enclosures f, const Enclosures& g);
[[nodiscard]] Enclosures elevated(Enclosures f, std::size_t degree);

/// The parts over [0, 1/2] and [1/2, 1].
[[nodiscard]] std::pair<Enclosures, Enclosures> halves(const Enclosures& f);

/// f(t) / t, where f(0) = 0 was proved.
[[nodiscard]] Enclosures without_zero_at_0(const Enclosures& f);
/// f(t) / (1 - t), where f(1) = 0 was proved.
[[nodiscard]] Enclosures without_zero_at_1(const Enclosures& f);

/// +1 or -1 if all coefficients have that sign for certain, or are zero for certain, but not all of them: the
/// polynomial then has that sign on the open interval, and is zero at an end only if its coefficient there
/// is. Otherwise 0.
[[nodiscard]] int common_sign(const Enclosures& f) noexcept;

}  // namespace detail
}  // namespace v0
}  // namespace tandem
