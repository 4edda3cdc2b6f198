#include "tandem/match/rotation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "shape/trigonometry.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace {

/// How far the columns of a matrix may be from orthonormal when it comes from a caller: numbers written with
/// six decimals are good enough, a reflection or a scale is not.
constexpr double kOrthonormal = 1e-5;

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::size_t value_count(int dim) {
  const auto n = static_cast<std::size_t>(dim);
  return dim == 2 ? 2 : n * n;
}

Eigen::Map<const Matrix> matrix_of(const std::vector<double>& values, int dim) {
  return {values.data(), dim, dim};
}

/// A rotation as turns in planes at right angles to one another: R = Q D Q^T, where D has blocks of 2 x 2.
struct PlaneTurns {
  Matrix basis;                            ///< columns 2 * plane and 2 * plane + 1 span a plane
  std::vector<Eigen::Index> first_column;  ///< per plane
  std::vector<double> degrees;             ///< in (-180, 180]
};

PlaneTurns plane_turns(const std::vector<double>& values, int dim) {
  const Eigen::RealSchur<Matrix> schur(matrix_of(values, dim));
  const Matrix& t = schur.matrixT();
  PlaneTurns turns;
  turns.basis = schur.matrixU();
  std::vector<Eigen::Index> opposite;  // eigenvalues -1, of which there is an even number: half turns
  for (Eigen::Index k = 0; k < dim; ++k) {
    if (k + 1 < dim && t(k + 1, k) != 0.0) {
      // The Schur form of a normal matrix is block diagonal but for rounding.
      const double angle = angle_degrees(t(k, k) + t(k + 1, k + 1), t(k + 1, k) - t(k, k + 1));
      turns.first_column.push_back(k);
      turns.degrees.push_back(angle > 180.0 ? angle - 360.0 : angle);
      ++k;
    } else if (t(k, k) < 0.0) {
      opposite.push_back(k);
    }
  }
  for (std::size_t i = 0; i + 1 < opposite.size(); i += 2) {
    // The columns of a plane stand side by side.
    const Eigen::Index k = opposite[i];
    if (opposite[i + 1] != k + 1) {
      turns.basis.conservativeResize(Eigen::NoChange, turns.basis.cols() + 2);
      turns.basis.rightCols(2).col(0) = turns.basis.col(k);
      turns.basis.rightCols(2).col(1) = turns.basis.col(opposite[i + 1]);
      turns.first_column.push_back(turns.basis.cols() - 2);
    } else {
      turns.first_column.push_back(k);
    }
    turns.degrees.push_back(180.0);
  }
  return turns;
}

}  // namespace

Rotation::Rotation(int dim) : dim_(dim) {
  if (dim < 1) throw InvalidArgument("a rotation of dimension " + std::to_string(dim) + ", expected >= 1");
  values_.assign(value_count(dim), 0.0);
  if (dim == 2) {
    values_[0] = 1.0;
    return;
  }
  for (std::size_t k = 0; k < values_.size(); k += static_cast<std::size_t>(dim) + 1) values_[k] = 1.0;
}

Rotation::Rotation(int dim, std::span<const double> values) : Rotation(dim) {
  if (values.size() != values_.size()) {
    throw InvalidArgument("a rotation of dimension " + std::to_string(dim) + " has " +
                          std::to_string(values_.size()) + " values, not " + std::to_string(values.size()));
  }
  values_.assign(values.begin(), values.end());
  if (dim == 2) {
    const double length = std::sqrt(values_[0] * values_[0] + values_[1] * values_[1]);
    if (!(std::fabs(length - 1.0) <= kOrthonormal)) {
      throw InvalidArgument("cosine " + std::to_string(values_[0]) + " and sine " +
                            std::to_string(values_[1]) + " are no rotation: expected length 1");
    }
    for (double& x : values_) x /= length;
    return;
  }
  const Matrix m = matrix_of(values_, dim);
  const double defect = (m.transpose() * m - Matrix::Identity(dim, dim)).cwiseAbs().maxCoeff();
  if (!(defect <= kOrthonormal)) {
    throw InvalidArgument("the rows of the matrix are no rotation: expected orthonormal ones");
  }
  if (m.determinant() < 0.0) throw InvalidArgument("the matrix is a reflection; expected a proper rotation");
}

bool Rotation::is_identity() const {
  return *this == Rotation(dim_);
}

Rotation Rotation::inverse() const {
  Rotation r = *this;
  if (dim_ == 2) {
    r.values_[1] = 0.0 - r.values_[1];
    return r;
  }
  const auto n = static_cast<std::size_t>(dim_);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) r.values_[i * n + k] = values_[k * n + i];
  }
  return r;
}

double Rotation::trace() const {
  if (dim_ == 2) return 2.0 * values_[0];
  double sum = 0.0;
  for (std::size_t k = 0; k < values_.size(); k += static_cast<std::size_t>(dim_) + 1) sum += values_[k];
  return sum;
}

double Rotation::degrees() const {
  if (dim_ == 2) {
    const double angle = angle_degrees(values_[0], values_[1]);
    return angle > 180.0 ? angle - 360.0 : angle;
  }
  double squares = 0.0;
  for (const double angle : plane_turns(values_, dim_).degrees) squares += angle * angle;
  return std::sqrt(squares);
}

Rotation Rotation::fraction(double s) const {
  Rotation r(dim_);
  if (dim_ == 2) {
    const CosSin w = cos_sin_degrees(s * degrees());
    r.values_ = {w.cosine, w.sine};
    return r;
  }
  const PlaneTurns turns = plane_turns(values_, dim_);
  Matrix m = Matrix::Identity(dim_, dim_);
  for (std::size_t k = 0; k < turns.degrees.size(); ++k) {
    const CosSin w = cos_sin_degrees(s * turns.degrees[k]);
    const auto x = turns.basis.col(turns.first_column[k]);
    const auto y = turns.basis.col(turns.first_column[k] + 1);
    m += (w.cosine - 1.0) * (x * x.transpose() + y * y.transpose()) +
         w.sine * (y * x.transpose() - x * y.transpose());
  }
  std::copy(m.data(), m.data() + m.size(), r.values_.begin());
  return r;
}

void Rotation::apply(std::span<const double> x, std::span<double> out) const {
  if (dim_ == 2) {
    const double x0 = x[0];
    const double x1 = x[1];
    out[0] = values_[0] * x0 - values_[1] * x1;
    out[1] = values_[1] * x0 + values_[0] * x1;
    return;
  }
  const auto n = static_cast<std::size_t>(dim_);
  const std::vector<double> from(x.begin(), x.end());
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < n; ++k) sum += values_[i * n + k] * from[k];
    out[i] = sum;
  }
}

Points Rotation::operator()(Points points) const {
  for (std::size_t i = 0; i < points.size(); ++i) apply(points[i], points[i]);
  return points;
}

}  // namespace v0
}  // namespace tandem
