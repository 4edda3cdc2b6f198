#include "surface/cells.h"

namespace tandem {
inline namespace v0 {
namespace detail {

std::vector<CellPiece> CellPiece::halves() const {
  std::array<double, 2> varies{};
  for (const std::size_t along : {0U, 1U}) {
    for (const BernsteinGrid& n : normal) varies[along] += variation(n, along);
  }
  std::size_t along = varies[0] >= varies[1] ? 0 : 1;
  if (!can_split(along)) along = 1 - along;
  if (!can_split(along)) return {};
  std::vector<CellPiece> result(2);
  const double at = middle()[along];
  result[0].cell = result[1].cell = cell;
  result[0].cell[along].hi = result[1].cell[along].lo = at;
  for (const BernsteinGrid& n : normal) {
    auto [low, high] = detail::halves(n, along);
    result[0].normal.push_back(std::move(low));
    result[1].normal.push_back(std::move(high));
  }
  return result;
}

std::vector<CellPiece> whole_patches(const EnclosedSurface& surface) {
  std::vector<CellPiece> result;
  const auto& [along_u, along_v] = surface.breaks();
  for (std::size_t i = 0; i + 1 < along_u.size(); ++i) {
    for (std::size_t j = 0; j + 1 < along_v.size(); ++j) {
      const Cell cell = {Interval{along_u[i], along_u[i + 1]}, Interval{along_v[j], along_v[j + 1]}};
      result.push_back({surface.normal(cell), cell});
    }
  }
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
