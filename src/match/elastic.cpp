#include "tandem/match/elastic.h"

#include <limits>

#include "match/elastic_programme.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

EdgeTable edge_costs(const Samples& a, const Samples& b, const NodeTable& chord_costs,
                     const ElasticOptions& options, Aggregate aggregate, const Progress& progress) {
  detail::EdgeRows edges(a, b, chord_costs, options, aggregate);
  edges.hold(detail::Counting::counted, std::numeric_limits<double>::infinity());
  EdgeTable table;
  table.rows = a.size();
  table.cols = b.size();
  table.rows_cyclic = a.cyclic;
  table.cols_cyclic = b.cyclic;
  table.steps = edges.steps();
  table.cost.assign(table.rows * table.cols * table.steps.size(), std::numeric_limits<double>::infinity());
  table.invalid.assign(table.cost.size(), 0.0);
  for (int i = 0; i < edges.rows(); ++i) {
    if (progress && !progress(static_cast<double>(i) / edges.rows())) break;
    const detail::EdgeRows::Row row = edges.row(i, {0, edges.stride()});
    for (std::size_t s = 0; s < table.steps.size(); ++s) {
      if (!table.rows_cyclic && table.steps[s].a > i) continue;
      for (int x = 0; x < edges.width(); ++x) {
        const std::size_t from = s * static_cast<std::size_t>(edges.stride()) + static_cast<std::size_t>(x);
        const std::size_t to = table.index(static_cast<std::size_t>(i), s,
                                           static_cast<std::size_t>((x + edges.first_col()) % edges.cols()));
        table.cost[to] = row.cost[from];
        table.invalid[to] =
            row.cost[from] < std::numeric_limits<double>::infinity() ? row.invalid[from] : 0.0;
      }
    }
  }
  return table;
}

Path elastic_path(const Samples& a, const Samples& b, const NodeTable& chord_costs,
                  const ElasticOptions& options, Aggregate aggregate, const Progress& progress,
                  const Path* beat) {
  if (b.cyclic && !a.cyclic) {
    throw InvalidArgument("the second curve is a loop and the first is not: exchange them");
  }
  detail::EdgeRows edges(a, b, chord_costs, options, aggregate);
  return detail::best_elastic_path(edges, aggregate, nullptr, progress, beat);
}

}  // namespace v0
}  // namespace tandem
