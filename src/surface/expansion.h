#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace tandem {
inline namespace v0 {
namespace detail {

/// A real number as the exact sum of doubles that do not overlap, smallest first, none of them zero: its sign
/// is that of the last one. Exact as long as nothing overflows and no product falls below the smallest
/// double. Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates (1997).
template <std::size_t Capacity>
class Expansion {
 public:
  Expansion() = default;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] double operator[](std::size_t i) const noexcept { return terms_[i]; }
  [[nodiscard]] int sign() const noexcept { return size_ == 0 ? 0 : (terms_[size_ - 1] > 0.0 ? 1 : -1); }

  /// Grow-Expansion (Theorem 10), without zeros.
  void add(double b) noexcept {
    std::size_t kept = 0;
    double carry = b;
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = carry + terms_[i];
      const double of_term = sum - carry;
      const double error = (carry - (sum - of_term)) + (terms_[i] - of_term);
      if (error != 0.0) terms_[kept++] = error;
      carry = sum;
    }
    size_ = kept;
    if (carry != 0.0) {
      assert(size_ < Capacity);
      terms_[size_++] = carry;
    }
  }

 private:
  std::array<double, Capacity> terms_;
  std::size_t size_ = 0;
};

/// a * b = product + error, exactly (Dekker).
struct ExactProduct {
  double product;
  double error;

  ExactProduct(double a, double b) noexcept : product(a * b) {
    const auto split = [](double x) {
      const double c = 134217729.0 * x;  // 2^27 + 1: halves of 26 bits
      return c - (c - x);
    };
    const double a_high = split(a);
    const double b_high = split(b);
    const double a_low = a - a_high;
    const double b_low = b - b_high;
    error = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
  }
};

/// a - b.
inline Expansion<2> exact_difference(double a, double b) noexcept {
  Expansion<2> result;
  result.add(a);
  result.add(-b);
  return result;
}

template <std::size_t M, std::size_t N>
Expansion<2 * M * N> operator*(const Expansion<M>& a, const Expansion<N>& b) noexcept {
  Expansion<2 * M * N> result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const ExactProduct p(a[i], b[j]);
      result.add(p.error);
      result.add(p.product);
    }
  }
  return result;
}

template <std::size_t M, std::size_t N>
Expansion<M + N> operator+(const Expansion<M>& a, const Expansion<N>& b) noexcept {
  Expansion<M + N> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.add(a[i]);
  for (std::size_t j = 0; j < b.size(); ++j) result.add(b[j]);
  return result;
}

template <std::size_t M, std::size_t N>
Expansion<M + N> operator-(const Expansion<M>& a, const Expansion<N>& b) noexcept {
  Expansion<M + N> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.add(a[i]);
  for (std::size_t j = 0; j < b.size(); ++j) result.add(-b[j]);
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
