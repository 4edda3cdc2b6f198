#include "surface/regular_in_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "surface/cells.h"
#include "surface/enclosed_surface.h"
#include "surface/singular_point.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

using Vector3 = std::array<double, 3>;

Vector3 coefficient(const CellPiece& piece, std::size_t k) noexcept {
  Vector3 result{};
  for (std::size_t c = 0; c < 3; ++c) result[c] = piece.normal[c].coefficients[k].middle();
  const double length = std::sqrt(result[0] * result[0] + result[1] * result[1] + result[2] * result[2]);
  if (!(length > 0.0 && std::isfinite(length))) return {};
  for (double& x : result) x /= length;
  return result;
}

double dot(const Vector3& a, const Vector3& b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void add(Vector3& sum, const Vector3& term) noexcept {
  for (std::size_t c = 0; c < 3; ++c) sum[c] += term[c];
}

// A direction that all coefficients point along, if a few corrections of their mean find one (the
// perceptron's rule); a guess, to be proved.
std::optional<Vector3> common_direction(const CellPiece& piece) {
  constexpr int kCorrections = 8;  // cells where more are needed are better halved
  const std::size_t count = piece.normal.front().coefficients.size();
  std::vector<Vector3> directions(count);
  Vector3 n{};
  for (std::size_t k = 0; k < count; ++k) {
    directions[k] = coefficient(piece, k);
    add(n, directions[k]);
  }
  for (int i = 0; i < kCorrections; ++i) {
    const auto worst = std::min_element(directions.begin(), directions.end(),
                                        [&](const auto& a, const auto& b) { return dot(n, a) < dot(n, b); });
    if (dot(n, *worst) > 0.0) return n;
    for (double& x : n) x *= 0.5;
    add(n, *worst);
  }
  // Coefficients that are zero have no direction; the proof looks at them again.
  return n;
}

// n (S_u x S_v) > 0 inside of the cell, proved.
bool is_regular(const CellPiece& piece, const Vector3& n) {
  Enclosures along(piece.normal.front().coefficients.size());
  for (std::size_t k = 0; k < along.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) along[k] += Enclosure(n[c]) * piece.normal[c].coefficients[k];
  }
  return common_sign(along) == 1;
}

bool is_zero_at(const CellPiece& piece, std::size_t i, std::size_t j) {
  return std::all_of(piece.normal.begin(), piece.normal.end(),
                     [&](const BernsteinGrid& f) { return f.at(i, j).is_zero(); });
}

// Pieces in which a singular point is looked for: most are decided before they are as small as a 64th of the
// span they are in, and where the surface is nearly singular along a curve there are too many of them.
constexpr double kSmall = 1.0 / 64.0;
constexpr int kAttempts = 200;

bool is_small(const CellPiece& piece, const EnclosedSurface& surface) {
  for (const std::size_t along : {0U, 1U}) {
    const std::vector<double>& breaks = surface.breaks()[along];
    const auto next = std::upper_bound(breaks.begin(), breaks.end(), piece.middle()[along]);
    if (next == breaks.begin() || next == breaks.end()) return false;
    if (piece.cell[along].length() > kSmall * (*next - *(next - 1))) return false;
  }
  return true;
}

}  // namespace

Findings examine_in_space(const Surface& surface) {
  const EnclosedSurface enclosed(surface);
  std::optional<Parameters> zero;
  int attempts = 0;
  const auto decide = [&](const CellPiece& piece) {
    const BernsteinGrid& shape = piece.normal.front();
    for (const std::size_t i : {std::size_t{0}, shape.rows - 1}) {
      for (const std::size_t j : {std::size_t{0}, shape.columns - 1}) {
        if (!zero && is_zero_at(piece, i, j))
          zero = Parameters{i == 0 ? piece.cell[0].lo : piece.cell[0].hi,
                            j == 0 ? piece.cell[1].lo : piece.cell[1].hi};
      }
    }
    const auto n = common_direction(piece);
    if (n && is_regular(piece, *n)) return true;
    if (!zero && is_small(piece, enclosed) && attempts < kAttempts) {
      ++attempts;
      zero = singular_point(enclosed, piece);
    }
    return false;
  };
  const bool all_decided = search_cells(enclosed, decide, [&](int) { return zero.has_value(); });
  Findings result;
  if (zero) {
    result.zero(*zero);
  } else if (all_decided) {
    result.regular = Verdict::certified;
  }
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
