#include "tandem/surface/simple_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "surface/orientation.h"
#include "surface/triangle_pair.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::SpacePoint;
using detail::Triangle;

struct Box {
  SpacePoint lo;
  SpacePoint hi;

  void add(const Box& other) noexcept {
    for (std::size_t c = 0; c < 3; ++c) {
      lo[c] = std::min(lo[c], other.lo[c]);
      hi[c] = std::max(hi[c], other.hi[c]);
    }
  }
  [[nodiscard]] bool meets(const Box& other) const noexcept {
    for (std::size_t c = 0; c < 3; ++c) {
      if (hi[c] < other.lo[c] || other.hi[c] < lo[c]) return false;
    }
    return true;
  }
};

/// The distinct points of a mesh, scaled by a power of two into the middle of the exact range, and its
/// triangles by these.
class Soup {
 public:
  explicit Soup(const TriangleMesh& mesh) {
    if (mesh.vertices.empty()) return;
    scale(mesh.vertices);
    const std::vector<std::uint32_t> distinct = weld();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      Triangle t{};
      for (std::size_t k = 0; k < 3; ++k) t[k] = distinct[mesh.triangles[i][k]];
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      if (detail::is_flat(points[t[0]], points[t[1]], points[t[2]])) {
        has_flat = true;
        continue;
      }
      triangles.push_back(t);
      indices.push_back(i);
    }
  }

  std::vector<SpacePoint> points;
  std::vector<Triangle> triangles;
  std::vector<std::size_t> indices;  // of the triangles in the mesh
  bool has_flat = false;             // corners in a line: left out
  bool is_exact = true;              // no coordinate was rounded to fit

 private:
  void scale(const Points& vertices) {
    double largest = 0.0;
    for (const double x : vertices.data()) largest = std::max(largest, std::abs(x));
    const int exponent = largest > 0.0 ? std::ilogb(detail::kLargestExact) - 1 - std::ilogb(largest) : 0;
    points.resize(vertices.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double x = std::ldexp(vertices[i][c], exponent);
        if (vertices[i][c] != 0.0 && std::abs(x) < detail::kLeastExact) is_exact = false;
        points[i][c] = x;
      }
    }
  }

  // The first of all vertices at each one's place.
  [[nodiscard]] std::vector<std::uint32_t> weld() const {
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      return points[i] != points[j] ? points[i] < points[j] : i < j;
    });
    std::vector<std::uint32_t> result(points.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      const bool same = k > 0 && points[order[k]] == points[order[k - 1]];
      result[order[k]] = same ? result[order[k - 1]] : order[k];
    }
    return result;
  }
};

/// A tree of boxes over the triangles, and the search in it for two that meet.
class BoxTree {
 public:
  explicit BoxTree(const Soup& soup) : soup_(soup), order_(soup.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    for (const Triangle& t : soup.triangles) {
      Box box{soup.points[t[0]], soup.points[t[0]]};
      for (const std::uint32_t corner : t) box.add({soup.points[corner], soup.points[corner]});
      boxes_.push_back(box);
    }
    if (!order_.empty()) build(0, order_.size());
  }

  /// Two triangles of the soup, or twice the same if none meet.
  [[nodiscard]] std::array<std::size_t, 2> find() {
    if (!nodes_.empty()) within(0);
    return found_;
  }

 private:
  struct Node {
    Box box;
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t right = 0;  // the left one follows at once; 0: a leaf
  };
  static constexpr std::size_t kLeaf = 4;

  std::size_t build(std::size_t first, std::size_t last) {
    const std::size_t at = nodes_.size();
    Box box = boxes_[order_[first]];
    for (std::size_t i = first + 1; i < last; ++i) box.add(boxes_[order_[i]]);
    nodes_.push_back({box, first, last, 0});
    if (last - first <= kLeaf) return at;
    std::size_t axis = 0;
    for (const std::size_t c : {1U, 2U}) {
      if (box.hi[c] - box.lo[c] > box.hi[axis] - box.lo[axis]) axis = c;
    }
    const std::size_t middle = (first + last) / 2;
    const auto begin = order_.begin();
    std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(middle),
                     begin + static_cast<std::ptrdiff_t>(last), [&](std::size_t i, std::size_t j) {
                       return boxes_[i].lo[axis] + boxes_[i].hi[axis] <
                              boxes_[j].lo[axis] + boxes_[j].hi[axis];
                     });
    build(first, middle);
    const std::size_t right = build(middle, last);
    nodes_[at].right = right;
    return at;
  }

  [[nodiscard]] bool is_found() const noexcept { return found_[0] != found_[1]; }

  void within(std::size_t at) {
    const Node& node = nodes_[at];
    if (node.right == 0) {
      for (std::size_t i = node.first; i < node.last; ++i) {
        for (std::size_t j = i + 1; j < node.last; ++j) test(order_[i], order_[j]);
      }
      return;
    }
    within(at + 1);
    within(node.right);
    between(at + 1, node.right);
  }

  void between(std::size_t a, std::size_t b) {
    const Node& first = nodes_[a];
    const Node& second = nodes_[b];
    if (is_found() || !first.box.meets(second.box)) return;
    if (first.right == 0 && second.right == 0) {
      for (std::size_t i = first.first; i < first.last; ++i) {
        for (std::size_t j = second.first; j < second.last; ++j) test(order_[i], order_[j]);
      }
    } else if (second.right == 0 ||
               (first.right != 0 && first.last - first.first >= second.last - second.first)) {
      between(a + 1, b);
      between(first.right, b);
    } else {
      between(a, b + 1);
      between(a, second.right);
    }
  }

  void test(std::size_t i, std::size_t j) {
    if (is_found() || !boxes_[i].meets(boxes_[j])) return;
    if (detail::do_meet(soup_.points, soup_.triangles[i], soup_.triangles[j])) found_ = {i, j};
  }

  const Soup& soup_;
  std::vector<std::size_t> order_;
  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
  std::array<std::size_t, 2> found_{};
};

void check(const TriangleMesh& mesh) {
  if (!mesh.vertices.empty() && mesh.vertices.dim() != 3)
    throw InvalidArgument(fmt::format("a mesh has vertices in R^3, not in R^{}", mesh.vertices.dim()));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t corner : mesh.triangles[i]) {
      if (corner >= mesh.vertices.size())
        throw InvalidArgument(
            fmt::format("triangle {} has vertex {}, of {}", i, corner, mesh.vertices.size()));
    }
  }
  for (const double x : mesh.vertices.data()) {
    if (!std::isfinite(x)) throw InvalidArgument("a vertex of the mesh is not finite");
  }
}

}  // namespace

SimpleMesh find_simple(const TriangleMesh& mesh) {
  check(mesh);
  const Soup soup(mesh);
  SimpleMesh result;
  const auto [first, second] = BoxTree(soup).find();
  if (!soup.is_exact) return result;
  if (first != second) {
    result.verdict = Verdict::violated;
    result.triangles = {soup.indices[first], soup.indices[second]};
    std::sort(result.triangles.begin(), result.triangles.end());
  } else if (!soup.has_flat) {
    result.verdict = Verdict::certified;
  }
  return result;
}

}  // namespace v0
}  // namespace tandem
