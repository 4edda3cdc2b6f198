#include "tandem/curve/points.h"

#include <fmt/format.h>

#include <utility>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

int checked_dim(int dim) {
  if (dim < 1) throw InvalidArgument(fmt::format("the dimension of points is {}, expected at least 1", dim));
  return dim;
}

}  // namespace

Points::Points(int dim, std::size_t n)
    : dim_(checked_dim(dim)), coords_(n * static_cast<std::size_t>(dim), 0.0) {}

Points::Points(int dim, std::vector<double> coords) : dim_(checked_dim(dim)), coords_(std::move(coords)) {
  if (coords_.size() % static_cast<std::size_t>(dim_) != 0) {
    throw InvalidArgument(
        fmt::format("{} coordinates do not make whole points of dimension {}", coords_.size(), dim_));
  }
}

Points::Points(std::initializer_list<std::initializer_list<double>> rows) {
  for (const auto& row : rows) push_back(std::span<const double>(row.begin(), row.size()));
}

void Points::push_back(std::span<const double> point) {
  if (dim_ == 0) dim_ = checked_dim(static_cast<int>(point.size()));
  if (point.size() != static_cast<std::size_t>(dim_)) {
    throw InvalidArgument(
        fmt::format("point {} has {} coordinates, expected {}", size(), point.size(), dim_));
  }
  // A point of this very value may be appended to it: growing would free what `point` looks at.
  const double* begin = coords_.data();
  if (point.data() >= begin && point.data() < begin + coords_.size()) {
    const std::vector<double> copy(point.begin(), point.end());
    coords_.insert(coords_.end(), copy.begin(), copy.end());
  } else {
    coords_.insert(coords_.end(), point.begin(), point.end());
  }
}

}  // namespace v0
}  // namespace tandem
