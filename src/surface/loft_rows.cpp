#include "surface/loft_rows.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "curve/local_spline.h"
#include "curve/norm.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr Eigen::Index index(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

RowMatrix to_matrix(const Points& rows) {
  return Eigen::Map<const RowMatrix>(rows.data().data(), index(rows.size()), rows.dim());
}

Points to_points(const RowMatrix& rows) {
  return {static_cast<int>(rows.cols()), std::vector<double>(rows.data(), rows.data() + rows.size())};
}

// The B-splines that are not zero at t, and the first one's index.
struct Basis {
  std::size_t first = 0;
  std::vector<double> values;
};

Basis basis_at(std::span<const double> knots, int degree, double t) {
  const std::size_t k = find_span(knots, degree, t);
  const auto p = static_cast<std::size_t>(degree);
  Basis found{k - p, std::vector<double>(p + 1)};
  basis(knots.data() + k, degree, t, found.values.data(), nullptr);
  return found;
}

// Solves for the control points that give `rows` at `v`; control point j is that of index j % n.
RowMatrix solve(std::span<const double> knots, int degree, std::span<const double> v, const Points& rows) {
  const std::size_t n = rows.size();
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < n; ++i) {
    const Basis b = basis_at(knots, degree, v[i]);
    for (std::size_t k = 0; k < b.values.size(); ++k) {
      entries.emplace_back(static_cast<int>(i), static_cast<int>((b.first + k) % n), b.values[k]);
    }
  }
  Eigen::SparseMatrix<double> matrix(index(n), index(n));
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(matrix);
  const Eigen::MatrixXd data = to_matrix(rows);
  const Eigen::MatrixXd control = lu.solve(data);
  return control;
}

std::vector<double> clamped(std::vector<double> inner, int degree, std::span<const double> v) {
  const auto order = static_cast<std::size_t>(degree) + 1;
  inner.insert(inner.begin(), order, v.front());
  inner.insert(inner.end(), order, v.back());
  return inner;
}

double mean(std::span<const double> values) {
  double sum = 0.0;
  for (const double x : values) sum += x;
  return sum / static_cast<double>(values.size());
}

std::vector<double> averaged_knots(std::span<const double> v, int degree) {
  const auto p = static_cast<std::size_t>(degree);
  std::vector<double> inner;
  for (std::size_t j = 1; j + p < v.size(); ++j) inner.push_back(mean(v.subspan(j, p)));
  return clamped(std::move(inner), degree, v);
}

// Every span holds a parameter, so that the normal equations are regular. The NURBS Book, eqs. (9.68), (9.69).
std::vector<double> spread_knots(std::span<const double> v, int degree, std::size_t n) {
  const std::size_t spans = n - static_cast<std::size_t>(degree);
  const double d = static_cast<double>(v.size()) / static_cast<double>(spans);
  std::vector<double> inner;
  for (std::size_t j = 1; j < spans; ++j) {
    const double place = static_cast<double>(j) * d;
    const auto i = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(i);
    inner.push_back((1.0 - share) * v[i - 1] + share * v[i]);
  }
  return clamped(std::move(inner), degree, v);
}

}  // namespace

double mean_distance(const Points& a, const Points& b) {
  Point gap(static_cast<std::size_t>(a.dim()));
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t c = 0; c < gap.size(); ++c) gap[c] = a[i][c] - b[i][c];
    sum += scaled_norm(gap) / static_cast<double>(a.size());
  }
  return sum;
}

Curve interpolate_rows(const Points& rows, std::span<const double> v, int degree) {
  std::vector<double> knots = averaged_knots(v, degree);
  Points control = to_points(solve(knots, degree, v, rows));
  std::copy(rows.front().begin(), rows.front().end(), control[0].begin());
  std::copy(rows.back().begin(), rows.back().end(), control[control.size() - 1].begin());
  return Curve(degree, std::move(knots), std::move(control));
}

Curve interpolate_loop(const Points& rows, std::span<const double> v, int degree) {
  const std::size_t n = rows.size();
  const auto p = static_cast<std::size_t>(degree);
  // Parameters and knots run on from period to period; averages of them lie around the parameters, where the
  // system is regular.
  const auto parameter = [&](std::size_t i) { return v[i % n] + static_cast<double>(i / n); };
  std::vector<double> knots;
  for (std::size_t i = 0; i < n + 2 * p + 1; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < p; ++k) sum += parameter(i + k);
    knots.push_back(sum / static_cast<double>(p));
  }
  const Interval domain{knots[p], knots[n + p]};
  std::vector<double> inside;
  for (const double x : v) inside.push_back(x + std::ceil(domain.lo - x));
  const RowMatrix solved = solve(knots, degree, inside, rows);
  RowMatrix control(solved.rows() + degree, solved.cols());
  control << solved, solved.topRows(degree);
  return with_domain(move_seam(Curve(degree, std::move(knots), to_points(control)), v.front()), {0.0, 1.0});
}

Curve approximate_rows(const Points& rows, std::span<const double> v, int degree, std::size_t n) {
  std::vector<double> knots = spread_knots(v, degree, n);
  const RowMatrix data = to_matrix(rows);
  RowMatrix control(index(n), data.cols());
  control.row(0) = data.row(0);
  control.row(index(n) - 1) = data.row(data.rows() - 1);
  if (n > 2 && rows.size() > 2) {
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(index(rows.size()) - 2, index(n));
    for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
      const Basis b = basis_at(knots, degree, v[i]);
      for (std::size_t k = 0; k < b.values.size(); ++k) weights(index(i) - 1, index(b.first + k)) = b.values[k];
    }
    const Eigen::MatrixXd ends = weights.col(0) * control.row(0) + weights.col(index(n) - 1) * control.row(index(n) - 1);
    const Eigen::MatrixXd wanted = data.middleRows(1, data.rows() - 2) - ends;
    control.middleRows(1, index(n) - 2) = weights.middleCols(1, index(n) - 2).householderQr().solve(wanted);
  }
  return Curve(degree, std::move(knots), to_points(control));
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
