#include "cad/wires.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "tandem/curve/arc_length.h"
#include "tandem/curve/edit.h"

namespace tandem {
inline namespace v0 {
namespace cad {
namespace {

constexpr double kMeet = 1e-6;
constexpr double kMeetShare = 1e-9;
// Of the lengths of the parts, which only say how the parameter is shared out.
constexpr double kLengthTolerance = 1e-6;

class Chainer {
 public:
  explicit Chainer(std::vector<Curve> curves) : curves_(std::move(curves)), used_(curves_.size(), false) {
    for (Curve& curve : curves_) {
      curve = clamp(curve);
      size_ = std::max(size_, curve.extent());
    }
  }

  std::vector<Curve> run() {
    std::vector<Curve> wires;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      if (used_[i]) continue;
      used_[i] = true;
      std::vector<Curve> chain{curves_[i]};
      extend(chain);
      std::reverse(chain.begin(), chain.end());
      for (Curve& curve : chain) curve = reverse(curve);
      extend(chain);
      std::reverse(chain.begin(), chain.end());
      for (Curve& curve : chain) curve = reverse(curve);
      wires.push_back(chain.size() == 1 ? chain.front() : joined(std::move(chain)));
    }
    return wires;
  }

 private:
  [[nodiscard]] bool meet(std::span<const double> p, std::span<const double> q) const {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= std::max(kMeet, kMeetShare * size_);
  }
  [[nodiscard]] bool is_loop(const Curve& curve) const {
    return meet(curve.control_points().front(), curve.control_points().back());
  }

  // Ends at the point, of all curves.
  [[nodiscard]] int ends_at(std::span<const double> point) const {
    int count = 0;
    for (const Curve& curve : curves_) {
      count += meet(curve.control_points().front(), point) ? 1 : 0;
      count += meet(curve.control_points().back(), point) ? 1 : 0;
    }
    return count;
  }

  // Appends what follows the end of the chain, as long as there is just one that does.
  void extend(std::vector<Curve>& chain) {
    while (true) {
      const Points& last = chain.back().control_points();
      const Point end(last.back().begin(), last.back().end());
      if (is_loop(chain.back()) || meet(chain.front().control_points().front(), end)) return;
      if (ends_at(end) != 2) return;
      std::size_t next = 0;
      while (next < curves_.size() && (used_[next] || !touches(curves_[next], end))) ++next;
      if (next == curves_.size()) return;
      used_[next] = true;
      const bool forward = meet(curves_[next].control_points().front(), end);
      chain.push_back(forward ? curves_[next] : reverse(curves_[next]));
    }
  }
  [[nodiscard]] bool touches(const Curve& curve, std::span<const double> point) const {
    return meet(curve.control_points().front(), point) || meet(curve.control_points().back(), point);
  }

  // With ends that meet to the bit.
  static Curve joined(std::vector<Curve> chain) {
    double at = 0.0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const double length = arc_length(chain[i], kLengthTolerance * chain[i].extent());
      Points points = chain[i].control_points();
      if (i > 0) {
        const auto end = std::as_const(chain[i - 1]).control_points().back();
        std::copy(end.begin(), end.end(), points[0].begin());
      }
      if (i + 1 == chain.size()) {
        const auto start = std::as_const(chain[0]).control_points().front();
        const auto end = points[points.size() - 1];
        if (std::hypot(start[0] - end[0], start[1] - end[1], start[2] - end[2]) <= kMeet)
          std::copy(start.begin(), start.end(), end.begin());
      }
      chain[i] =
          with_domain(Curve(chain[i].degree(), chain[i].knots(), std::move(points), chain[i].weights()),
                      {at, at + length});
      at += length;
    }
    return join(chain);
  }

  std::vector<Curve> curves_;
  std::vector<bool> used_;
  double size_ = 0.0;
};

}  // namespace

std::vector<Curve> chained(std::vector<Curve> curves) {
  return Chainer(std::move(curves)).run();
}

}  // namespace cad
}  // namespace v0
}  // namespace tandem
