#include "match/three_step_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "match/three_step_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace tandem {
inline namespace v0 {
namespace detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

template <class V>
using Lanes = hn::ScalableTag<V>;

/// Unsigned numbers of half a V's width.
template <class V>
using HalfAsWide = std::conditional_t<sizeof(V) == 8, std::uint32_t, std::uint16_t>;

template <class V>
HWY_INLINE std::size_t lane_count() {
  return hn::Lanes(Lanes<V>());
}

/// First and last column per row of a window within a channel; one row more at the end, which is full.
class Window {
 public:
  Window(const Channel& channel, int start, int rows, int width) {
    const auto n = static_cast<std::size_t>(rows);
    first_.assign(n + 1, 0);
    last_.assign(n + 1, width - 1);
    first_[n] = width;
    for (std::size_t i = 0; i < n && channel.below != nullptr; ++i)
      first_[i] = channel.first_column(start + static_cast<int>(i));
    for (std::size_t i = 0; i < n && channel.above != nullptr; ++i)
      last_[i] = channel.last_column(start + static_cast<int>(i), width);
  }

  HWY_INLINE int first(int row) const { return first_[static_cast<std::size_t>(row)]; }
  HWY_INLINE int last(int row) const { return last_[static_cast<std::size_t>(row)]; }

 private:
  std::vector<int> first_;
  std::vector<int> last_;
};

/// The columns of the antidiagonals of a window, one after the other: each bound moves by one column at most.
/// Without branches, since nothing is harder to predict than a path.
class DiagonalSpan {
 public:
  explicit DiagonalSpan(const Window& window) : window_(window) {}

  HWY_INLINE int first() const { return first_; }
  HWY_INLINE int last() const { return last_; }

  HWY_INLINE void next() {
    last_ += last_ < window_.last(d_ - last_) ? 1 : 0;
    ++d_;
    // The cell under the outermost one, else the one beside it.
    first_ += first_ < window_.first(d_ - first_) ? 1 : 0;
  }

 private:
  const Window& window_;
  int d_ = 0;
  int first_ = 0;
  int last_ = 0;
};

/// Moves of a path's cells, as two bits each: whether the best predecessor is the diagonal one, and whether
/// it is the left one.
template <class V>
class Moves {
 public:
  static constexpr std::size_t kLanes = hn::MaxLanes(Lanes<V>());
  static constexpr std::size_t kVectorBytes = kLanes < 4 ? 1 : kLanes / 4;

  explicit Moves(std::size_t diagonals) { rows_.reserve(diagonals); }

  /// Room for an antidiagonal whose columns begin at `first`.
  HWY_INLINE std::uint8_t* add(std::size_t first, std::size_t vectors) {
    const std::size_t size = vectors * kVectorBytes;
    if (HWY_UNLIKELY(size > left_)) grow(size);
    std::uint8_t* const bits = next_;
    next_ += size;
    left_ -= size;
    rows_.push_back({bits, first});
    return bits;
  }
  /// Nodes from the last cell back to the first, in order, in rows and columns of the family.
  [[nodiscard]] std::vector<Node> backtrack(int k, int rows, int width) const {
    std::vector<Node> nodes;
    nodes.reserve(static_cast<std::size_t>(rows + width));
    int i = rows - 1;
    int j = width - 1;
    for (;;) {
      nodes.push_back({k + i, j});
      if (i == 0 && j == 0) break;
      const Row& row = rows_[static_cast<std::size_t>(i + j)];
      const auto at = static_cast<std::size_t>(j) - row.first;
      const std::uint8_t* bits = row.bits + at / kLanes * kVectorBytes;
      const std::size_t lane = at % kLanes;
      const auto bit = [&](std::size_t n) { return (bits[n / 8] >> (n % 8)) & 1; };
      // As store_moves leaves them.
      const bool diagonal = bit(kLanes < 8 ? 2 * lane : lane) != 0;
      const bool left = !diagonal && bit(kLanes < 8 ? 2 * lane + 1 : kLanes + lane) != 0;
      if (!left) --i;
      if (diagonal || left) --j;
    }
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

 private:
  struct Row {
    const std::uint8_t* bits;
    std::size_t first;
  };

  /// In chunks, each as large as all before it up to a limit: nothing is copied, little is left over.
  void grow(std::size_t size) {
    constexpr std::size_t kFirst = 4096;
    constexpr std::size_t kLargest = std::size_t{1} << 20;
    // StoreMaskBits may write 8 bytes.
    constexpr std::size_t kSlack = 8;
    const std::size_t chunk = std::max(size, std::clamp(total_, kFirst, kLargest));
    chunks_.push_back(std::make_unique_for_overwrite<std::uint8_t[]>(chunk + kSlack));
    total_ += chunk;
    next_ = chunks_.back().get();
    left_ = chunk;
  }

  std::uint8_t* next_ = nullptr;
  std::size_t left_ = 0;
  std::size_t total_ = 0;
  std::vector<std::unique_ptr<std::uint8_t[]>> chunks_;
  std::vector<Row> rows_;
};

/// The moves of one vector. Wide ones: the bits of one kind, then those of the other; narrow ones by turns,
/// so that they fit in a byte.
template <class V, class Mask>
HWY_INLINE void store_moves(Mask diagonal, Mask left, std::uint8_t* bits) {
  const Lanes<V> d;
#if HWY_TARGET == HWY_SCALAR
  std::uint8_t both[2];
  hn::StoreMaskBits(d, diagonal, both);
  hn::StoreMaskBits(d, left, both + 1);
  *bits = static_cast<std::uint8_t>((both[0] & 1) | (both[1] & 1) << 1);
#else
  if constexpr (hn::MaxLanes(d) < 8) {
    const hn::Repartition<HalfAsWide<V>, decltype(d)> halves;
    const auto even = hn::BitCast(halves, hn::VecFromMask(d, diagonal));
    const auto odd = hn::BitCast(halves, hn::VecFromMask(d, left));
    hn::StoreMaskBits(halves, hn::MaskFromVec(hn::OddEven(odd, even)), bits);
  } else {
    hn::StoreMaskBits(d, diagonal, bits);
    hn::StoreMaskBits(d, left, bits + hn::Lanes(d) / 8);
  }
#endif
}

/// One antidiagonal: cells first .. last from the two before it, in whole aligned vectors from column
/// `aligned` on. The cells beside them become unreachable; what else a vector covers is never read.
template <class V, bool kRule>
HWY_INLINE void relax_diagonal(const V* costs, const V* before2, const V* before1, V* out,
                               std::size_t aligned, int first, int last, const StepRule<V>& rule,
                               std::uint8_t* bits) {
  const Lanes<V> d;
  const std::size_t lanes = lane_count<V>();
  const auto charged = hn::Set(d, rule.charge);
  const auto cell = [&](std::size_t j) HWY_ATTR {
    const auto cost = hn::Load(d, costs + j);
    auto diagonal = hn::LoadU(d, before2 + j - 1);
    auto left = hn::LoadU(d, before1 + j - 1);
    auto up = hn::Load(d, before1 + j);
    if constexpr (kRule) {
      if (rule.double_diagonal) diagonal = hn::Add(diagonal, cost);
      left = hn::Add(left, charged);
      up = hn::Add(up, charged);
    }
    const auto best = hn::Min(left, hn::Min(diagonal, up));
    store_moves<V>(hn::Eq(best, diagonal), hn::Eq(best, left), bits);
    bits += Moves<V>::kVectorBytes;
    return hn::Add(best, cost);
  };
  const auto end = static_cast<std::size_t>(last + 1);
  std::size_t j = aligned;
  for (; j + lanes <= end; j += lanes) hn::Store(cell(j), d, out + j);
  hn::Store(hn::IfThenElse(hn::FirstN(d, end - j), cell(j), hn::Set(d, kUnreachable<V>)), d, out + j);
  out[static_cast<std::size_t>(first) - 1] = kUnreachable<V>;
}

/// The antidiagonals of a window of a skewed table, one after the other.
template <class V>
class TableDiagonals {
 public:
  TableDiagonals(const SkewTable<V>& table, int first_row)
      : table_(table), e_(static_cast<std::size_t>(first_row % table.rows())) {}

  HWY_INLINE const V* next() {
    const V* row = table_.diagonal(e_);
    e_ = e_ + 1 == static_cast<std::size_t>(table_.rows()) ? 0 : e_ + 1;
    return row;
  }

 private:
  const SkewTable<V>& table_;
  std::size_t e_;
};

/// The antidiagonals of an open table that is stored by rows, turned round a few at a time: a whole skewed
/// copy of a large table would not fit in memory beside it.
class StreamedDiagonals {
 public:
  explicit StreamedDiagonals(const LexicographicNodes& nodes)
      : nodes_(nodes), stride_(nodes.cols() + 2 * kLine), block_(kBlock * stride_, 0.0) {
    stride_ = stride_ / kLine * kLine;
  }

  HWY_INLINE const double* next() {
    if (d_ % kBlock == 0) fill();
    return block_.data() + d_++ % kBlock * stride_;
  }

 private:
  static constexpr std::size_t kLine = 64 / sizeof(double);
  static constexpr std::size_t kBlock = 16;

  /// Antidiagonals d .. d + kBlock - 1: of each row, the cells that lie on them.
  void fill() {
    const std::size_t cols = nodes_.cols();
    const std::size_t from = d_ + 1 > cols ? d_ + 1 - cols : 0;
    const std::size_t to = std::min(nodes_.rows(), d_ + kBlock);
    for (std::size_t i = from; i < to; ++i) {
      const std::size_t first = i > d_ ? i - d_ : 0;
      const std::size_t last = std::min(kBlock, cols + i - d_);
      // One antidiagonal and one column further with every cell.
      const std::size_t column = d_ + first - i;
      nodes_.copy(i, column, last - first, block_.data() + first * stride_ + column, stride_ + 1);
    }
  }

  const LexicographicNodes& nodes_;
  std::size_t stride_;
  AlignedArray<double> block_;
  std::size_t d_ = 0;
};

/// The window's shape and what its steps cost.
template <class V>
struct TraceTask {
  int first_row = 0;
  int rows = 0;
  int width = 0;
  bool count_start = false;
  StepRule<V> rule = {};
};

template <class V, bool kRule, class Diagonals>
TracedCost<V> trace(const TraceTask<V>& task, Diagonals& source, const Channel& channel) {
  const std::size_t lanes = lane_count<V>();
  const int width = task.width;
  const int diagonals = task.rows + width - 1;
  // A line before the first column, and one behind the last.
  const std::size_t line = std::max(lanes, 64 / sizeof(V));
  const std::size_t size = (static_cast<std::size_t>(width) / line + 3) * line;
  AlignedArray<V> buffer(3 * size, kUnreachable<V>);
  V* before2 = buffer.data() + line;
  V* before1 = before2 + size;
  V* out = before1 + size;
  Moves<V> moves(static_cast<std::size_t>(diagonals));
  const Window window(channel, task.first_row, task.rows, width);
  DiagonalSpan span(window);
  moves.add(0, 0);
  const V start = source.next()[0];
  out[0] = task.count_start ? start : V{0};
  for (int d = 1; d < diagonals; ++d) {
    V* const oldest = before2;
    before2 = before1;
    before1 = out;
    out = oldest;
    span.next();
    const std::size_t aligned = static_cast<std::size_t>(span.first()) / lanes * lanes;
    const std::size_t vectors = (static_cast<std::size_t>(span.last() + 1) - aligned) / lanes + 1;
    std::uint8_t* bits = moves.add(aligned, vectors);
    relax_diagonal<V, kRule>(source.next(), before2, before1, out, aligned, span.first(), span.last(),
                             task.rule, bits);
  }
  TracedCost<V> traced;
  traced.cost = out[width - 1];
  if (traced.cost < kUnreachable<V>) traced.nodes = moves.backtrack(task.first_row, task.rows, width);
  return traced;
}

template <class V>
TracedCost<V> trace_table(const PathFamily<V>& family, int k, const Channel& channel) {
  TableDiagonals<V> source(*family.table, k);
  const TraceTask<V> task{k, family.rows, family.table->width(), family.count_start, family.rule};
  return family.rule.is_plain() ? trace<V, false>(task, source, channel)
                                : trace<V, true>(task, source, channel);
}

TracedCost<double> trace_real(const PathFamily<double>& family, int k, const Channel& channel) {
  return trace_table(family, k, channel);
}
TracedCost<std::int32_t> trace_fixed(const PathFamily<std::int32_t>& family, int k, const Channel& channel) {
  return trace_table(family, k, channel);
}
TracedCost<double> trace_streamed(const LexicographicNodes& nodes) {
  StreamedDiagonals source(nodes);
  const TraceTask<double> task{0, static_cast<int>(nodes.rows()), static_cast<int>(nodes.cols()), true, {}};
  return trace<double, false>(task, source, {});
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

TANDEM_KERNEL(trace_real);
TANDEM_KERNEL(trace_fixed);
TANDEM_KERNEL(trace_streamed);

}  // namespace

TracedCost<double> trace_path(const PathFamily<double>& family, int k, const Channel& channel) {
  return TANDEM_DISPATCH(trace_real)(family, k, channel);
}
TracedCost<std::int32_t> trace_path(const PathFamily<std::int32_t>& family, int k, const Channel& channel) {
  return TANDEM_DISPATCH(trace_fixed)(family, k, channel);
}
TracedCost<double> trace_open(const LexicographicNodes& nodes) {
  return TANDEM_DISPATCH(trace_streamed)(nodes);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
#endif
