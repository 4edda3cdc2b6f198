#include "io/interpolate.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr std::size_t kMostBasisFunctions = 4;

/// The degree + 1 B-splines that are not zero at t, by the recurrence of Cox and de Boor.
std::array<double, kMostBasisFunctions> basis(const std::vector<double>& knots, std::size_t span, int degree,
                                              double t) {
  std::array<double, kMostBasisFunctions> values{};
  values[0] = 1.0;
  for (int p = 1; p <= degree; ++p) {
    double saved = 0.0;
    for (int r = 0; r < p; ++r) {
      const double right = knots[span + static_cast<std::size_t>(r) + 1];
      const double left = knots[span + 1 + static_cast<std::size_t>(r) - static_cast<std::size_t>(p)];
      const auto i = static_cast<std::size_t>(r);
      const double share = (right - t) / (right - left);
      const double value = values[i];
      values[i] = saved + share * value;
      saved = (1.0 - share) * value;
    }
    values[static_cast<std::size_t>(p)] = saved;
  }
  return values;
}

/// End knots of full multiplicity; inside, every time but those next to the ends.
std::vector<double> not_a_knot(const std::vector<double>& times, int degree) {
  const auto order = static_cast<std::size_t>(degree) + 1;
  std::vector<double> knots(order, times.front());
  for (std::size_t i = 2; i + 2 < times.size(); ++i) knots.push_back(times[i]);
  knots.insert(knots.end(), order, times.back());
  return knots;
}

/// A square matrix with two diagonals on either side of the main one, which is all that not-a-knot ends need.
class BandMatrix {
 public:
  static constexpr std::size_t kBand = 2;
  explicit BandMatrix(std::size_t n) : rows_(n) {}
  double& operator()(std::size_t i, std::size_t j) { return rows_[i][j + kBand - i]; }

  /// Gauss without pivoting: stable, since the matrix is totally positive (de Boor and Pinkus, 1977).
  void solve(Points& right_side) {
    const std::size_t n = rows_.size();
    const auto dim = static_cast<std::size_t>(right_side.dim());
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t i = k + 1; i < std::min(n, k + kBand + 1); ++i) {
        const double factor = (*this)(i, k) / (*this)(k, k);
        for (std::size_t j = k; j < std::min(n, k + kBand + 1); ++j) (*this)(i, j) -= factor * (*this)(k, j);
        for (std::size_t c = 0; c < dim; ++c) right_side[i][c] -= factor * right_side[k][c];
      }
    }
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t c = 0; c < dim; ++c) {
        double value = right_side[k][c];
        for (std::size_t j = k + 1; j < std::min(n, k + kBand + 1); ++j)
          value -= (*this)(k, j) * right_side[j][c];
        right_side[k][c] = value / (*this)(k, k);
      }
    }
  }

 private:
  std::vector<std::array<double, 2 * kBand + 1>> rows_;
};

}  // namespace

Curve interpolate(const std::vector<double>& times, const Points& points) {
  const std::size_t n = times.size();
  const int degree = static_cast<int>(std::min<std::size_t>(3, n - 1));
  std::vector<double> knots = not_a_knot(times, degree);
  BandMatrix matrix(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t span = find_span(knots, degree, times[i]);
    const auto values = basis(knots, span, degree, times[i]);
    const std::size_t first = span - static_cast<std::size_t>(degree);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k) {
      if (values[k] != 0.0) matrix(i, first + k) = values[k];
    }
  }
  Points control_points = points;
  matrix.solve(control_points);
  return Curve(degree, std::move(knots), std::move(control_points));
}

}  // namespace v0
}  // namespace tandem
