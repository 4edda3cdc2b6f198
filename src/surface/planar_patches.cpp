#include "surface/planar_patches.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "surface/cells.h"
#include "surface/enclosed_surface.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Collects what the pieces say of the sign.
class SignScan {
 public:
  explicit SignScan(const EnclosedSurface& surface) : surface_(surface) {}

  bool decide(const CellPiece& piece) {
    const BernsteinGrid& j = piece.normal.front();
    if (const int sign = common_sign(j.coefficients); sign != 0) {
      note(sign, piece);
      note_zeros(piece);
      return true;
    }
    const auto& all = j.coefficients;
    if (!std::all_of(all.begin(), all.end(), [](const Enclosure& c) { return c.is_zero(); })) return false;
    if (!zero_) zero_ = piece.middle();
    return true;
  }

  [[nodiscard]] bool has_both_signs() const noexcept { return best_[0].size > 0.0 && best_[1].size > 0.0; }

  [[nodiscard]] Findings conclude(bool all_decided) const {
    Findings result;
    if (has_both_signs() && has_sign(best_[0].place, 1) && has_sign(best_[1].place, -1)) {
      const std::size_t rarer = best_[0].area < best_[1].area ? 0 : 1;
      result.sign_change(best_[rarer].place, rarer == 0 ? 1 : -1, best_[1 - rarer].place);
    } else if (zero_) {
      result.zero(*zero_);
    } else if (all_decided && !has_both_signs()) {
      result.regular = Verdict::certified;
    }
    return result;
  }

 private:
  struct Best {
    Parameters place{};
    double size = 0.0;
    double area = 0.0;  // of all cells with that sign
  };

  void note(int sign, const CellPiece& piece) {
    Best& best = best_[sign > 0 ? 0 : 1];
    best.area += piece.cell[0].length() * piece.cell[1].length();
    const auto& all = piece.normal.front().coefficients;
    const double size = std::abs(all[all.size() / 2].middle());
    if (best.size > 0.0 && !(size > best.size)) return;
    best.size = std::max(size, std::numeric_limits<double>::min());
    best.place = piece.middle();
  }

  // Coefficients of one sign, or zero: the zeros reach a corner if there are any.
  void note_zeros(const CellPiece& piece) {
    const BernsteinGrid& j = piece.normal.front();
    for (const bool u_end : {false, true}) {
      for (const bool v_end : {false, true}) {
        if (zero_ || !j.at(u_end ? j.rows - 1 : 0, v_end ? j.columns - 1 : 0).is_zero()) continue;
        zero_ = Parameters{u_end ? piece.cell[0].hi : piece.cell[0].lo,
                           v_end ? piece.cell[1].hi : piece.cell[1].lo};
      }
    }
  }

  // Proved anew for just these doubles, which the dyadic parts of a patch are only nearly.
  [[nodiscard]] bool has_sign(const Parameters& place, int sign) const {
    Cell cell;
    for (const std::size_t along : {0U, 1U}) {
      const std::vector<double>& breaks = surface_.breaks()[along];
      cell[along] = {*std::prev(std::lower_bound(breaks.begin(), breaks.end(), place[along])), place[along]};
    }
    const Enclosure value = surface_.normal(cell).front().coefficients.back();
    return sign > 0 ? value.is_positive() : value.is_negative();
  }

  const EnclosedSurface& surface_;
  std::array<Best, 2> best_;  // positive, negative
  std::optional<Parameters> zero_;
};

std::vector<BoundaryLoop> boundary_of(const EnclosedSurface& enclosed, const Surface& surface) {
  const auto edge = [&](std::size_t along, bool at_end, bool reversed) {
    const Interval across = surface.domain(along == 0 ? Along::v : Along::u);
    return BoundaryEdge{enclosed.edge(along, at_end), surface.is_rational(), reversed,
                        along == 0 ? Along::u : Along::v, at_end ? across.hi : across.lo};
  };
  if (surface.is_closed(Along::u)) {
    // A ring, or a disk if one edge is a pole: what is said of simple boundaries holds for it, too.
    std::vector<BoundaryLoop> loops;
    for (const bool at_end : {false, true}) {
      if (!enclosed.is_pole(1, at_end)) loops.push_back({edge(0, at_end, false)});
    }
    return loops;
  }
  BoundaryLoop loop;
  // Counter-clockwise round the domain. The edge along one parameter is a pole of the other.
  if (!enclosed.is_pole(1, false)) loop.push_back(edge(0, false, false));
  if (!enclosed.is_pole(0, true)) loop.push_back(edge(1, true, false));
  if (!enclosed.is_pole(1, true)) loop.push_back(edge(0, true, true));
  if (!enclosed.is_pole(0, false)) loop.push_back(edge(1, false, true));
  if (loop.empty()) return {};
  return {std::move(loop)};
}

}  // namespace

Findings examine_planar_patches(const Surface& surface) {
  constexpr int kDepthOfWitnesses = 4;  // a wider search makes better witnesses
  const EnclosedSurface enclosed(surface);
  SignScan scan(enclosed);
  const bool all_decided = search_cells(
      enclosed, [&](const CellPiece& piece) { return scan.decide(piece); },
      [&](int depth) { return depth > kDepthOfWitnesses && scan.has_both_signs(); });
  Findings result = scan.conclude(all_decided);
  if (result.witness == WitnessKind::sign_change) return result;
  const std::vector<BoundaryLoop> loops = boundary_of(enclosed, surface);
  result.one_to_one = Verdict::undecided;
  if (!loops.empty()) result.boundary(find_simple(loops), result.regular == Verdict::certified);
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
