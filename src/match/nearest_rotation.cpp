#include "match/nearest_rotation.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <vector>

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Weight of a small turn beside the pairs themselves: decides what they leave open, and moves what they
/// determine by no more than rounding does.
constexpr double kPull = 1e-12;

NearestRotation nearest_in_plane(std::span<const double> c) {
  const double re = c[0] + c[3];
  const double im = c[2] - c[1];
  const double length = std::sqrt(re * re + im * im);
  if (!(length > 0.0)) return {Rotation(2), 0.0};
  const double values[] = {re / length, im / length};
  return {Rotation(2, values), length};
}

template <int kSize>
NearestRotation nearest_by_svd(std::span<const double> covariance, int dim) {
  using Matrix = Eigen::Matrix<double, kSize, kSize, Eigen::RowMajor>;
  const Matrix pairs = Eigen::Map<const Matrix>(covariance.data(), dim, dim);
  const double size = pairs.norm();
  if (!(size > 0.0)) return {Rotation(dim), 0.0};
  const Matrix pulled = pairs + kPull * size * Matrix::Identity(dim, dim);
  const Eigen::JacobiSVD<Eigen::Matrix<double, kSize, kSize>> svd(pulled,
                                                                  Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix<double, kSize, kSize> u = svd.matrixU();
  if (u.determinant() * svd.matrixV().determinant() < 0.0) u.col(dim - 1) *= -1.0;
  const Matrix r = u * svd.matrixV().transpose();
  return {Rotation(dim, {r.data(), static_cast<std::size_t>(r.size())}), r.cwiseProduct(pairs).sum()};
}

}  // namespace

NearestRotation nearest_rotation(std::span<const double> covariance, int dim) {
  switch (dim) {
    case 1:
      return {Rotation(1), covariance[0]};
    case 2:
      return nearest_in_plane(covariance);
    case 3:
      return nearest_by_svd<3>(covariance, dim);
    default:
      return nearest_by_svd<Eigen::Dynamic>(covariance, dim);
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
