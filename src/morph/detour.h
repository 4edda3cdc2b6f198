#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Smooths the in-betweens of two aligned planar paths: heat flows along the control polygon, whose edges
/// have the mean of their lengths in both paths, and the area is kept ([C]'s prefiltering, spec B1 `detour`).
///
/// Smooth joints stay smooth; corners are blunted. Ends of open paths stay where they are.
class Detour {
 public:
  Detour(const CubicPath& a, const CubicPath& b);

  /// width: standard deviation of the filter as a share of the path's length; 0 changes nothing, and a little
  /// width changes little.
  void apply(double width, std::span<double> points) const;

 private:
  void flow(double time, int steps, std::span<double> points) const;
  void straighten(std::span<double> points) const;

  bool closed_;
  std::vector<double> conductance_;  ///< per edge: 1 / length
  std::vector<double> mass_;         ///< per point (closed: the last one is the first)
  std::vector<std::size_t> smooth_;  ///< points that are joints and smooth in both paths
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
