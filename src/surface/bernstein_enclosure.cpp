#include "surface/bernstein_enclosure.h"

#include <algorithm>
#include <deque>
#include <mutex>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

Enclosures row_after(const Enclosures& row) {
  Enclosures next(row.size() + 1, 1.0);
  for (std::size_t k = 1; k < row.size(); ++k) next[k] = row[k - 1] + row[k];
  return next;
}

std::deque<Enclosures> make_rows(std::size_t count) {
  std::deque<Enclosures> rows = {{1.0}};
  while (rows.size() < count) rows.push_back(row_after(rows.back()));
  return rows;
}

}  // namespace

const Enclosures& binomial_row(std::size_t n) {
  // Most Jacobians are of lower degree than this; the others pay for a lock.
  constexpr std::size_t kReady = 64;
  static const std::deque<Enclosures> ready = make_rows(kReady);
  if (n < kReady) return ready[n];
  static std::mutex mutex;
  static std::deque<Enclosures> more = ready;
  const std::lock_guard lock(mutex);
  while (more.size() <= n) more.push_back(row_after(more.back()));  // a deque keeps its rows in place
  return more[n];
}

Enclosures product(const Enclosures& f, const Enclosures& g) {
  const Enclosures& of_f = binomial_row(f.size() - 1);
  const Enclosures& of_g = binomial_row(g.size() - 1);
  const Enclosures& of_all = binomial_row(f.size() + g.size() - 2);
  Enclosures weighed = g;
  for (std::size_t j = 1; j + 1 < g.size(); ++j) weighed[j] = of_g[j] * g[j];
  Enclosures result(of_all.size());
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (f[i].is_zero()) continue;
    const Enclosure factor = i == 0 || i + 1 == f.size() ? f[i] : of_f[i] * f[i];
    for (std::size_t j = 0; j < g.size(); ++j) result[i + j] += factor * weighed[j];
  }
  for (std::size_t k = 1; k + 1 < result.size(); ++k) result[k] = result[k] / of_all[k];
  return result;
}

Enclosures sum(Enclosures f, const Enclosures& g) {
  for (std::size_t i = 0; i < f.size(); ++i) f[i] += g[i];
  return f;
}

Enclosures difference(Enclosures f, const Enclosures& g) {
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = f[i] - g[i];
  return f;
}

Enclosures elevated(Enclosures f, std::size_t degree) {
  while (f.size() <= degree) {
    const auto n = static_cast<double>(f.size());
    Enclosures higher(f.size() + 1);
    higher.front() = f.front();
    higher.back() = f.back();
    for (std::size_t i = 1; i < f.size(); ++i) {
      const auto k = static_cast<double>(i);
      higher[i] = (Enclosure(k) * f[i - 1] + Enclosure(n - k) * f[i]) / Enclosure(n);
    }
    f = std::move(higher);
  }
  return f;
}

std::pair<Enclosures, Enclosures> halves(const Enclosures& f) {
  Enclosures right = f;
  Enclosures left(f.size());
  for (std::size_t r = 0; r < f.size(); ++r) {
    left[r] = right[0];
    for (std::size_t i = 0; i + 1 + r < f.size(); ++i) right[i] = half(right[i] + right[i + 1]);
  }
  return {std::move(left), std::move(right)};
}

Enclosures without_zero_at_0(const Enclosures& f) {
  const auto n = static_cast<double>(f.size() - 1);
  Enclosures result(f.begin() + 1, f.end());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = result[i] * Enclosure(n) / Enclosure(static_cast<double>(i + 1));
  return result;
}

Enclosures without_zero_at_1(const Enclosures& f) {
  const Enclosures back = without_zero_at_0(Enclosures(f.rbegin(), f.rend()));
  return {back.rbegin(), back.rend()};
}

int common_sign(const Enclosures& f) noexcept {
  bool positive = false;
  bool negative = false;
  for (const Enclosure& c : f) {
    positive = positive || c.is_positive();
    negative = negative || c.is_negative();
    if (!c.is_positive() && !c.is_negative() && !c.is_zero()) return 0;
  }
  return positive == negative ? 0 : (positive ? 1 : -1);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
