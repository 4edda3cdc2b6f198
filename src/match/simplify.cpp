#include "match/simplify.h"

#include <algorithm>
#include <limits>

namespace tandem {
inline namespace v0 {
namespace detail {

std::vector<std::size_t> fewest_vertices(std::span<const double> x, std::span<const double> y,
                                         std::span<const double> low, std::span<const double> high) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::size_t n = x.size();
  const std::size_t unseen = n;
  std::vector<std::size_t> before(n, unseen);
  // Breadth first: vertices in the order in which they are first reached, so the end is reached by fewest
  // chords.
  std::vector<std::size_t> queue;
  queue.reserve(n);
  queue.push_back(0);
  for (std::size_t head = 0; head < queue.size() && before[n - 1] == unseen && n > 1; ++head) {
    const std::size_t from = queue[head];
    double least = -kInfinity;
    double greatest = kInfinity;
    for (std::size_t to = from + 1; to < n && least <= greatest; ++to) {
      const double distance = x[to] - x[from];
      const double slope = (y[to] - y[from]) / distance;
      if (before[to] == unseen && least <= slope && slope <= greatest) {
        before[to] = from;
        queue.push_back(to);
      }
      least = std::max(least, (low[to] - y[from]) / distance);
      greatest = std::min(greatest, (high[to] - y[from]) / distance);
    }
  }

  std::vector<std::size_t> vertices;
  for (std::size_t i = n - 1; i != 0; i = before[i]) vertices.push_back(i);
  vertices.push_back(0);
  std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
