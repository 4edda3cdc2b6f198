#include "match/three_step_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "match/start_costs.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "match/aligned_array.h"

HWY_BEFORE_NAMESPACE();
namespace tandem {
inline namespace v0 {
namespace detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

template <class V>
using Lanes = hn::ScalableTag<V>;

template <class V>
HWY_INLINE std::size_t lane_count() {
  return hn::Lanes(Lanes<V>());
}

/// Vectors of starts that advance together: enough to hide the latency of a sum and a minimum.
template <class V>
constexpr std::size_t kGroups = std::is_integral_v<V> ? 2 : 4;

/// One row of cells, each with a lane per start. `cells` holds the row above and becomes this one.
template <class V, bool kRule>
HWY_INLINE void relax_row(const SkewTable<V>& table, int row, int first, int last, V* cells,
                          bool diagonal_reaches, const StepRule<V>& rule, int start_lane, V start_cost) {
  constexpr std::size_t kCount = kGroups<V>;
  const Lanes<V> d;
  const std::size_t lanes = lane_count<V>();
  const std::size_t cell_size = kCount * lanes;
  const auto none = hn::Set(d, kUnreachable<V>);
  const auto charged = hn::Set(d, rule.charge);
  const bool double_diagonal = rule.double_diagonal;
  // Cell (i,j) lies in row (i + j) mod period of the table: one row further with every column.
  const int period = table.rows();
  int e = (row + first) % period;
  const V* costs = table.diagonal(static_cast<std::size_t>(e)) + first;
  const std::size_t stride = table.stride() + 1;
  const std::size_t lap = static_cast<std::size_t>(period) * table.stride();
  V* cell = cells + static_cast<std::size_t>(first) * cell_size;
  hn::Vec<Lanes<V>> left[kCount];
  hn::Vec<Lanes<V>> diagonal[kCount];
  for (std::size_t g = 0; g < kCount; ++g) {
    left[g] = none;
    diagonal[g] = diagonal_reaches ? hn::Load(d, cell - cell_size + g * lanes) : none;
  }
  for (int j = first; j <= last; ++j, cell += cell_size) {
    const auto cost = hn::Set(d, *costs);
    costs += stride;
    if (++e == period) {
      e = 0;
      costs -= lap;
    }
    for (std::size_t g = 0; g < kCount; ++g) {
      const auto above = hn::Load(d, cell + g * lanes);
      auto up = above;
      if constexpr (kRule) {
        if (double_diagonal) diagonal[g] = hn::Add(diagonal[g], cost);
        up = hn::Add(up, charged);
        left[g] = hn::Add(left[g], charged);
      }
      left[g] = hn::Add(hn::Min(left[g], hn::Min(diagonal[g], up)), cost);
      diagonal[g] = above;
      hn::Store(left[g], d, cell + g * lanes);
    }
    if (j == 0 && start_lane >= 0) {
      cell[start_lane] = start_cost;
      for (std::size_t g = 0; g < kCount; ++g) left[g] = hn::Load(d, cell + g * lanes);
    }
  }
}

template <class V, bool kRule>
void costs_of_starts(const PathFamily<V>& family, int k, const Channel& channel, std::span<V> costs) {
  const SkewTable<V>& table = *family.table;
  const std::size_t cell_size = kGroups<V> * lane_count<V>();
  const int width = table.width();
  const int starts = static_cast<int>(costs.size());
  AlignedArray<V> cells(static_cast<std::size_t>(width) * cell_size, kUnreachable<V>);
  int previous_first = 0;
  int previous_last = -1;
  for (int i = k; i < k + starts - 1 + family.rows; ++i) {
    const int first = channel.first_column(i);
    const int last = channel.last_column(i, width);
    // Cells that the row above did not reach.
    std::fill(cells.data() + cell_size * static_cast<std::size_t>(previous_last + 1),
              cells.data() + cell_size * static_cast<std::size_t>(last + 1), kUnreachable<V>);
    const bool starting = i < k + starts;
    const V start_cost =
        family.count_start ? table.diagonal(static_cast<std::size_t>(i % table.rows()))[0] : V{0};
    relax_row<V, kRule>(table, i, first, last, cells.data(), first > previous_first, family.rule,
                        starting ? i - k : -1, start_cost);
    if (i >= k + family.rows - 1) {
      const auto lane = static_cast<std::size_t>(i - (k + family.rows - 1));
      costs[lane] =
          last == width - 1 ? cells[static_cast<std::size_t>(width - 1) * cell_size + lane] : kUnreachable<V>;
    }
    previous_first = first;
    previous_last = last;
  }
}

template <class V>
void costs_in_table(const PathFamily<V>& family, int k, const Channel& channel, std::span<V> costs) {
  if (family.rule.is_plain()) {
    costs_of_starts<V, false>(family, k, channel, costs);
  } else {
    costs_of_starts<V, true>(family, k, channel, costs);
  }
}

void costs_real(const PathFamily<double>& family, int k, const Channel& channel, std::span<double> costs) {
  costs_in_table(family, k, channel, costs);
}
void costs_fixed(const PathFamily<std::int32_t>& family, int k, const Channel& channel,
                 std::span<std::int32_t> costs) {
  costs_in_table(family, k, channel, costs);
}
int lanes_real() {
  return static_cast<int>(kGroups<double> * lane_count<double>());
}
int lanes_fixed() {
  return static_cast<int>(kGroups<std::int32_t> * lane_count<std::int32_t>());
}

}  // namespace
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

namespace {

TANDEM_KERNEL(costs_real);
TANDEM_KERNEL(costs_fixed);
TANDEM_KERNEL(lanes_real);
TANDEM_KERNEL(lanes_fixed);

}  // namespace

int start_lanes(double) {
  return TANDEM_DISPATCH(lanes_real)();
}
int start_lanes(std::int32_t) {
  return TANDEM_DISPATCH(lanes_fixed)();
}

void start_costs(const PathFamily<double>& family, int k, const Channel& channel, std::span<double> costs) {
  TANDEM_DISPATCH(costs_real)(family, k, channel, costs);
}
void start_costs(const PathFamily<std::int32_t>& family, int k, const Channel& channel,
                 std::span<std::int32_t> costs) {
  TANDEM_DISPATCH(costs_fixed)(family, k, channel, costs);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
#endif
