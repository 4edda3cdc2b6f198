// The inner loops of the elastic programme, for every instruction set (Highway compiles this file once for
// each). Products and sums stay apart: a fused multiply-add would give other bits on some machines.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "match/elastic_kernels.cpp"
#include "match/elastic_kernels.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace tandem {
inline namespace v0 {
namespace detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, kBlock>;
using Lanes = hn::Vec<Tag>;

HWY_INLINE std::size_t lanes() {
  return hn::Lanes(Tag());
}

HWY_INLINE Lanes load(const double* p) {
  return hn::LoadU(Tag(), p);
}

HWY_INLINE Lanes all(double x) {
  return hn::Set(Tag(), x);
}

template <EdgeValue kValue>
HWY_INLINE Lanes add_term(Lanes sum, Lanes chord, Lanes weight) {
  if (kValue == EdgeValue::largest) return hn::Max(sum, chord);
  return hn::Add(sum, hn::Mul(weight, chord));
}

template <EdgeValue kValue>
HWY_INLINE void finish(Lanes sum, const double* factor, const double* strain, const EdgeOptions& options,
                       double* out) {
  const Tag d;
  if (kValue == EdgeValue::largest) {
    hn::StoreU(sum, d, out);
  } else if (kValue == EdgeValue::integral) {
    hn::StoreU(hn::Add(hn::Mul(sum, load(factor)), hn::Mul(all(options.lambda), load(strain))), d, out);
  } else {
    // Rounded to a whole number, for what lies below 2^51.
    const Lanes shift = all(6755399441055744.0);  // 1.5 * 2^52
    const Lanes scaled = hn::Mul(hn::Mul(sum, load(factor)), all(options.units));
    const Lanes whole = hn::Sub(hn::Add(scaled, shift), shift);
    const Lanes zero = hn::Zero(d);
    hn::StoreU(hn::IfThenElse(hn::Gt(sum, zero), hn::Max(whole, all(1.0)), zero), d, out);
  }
}

template <EdgeValue kValue>
void integrate_one(const double* HWY_RESTRICT chords, const EdgeTerm* HWY_RESTRICT terms, const EdgeSum* sums,
                   std::size_t count, std::size_t j, const EdgeOptions& options) {
  Lanes sum = all(0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const EdgeSum& s = sums[k];
    if (!s.continues) sum = all(0.0);
    for (std::size_t t = s.first; t < s.last; ++t) {
      sum = add_term<kValue>(sum, load(chords + terms[t].offset + static_cast<std::ptrdiff_t>(j)),
                             all(terms[t].weight));
    }
    finish<kValue>(sum, s.factor + j, s.strain + j, options, s.out + j);
  }
}

/// Two vectors at a time: a sum alone waits for each addition.
template <EdgeValue kValue>
void integrate_two(const double* HWY_RESTRICT chords, const EdgeTerm* HWY_RESTRICT terms, const EdgeSum* sums,
                   std::size_t count, std::size_t j, const EdgeOptions& options) {
  const std::size_t n = lanes();
  Lanes x = all(0.0);
  Lanes y = all(0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const EdgeSum& s = sums[k];
    if (!s.continues) x = y = all(0.0);
    for (std::size_t t = s.first; t < s.last; ++t) {
      const double* chord = chords + terms[t].offset + static_cast<std::ptrdiff_t>(j);
      const Lanes weight = all(terms[t].weight);
      x = add_term<kValue>(x, load(chord), weight);
      y = add_term<kValue>(y, load(chord + n), weight);
    }
    finish<kValue>(x, s.factor + j, s.strain + j, options, s.out + j);
    finish<kValue>(y, s.factor + j + n, s.strain + j + n, options, s.out + j + n);
  }
}

template <EdgeValue kValue>
void integrate_range(const double* chords, const EdgeTerm* terms, const EdgeSum* sums, std::size_t count,
                     std::size_t lo, std::size_t hi, const EdgeOptions& options) {
  const std::size_t n = lanes();
  std::size_t j = lo;
  for (; j + 2 * n <= hi; j += 2 * n) integrate_two<kValue>(chords, terms, sums, count, j, options);
  for (; j < hi; j += n) integrate_one<kValue>(chords, terms, sums, count, j, options);
}

void integrate_edges_lanes(const double* chords, const EdgeTerm* terms, const EdgeSum* sums,
                           std::size_t count, std::size_t lo, std::size_t hi, const EdgeOptions& options) {
  switch (options.value) {
    case EdgeValue::integral:
      return integrate_range<EdgeValue::integral>(chords, terms, sums, count, lo, hi, options);
    case EdgeValue::largest:
      return integrate_range<EdgeValue::largest>(chords, terms, sums, count, lo, hi, options);
    case EdgeValue::invalid:
      return integrate_range<EdgeValue::invalid>(chords, terms, sums, count, lo, hi, options);
  }
}

template <EdgeValue kValue>
void overlap_range(const double* HWY_RESTRICT chords, const EdgeOverlaps& e, std::size_t lo, std::size_t hi,
                   const EdgeOptions& options) {
  const Lanes sliver = all(kSliver);
  for (std::size_t j = lo; j < hi; j += lanes()) {
    const double* spread = e.spread_b + j / kBlock * 2 * static_cast<std::size_t>(e.b + 1);
    Lanes sum = all(0.0);
    int first = 0;  // both sides' shares rise: chords once passed by the whole block stay behind
    for (int p = 0; p < e.a; ++p) {
      const double* row = chords + (p - e.a) * e.row_stride + static_cast<std::ptrdiff_t>(j) - e.b;
      const double begin = e.ends_a[p];
      const double end = e.ends_a[p + 1];
      while (first + 1 < e.b && spread[2 * first + 3] <= begin) ++first;
      const Lanes begins = all(begin);
      const Lanes ends = all(end);
      Lanes next_b = load(e.ends_b[first] + j);
      for (int q = first; q < e.b && spread[2 * q] < end; ++q) {
        const Lanes from = hn::Max(begins, next_b);
        next_b = load(e.ends_b[q + 1] + j);
        const Lanes share = hn::Sub(hn::Min(ends, next_b), from);
        // Left out, not multiplied by 0: a barred chord costs infinity.
        const Lanes next = add_term<kValue>(sum, load(row + q), share);
        sum = hn::IfThenElse(hn::Gt(share, sliver), next, sum);
      }
    }
    finish<kValue>(sum, e.factor + j, e.strain + j, options, e.out + j);
  }
}

void integrate_overlaps_lanes(const double* chords, const EdgeOverlaps& edges, std::size_t lo, std::size_t hi,
                              const EdgeOptions& options) {
  switch (options.value) {
    case EdgeValue::integral:
      return overlap_range<EdgeValue::integral>(chords, edges, lo, hi, options);
    case EdgeValue::largest:
      return overlap_range<EdgeValue::largest>(chords, edges, lo, hi, options);
    case EdgeValue::invalid:
      return overlap_range<EdgeValue::invalid>(chords, edges, lo, hi, options);
  }
}

template <bool kMaximum>
HWY_INLINE Lanes join(Lanes path, Lanes edge) {
  return kMaximum ? hn::Max(path, edge) : hn::Add(path, edge);
}

template <bool kMaximum>
void relax_costs_range(const RelaxStep* steps, std::size_t count, double* HWY_RESTRICT to, std::size_t lo,
                       std::size_t hi) {
  const Tag d;
  const std::size_t n = lanes();
  std::size_t j = lo;
  for (; j + 2 * n <= hi; j += 2 * n) {
    Lanes x = all(std::numeric_limits<double>::infinity());
    Lanes y = x;
    for (std::size_t k = 0; k < count; ++k) {
      const double* from = steps[k].from_cost + j;
      const double* edge = steps[k].edge_cost + j;
      x = hn::Min(x, join<kMaximum>(load(from), load(edge)));
      y = hn::Min(y, join<kMaximum>(load(from + n), load(edge + n)));
    }
    hn::StoreU(x, d, to + j);
    hn::StoreU(y, d, to + j + n);
  }
  for (; j < hi; j += n) {
    Lanes x = all(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < count; ++k) {
      x = hn::Min(x, join<kMaximum>(load(steps[k].from_cost + j), load(steps[k].edge_cost + j)));
    }
    hn::StoreU(x, d, to + j);
  }
}

void relax_costs_lanes(const RelaxStep* steps, std::size_t count, double* to, std::size_t lo, std::size_t hi,
                       bool maximum) {
  if (maximum) return relax_costs_range<true>(steps, count, to, lo, hi);
  relax_costs_range<false>(steps, count, to, lo, hi);
}

/// First the least invalid length, then the least cost among the steps that attain it: two short chains of
/// minima instead of a long one of comparisons.
template <bool kMaximum>
void relax_pairs_range(const RelaxStep* steps, std::size_t count, double* HWY_RESTRICT to_cost,
                       double* HWY_RESTRICT to_invalid, std::size_t lo, std::size_t hi) {
  const Tag d;
  const std::size_t n = lanes();
  const Lanes infinity = all(std::numeric_limits<double>::infinity());
  for (std::size_t j = lo; j < hi; j += n) {
    Lanes invalid = infinity;
    for (std::size_t k = 0; k < count; ++k) {
      invalid = hn::Min(invalid, hn::Add(load(steps[k].from_invalid + j), load(steps[k].edge_invalid + j)));
    }
    Lanes cost = infinity;
    for (std::size_t k = 0; k < count; ++k) {
      const Lanes other = hn::Add(load(steps[k].from_invalid + j), load(steps[k].edge_invalid + j));
      const Lanes joined = join<kMaximum>(load(steps[k].from_cost + j), load(steps[k].edge_cost + j));
      cost = hn::Min(cost, hn::IfThenElse(hn::Eq(other, invalid), joined, infinity));
    }
    hn::StoreU(cost, d, to_cost + j);
    hn::StoreU(invalid, d, to_invalid + j);
  }
}

void relax_pairs_lanes(const RelaxStep* steps, std::size_t count, double* to_cost, double* to_invalid,
                       std::size_t lo, std::size_t hi, bool maximum) {
  if (maximum) return relax_pairs_range<true>(steps, count, to_cost, to_invalid, lo, hi);
  relax_pairs_range<false>(steps, count, to_cost, to_invalid, lo, hi);
}

}  // namespace HWY_NAMESPACE
}  // namespace detail
}  // namespace v0
}  // namespace tandem
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "match/kernel_target.h"

namespace tandem {
inline namespace v0 {
namespace detail {

TANDEM_KERNEL(integrate_edges_lanes);
TANDEM_KERNEL(integrate_overlaps_lanes);
TANDEM_KERNEL(relax_costs_lanes);
TANDEM_KERNEL(relax_pairs_lanes);

void integrate_edges(const double* chords, const EdgeTerm* terms, const EdgeSum* sums, std::size_t count,
                     std::size_t lo, std::size_t hi, const EdgeOptions& options) {
  TANDEM_DISPATCH(integrate_edges_lanes)(chords, terms, sums, count, lo, hi, options);
}

void integrate_overlaps(const double* chords, const EdgeOverlaps& edges, std::size_t lo, std::size_t hi,
                        const EdgeOptions& options) {
  TANDEM_DISPATCH(integrate_overlaps_lanes)(chords, edges, lo, hi, options);
}

void relax_costs(const RelaxStep* steps, std::size_t count, double* to, std::size_t lo, std::size_t hi,
                 bool maximum) {
  TANDEM_DISPATCH(relax_costs_lanes)(steps, count, to, lo, hi, maximum);
}

void relax_pairs(const RelaxStep* steps, std::size_t count, double* to_cost, double* to_invalid,
                 std::size_t lo, std::size_t hi, bool maximum) {
  TANDEM_DISPATCH(relax_pairs_lanes)(steps, count, to_cost, to_invalid, lo, hi, maximum);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
#endif  // HWY_ONCE
