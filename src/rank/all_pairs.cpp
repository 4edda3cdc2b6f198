#include "tandem/rank/all_pairs.h"

#include <tbb/info.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>

#include "match/parallel_for.h"
#include "rank/fnv.h"
#include "tandem/version.h"

namespace tandem {
inline namespace v0 {

namespace {

/// An order on content, so that it does not matter where in a corpus the two stand.
bool precedes(const ShapeDescriptor& x, const ShapeDescriptor& y) {
  if (x.size() != y.size()) return x.size() < y.size();
  if (x.lengths() != y.lengths()) return x.lengths() < y.lengths();
  const auto a = x.tangents().data();
  const auto b = y.tangents().data();
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// The comparers of one tile, made when they are first needed.
class Comparers {
 public:
  Comparers(std::span<const ShapeDescriptor> shapes, const PairTile& tile, const CompareOptions& options)
      : shapes_(shapes),
        tile_(tile),
        options_(options),
        rows_(tile.row_end - tile.row),
        columns_(tile.column_end - tile.column) {}

  [[nodiscard]] double cost(std::size_t i, std::size_t j) {
    const bool forward = precedes(shapes_[i], shapes_[j]);
    const ShapeComparer& comparer =
        forward ? made(rows_[i - tile_.row], i) : made(columns_[j - tile_.column], j);
    const ShapeDescriptor& candidate = shapes_[forward ? j : i];
    if (!comparer.is_comparable(candidate)) return std::numeric_limits<double>::quiet_NaN();
    return comparer.compare(candidate)->cost;
  }

 private:
  const ShapeComparer& made(std::optional<ShapeComparer>& comparer, std::size_t shape) {
    if (!comparer) comparer.emplace(shapes_[shape], options_);
    return *comparer;
  }

  std::span<const ShapeDescriptor> shapes_;
  const PairTile& tile_;
  const CompareOptions& options_;
  std::vector<std::optional<ShapeComparer>> rows_;
  std::vector<std::optional<ShapeComparer>> columns_;
};

/// Nothing when keep_going() said no.
template <class KeepGoing>
std::optional<std::vector<double>> tile_costs(std::span<const ShapeDescriptor> shapes, const PairTile& tile,
                                              const CompareOptions& options, const KeepGoing& keep_going) {
  Comparers comparers(shapes, tile, options);
  std::vector<double> costs;
  costs.reserve(tile.pairs());
  for (std::size_t i = tile.row; i < tile.row_end; ++i) {
    for (std::size_t j = std::max(tile.column, i + 1); j < tile.column_end; ++j) {
      if (!keep_going()) return std::nullopt;
      costs.push_back(comparers.cost(i, j));
    }
  }
  return costs;
}

}  // namespace

bool all_pairs(std::span<const ShapeDescriptor> shapes, const TileSource& source, const TileSink& sink,
               const AllPairsOptions& options) {
  const PairTiles tiles(shapes.size());
  std::mutex mutex;  // source and sink
  std::atomic<bool> stopped = false;
  std::atomic<std::size_t> done = 0;
  const auto keep_going = [&] {
    if (stopped) return false;
    const double fraction = static_cast<double>(done) / static_cast<double>(tiles.size());
    if (options.progress && !options.progress(fraction)) stopped = true;
    return !stopped;
  };
  const auto next = [&]() -> std::optional<std::size_t> {
    const std::lock_guard lock(mutex);
    return stopped ? std::nullopt : source();
  };
  const auto work = [&] {
    while (const std::optional<std::size_t> index = next()) {
      const std::optional<std::vector<double>> costs =
          tile_costs(shapes, tiles.tile(*index), options.compare, keep_going);
      if (!costs) return;
      const std::lock_guard lock(mutex);
      sink(*index, *costs);
      ++done;
    }
  };
  const int most = tbb::info::default_concurrency();
  const int workers = options.threads > 0 ? std::min(options.threads, most) : most;
  detail::parallel_for(workers, workers, [&](int) {
    try {
      work();
    } catch (...) {
      stopped = true;  // the others need not go on to the end of their tiles
      throw;
    }
  });
  return !stopped;
}

CostMatrix all_pairs(std::span<const ShapeDescriptor> shapes, const AllPairsOptions& options) {
  const PairTiles tiles(shapes.size());
  CostMatrix matrix{shapes.size(), std::vector<double>(shapes.size() * shapes.size(), 0.0), false};
  std::size_t next = 0;
  const TileSource source = [&]() -> std::optional<std::size_t> {
    if (next == tiles.size()) return std::nullopt;
    return next++;
  };
  const TileSink sink = [&](std::size_t index, std::span<const double> costs) {
    const PairTile tile = tiles.tile(index);
    auto cost = costs.begin();
    for (std::size_t i = tile.row; i < tile.row_end; ++i) {
      for (std::size_t j = std::max(tile.column, i + 1); j < tile.column_end; ++j, ++cost) {
        matrix.costs[i * matrix.size + j] = *cost;
        matrix.costs[j * matrix.size + i] = *cost;
      }
    }
  };
  if (!all_pairs(shapes, source, sink, options)) return {shapes.size(), {}, true};
  return matrix;
}

std::uint64_t all_pairs_digest(std::span<const ShapeDescriptor> shapes, const CompareOptions& options) {
  detail::Fnv digest;
  for (const char c : version()) digest.add_word(static_cast<std::uint64_t>(c));
  digest.add_word(static_cast<std::uint64_t>(options.cost));
  digest.add_word((options.rotate ? 1U : 0U) | (options.mirror ? 2U : 0U));
  digest.add_number(options.charge);
  digest.add_word(shapes.size());
  for (const ShapeDescriptor& shape : shapes) {
    digest.add_word(shape.is_closed() ? 1U : 0U);
    digest.add_word(static_cast<std::uint64_t>(shape.dim()));
    digest.add_word(shape.size());
    for (const double x : shape.tangents().data()) digest.add_number(x);
    for (const double x : shape.lengths()) digest.add_number(x);
  }
  return digest.value();
}

}  // namespace v0
}  // namespace tandem
