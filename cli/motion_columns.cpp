#include "motion_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

#include "tandem/error.h"

namespace cli {
namespace {

using tandem::CsvTable;

// Names that a warning lists at most.
constexpr std::size_t kMostNamed = 6;

/// Of the values.
std::span<const std::string> names_of(const CsvTable& table) {
  return std::span(table.columns).subspan(1);
}

std::string list(std::span<const std::string> names) {
  const std::size_t shown = std::min(names.size(), kMostNamed);
  return fmt::format("{}{}", fmt::join(names.first(shown), ", "), shown < names.size() ? ", ..." : "");
}

/// Which column of `names` has each of the names wanted; nothing unless both have the same, each once.
std::optional<std::vector<std::size_t>> order_of(std::span<const std::string> wanted,
                                                 std::span<const std::string> names) {
  std::vector<std::size_t> order;
  for (const std::string& name : wanted) {
    if (std::count(names.begin(), names.end(), name) != 1) return std::nullopt;
    order.push_back(static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()));
  }
  std::vector<std::size_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return std::nullopt;
  return order;
}

void reorder(CsvTable& table, const std::vector<std::size_t>& order) {
  const tandem::Points& from = table.curve.control_points();
  tandem::Points points(from.dim(), from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t k = 0; k < order.size(); ++k) points[i][k] = from[i][order[k]];
  }
  table.curve = tandem::Curve(table.curve.degree(), table.curve.knots(), std::move(points));
  const std::vector<std::string> columns = table.columns;
  for (std::size_t k = 0; k < order.size(); ++k) table.columns[k + 1] = columns[order[k] + 1];
}

}  // namespace

void pair_columns(std::vector<CsvTable>& tables, const std::vector<std::string>& files,
                  const Messages& messages) {
  const CsvTable& first = tables.front();
  const std::span<const std::string> wanted = names_of(first);
  for (std::size_t i = 1; i < tables.size(); ++i) {
    CsvTable& table = tables[i];
    if (table.curve.dim() != first.curve.dim()) {
      throw tandem::InvalidArgument(fmt::format("{} has {} columns of values, expected {} as in {}", files[i],
                                                table.curve.dim(), first.curve.dim(), files[0]));
    }
    const std::span<const std::string> names = names_of(table);
    if (!first.named || !table.named || std::equal(wanted.begin(), wanted.end(), names.begin())) continue;
    if (const auto order = order_of(wanted, names)) {
      reorder(table, *order);
      messages.note(
          fmt::format("the columns of {} stand in another order than those of {}: paired by their names",
                      files[i], files[0]));
      continue;
    }
    messages.warning(fmt::format(
        "{} has the columns {}, {} has {}: other names, so they are paired in the order in which they stand",
        files[0], list(wanted), files[i], list(names)));
  }
}

}  // namespace cli
