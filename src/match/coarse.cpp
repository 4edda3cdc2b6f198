#include "match/coarse.h"

#include <algorithm>
#include <cmath>

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// The sample of a curve nearest to parameter t from below; a loop wraps.
int sample_at(const Samples& s, double t) {
  if (s.cyclic) t -= s.period * std::floor((t - s.domain.lo) / s.period);
  const auto next = std::upper_bound(s.parameters.begin(), s.parameters.end(), t);
  const int k = static_cast<int>(next - s.parameters.begin()) - 1;
  return k >= 0 ? k : (s.cyclic ? static_cast<int>(s.size()) - 1 : 0);
}

}  // namespace

NodeMask mask_near(const Samples& a, const Samples& b, const Correspondence& coarse, int radius) {
  const int rows = static_cast<int>(a.size());
  const int cols = static_cast<int>(b.size());
  NodeMask mask{a.size(), b.size(), std::vector<std::uint8_t>(a.size() * b.size(), 0)};
  const auto allow = [&](int i, int j) {
    if (a.cyclic) i = (i % rows + rows) % rows;
    if (b.cyclic) j = (j % cols + cols) % cols;
    if (i < 0 || i >= rows || j < 0 || j >= cols) return;
    mask.allowed[static_cast<std::size_t>(i) * b.size() + static_cast<std::size_t>(j)] = 1;
  };
  for (int i = 0; i < rows; ++i) {
    const int j = sample_at(b, coarse.v_at(a.parameters[static_cast<std::size_t>(i)]));
    for (int d = -radius; d <= radius + 1; ++d) allow(i, j + d);
  }
  for (int j = 0; j < cols; ++j) {
    const int i = sample_at(a, coarse.u_at(b.parameters[static_cast<std::size_t>(j)]));
    for (int d = -radius; d <= radius + 1; ++d) allow(i + d, j);
  }
  return mask;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
