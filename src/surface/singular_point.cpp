#include "surface/singular_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

constexpr int kSteps = 12;            // of Newton's method, which doubles the digits each time
constexpr double kAstray = 2.0;       // sizes of the piece beyond which another piece will find it
constexpr double kDifference = 1e-4;  // for derivatives, of the piece
constexpr double kConverged = 1e-7;   // a step of that size, of the piece, is the last
// Half sizes of cells in which there may be a zero, as shares of a span: what rounding leaves undecided in a
// small one is decided in a larger one.
constexpr std::array<double, 4> kShares = {1e-12, 1e-10, 1e-8, 1e-6};

using Pair = std::array<double, 2>;

struct Matrix {
  std::array<Pair, 2> row{};

  [[nodiscard]] double determinant() const noexcept { return row[0][0] * row[1][1] - row[0][1] * row[1][0]; }
  [[nodiscard]] Matrix inverse() const noexcept {
    const double d = determinant();
    return {{Pair{row[1][1] / d, -row[0][1] / d}, Pair{-row[1][0] / d, row[0][0] / d}}};
  }
};

// About the value at (s, t), by de Casteljau along either parameter.
double value(const BernsteinGrid& f, double s, double t) {
  std::vector<double> rows(f.rows);
  std::vector<double> line(f.columns);
  const auto collapse = [](std::vector<double>& b, double x) {
    for (std::size_t n = b.size(); n > 1; --n) {
      for (std::size_t k = 0; k + 1 < n; ++k) b[k] = (1.0 - x) * b[k] + x * b[k + 1];
    }
    return b[0];
  };
  for (std::size_t i = 0; i < f.rows; ++i) {
    for (std::size_t j = 0; j < f.columns; ++j) line[j] = f.at(i, j).middle();
    rows[i] = collapse(line, t);
  }
  return collapse(rows, s);
}

// Two functions with their derivatives at a place.
struct Equations {
  const BernsteinGrid& f;
  const BernsteinGrid& g;

  [[nodiscard]] Pair at(const Pair& x) const { return {value(f, x[0], x[1]), value(g, x[0], x[1])}; }
  [[nodiscard]] Matrix derivative(const Pair& x) const {
    Matrix result;
    for (const std::size_t along : {0U, 1U}) {
      Pair lo = x;
      Pair hi = x;
      lo[along] -= kDifference;
      hi[along] += kDifference;
      const Pair a = at(lo);
      const Pair b = at(hi);
      for (const std::size_t k : {0U, 1U}) result.row[k][along] = (b[k] - a[k]) / (2.0 * kDifference);
    }
    return result;
  }
};

// A zero, in units of the piece, if Newton's method finds one near it; only a guess.
std::optional<Pair> solve(const Equations& equations) {
  Pair x = {0.5, 0.5};
  for (int step = 0; step < kSteps; ++step) {
    const Pair value = equations.at(x);
    const Matrix derivative = equations.derivative(x);
    if (derivative.determinant() == 0.0) return std::nullopt;
    const Matrix inverse = derivative.inverse();
    double moved = 0.0;
    for (const std::size_t k : {0U, 1U}) {
      const double by = inverse.row[k][0] * value[0] + inverse.row[k][1] * value[1];
      x[k] -= by;
      moved = std::max(moved, std::abs(by));
      if (!(std::abs(x[k] - 0.5) < 0.5 + kAstray)) return std::nullopt;
    }
    if (moved < kConverged) return x;
  }
  return std::nullopt;
}

// Whether a function has one sign on one side of a cell and the other one on the opposite side, of `along`.
bool changes_across(const BernsteinGrid& f, std::size_t along) {
  const std::size_t last = (along == 0 ? f.rows : f.columns) - 1;
  const auto has_sign = [&](std::size_t side, bool positive) {
    for (std::size_t k = 0; k < (along == 0 ? f.columns : f.rows); ++k) {
      const Enclosure& c = along == 0 ? f.at(side, k) : f.at(k, side);
      if (!(positive ? c.is_positive() : c.is_negative())) return false;
    }
    return true;
  };
  return (has_sign(0, false) && has_sign(last, true)) || (has_sign(0, true) && has_sign(last, false));
}

bool has_one_sign(const BernsteinGrid& f) {
  const auto& all = f.coefficients;
  return std::all_of(all.begin(), all.end(), [](const Enclosure& c) { return c.is_positive(); }) ||
         std::all_of(all.begin(), all.end(), [](const Enclosure& c) { return c.is_negative(); });
}

BernsteinGrid combined(const Pair& row, const BernsteinGrid& f, const BernsteinGrid& g) {
  BernsteinGrid result = f;
  for (std::size_t k = 0; k < result.coefficients.size(); ++k)
    result.coefficients[k] = Enclosure(row[0]) * f.coefficients[k] + Enclosure(row[1]) * g.coefficients[k];
  return result;
}

// That f = g = 0 somewhere in the cell, proved.
bool have_common_zero(const BernsteinGrid& f, const BernsteinGrid& g) {
  const Equations equations{f, g};
  const Matrix derivative = equations.derivative({0.5, 0.5});
  if (derivative.determinant() == 0.0) return false;
  const Matrix basis = derivative.inverse();
  const auto& [first, second] = basis.row;
  const Enclosure determinant =
      Enclosure(first[0]) * Enclosure(second[1]) - Enclosure(first[1]) * Enclosure(second[0]);
  if (!determinant.is_positive() && !determinant.is_negative()) return false;
  return changes_across(combined(first, f, g), 0) && changes_across(combined(second, f, g), 1);
}

// The span of a parameter that holds t, and not at its ends.
std::optional<Interval> span_around(const std::vector<double>& breaks, double t) {
  const auto next = std::upper_bound(breaks.begin(), breaks.end(), t);
  if (next == breaks.begin() || next == breaks.end() || *(next - 1) == t) return std::nullopt;
  return Interval{*(next - 1), *next};
}

// The cell of that share of the spans around a place, if it is inside of them.
std::optional<Cell> cell_around(const EnclosedSurface& surface, const Parameters& at, double share) {
  Cell cell;
  for (const std::size_t k : {0U, 1U}) {
    const std::optional<Interval> span = span_around(surface.breaks()[k], at[k]);
    if (!span) return std::nullopt;
    cell[k] = {at[k] - share * span->length(), at[k] + share * span->length()};
    if (!(span->lo < cell[k].lo && cell[k].lo < at[k] && at[k] < cell[k].hi && cell[k].hi < span->hi))
      return std::nullopt;
  }
  return cell;
}

double size_at_middle(const BernsteinGrid& f) {
  return std::abs(value(f, 0.5, 0.5));
}

// The tangent and its coordinate that is furthest from zero in the middle of a cell.
struct Leading {
  std::size_t along = 0;
  std::size_t coordinate = 0;
};

Leading leading_tangent(const EnclosedSurface& surface, const Cell& cell) {
  Leading best;
  double largest = -1.0;
  for (const std::size_t along : {0U, 1U}) {
    const std::vector<BernsteinGrid> tangent = surface.tangent(along, cell);
    for (std::size_t c = 0; c < 3; ++c) {
      const double size = size_at_middle(tangent[c]);
      if (!(size > largest)) continue;
      largest = size;
      best = {along, c};
    }
  }
  return best;
}

}  // namespace

std::optional<Parameters> singular_point(const EnclosedSurface& surface, const CellPiece& piece) {
  const Leading leading = leading_tangent(surface, piece.cell);
  const std::size_t y = (leading.coordinate + 1) % 3;
  const std::size_t z = (leading.coordinate + 2) % 3;
  const std::optional<Pair> zero = solve({piece.normal[y], piece.normal[z]});
  if (!zero) return std::nullopt;
  Parameters at{};
  for (const std::size_t k : {0U, 1U}) at[k] = piece.cell[k].lo + (*zero)[k] * piece.cell[k].length();
  for (const double share : kShares) {
    const std::optional<Cell> cell = cell_around(surface, at, share);
    if (!cell) continue;
    const std::vector<BernsteinGrid> normal = surface.normal(*cell);
    if (!have_common_zero(normal[y], normal[z])) continue;
    if (has_one_sign(surface.tangent(leading.along, *cell)[leading.coordinate])) return at;
  }
  return std::nullopt;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
