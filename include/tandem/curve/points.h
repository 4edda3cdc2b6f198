#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// A point or a vector of R^n as a value.
using Point = std::vector<double>;

/// n points of R^dim, stored one after the other: coordinate k of point i is data()[i * dim + k].
class TANDEM_EXPORT Points {
 public:
  Points() = default;
  /// n points at the origin of R^dim. @throws InvalidArgument dim < 1
  Points(int dim, std::size_t n);
  /// @throws InvalidArgument coords.size() is not a multiple of dim, or dim < 1
  Points(int dim, std::vector<double> coords);
  /// Points({{0, 0}, {1, 2}}). @throws InvalidArgument the rows differ in length
  Points(std::initializer_list<std::initializer_list<double>> rows);

  /// Dimension of the space; 0 only for a default-constructed, empty value.
  [[nodiscard]] int dim() const noexcept { return dim_; }
  [[nodiscard]] std::size_t size() const noexcept {
    return dim_ == 0 ? 0 : coords_.size() / static_cast<std::size_t>(dim_);
  }
  [[nodiscard]] bool empty() const noexcept { return coords_.empty(); }

  [[nodiscard]] std::span<const double> operator[](std::size_t i) const noexcept {
    return {coords_.data() + i * static_cast<std::size_t>(dim_), static_cast<std::size_t>(dim_)};
  }
  [[nodiscard]] std::span<double> operator[](std::size_t i) noexcept {
    return {coords_.data() + i * static_cast<std::size_t>(dim_), static_cast<std::size_t>(dim_)};
  }
  [[nodiscard]] std::span<const double> front() const noexcept { return (*this)[0]; }
  [[nodiscard]] std::span<const double> back() const noexcept { return (*this)[size() - 1]; }
  /// All coordinates, point after point.
  [[nodiscard]] std::span<const double> data() const noexcept { return coords_; }
  [[nodiscard]] std::span<double> data() noexcept { return coords_; }

  void reserve(std::size_t n) { coords_.reserve(n * static_cast<std::size_t>(dim_)); }
  /// @throws InvalidArgument point.size() != dim() (an empty default value takes the point's dimension)
  void push_back(std::span<const double> point);

  friend bool operator==(const Points&, const Points&) = default;

 private:
  int dim_ = 0;
  std::vector<double> coords_;
};

}  // namespace v0
}  // namespace tandem
