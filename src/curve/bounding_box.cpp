#include "tandem/curve/bounding_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "curve/norm.h"
#include "curve/spline.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// Halvings of a piece; after these a cubic's hull exceeds it by less than rounding.
constexpr int kDeepest = 40;

// The largest value of sign * coordinate over one Bezier piece, given that `best` is reached elsewhere:
// branch and bound on the control points' hull, which closes in on an extremum by a factor of 4 with each
// halving.
class Maximum {
 public:
  Maximum(const detail::Pieces& pieces, std::size_t coordinate, double sign)
      : order_(static_cast<std::size_t>(pieces.degree) + 1),
        stride_(static_cast<std::size_t>(pieces.stride)),
        weight_(pieces.rational ? stride_ - 1 : stride_),
        coordinate_(coordinate),
        sign_(sign) {}

  double over(const double* piece, double best) {
    stack_.clear();
    std::vector<double> numbers(2 * order_);
    for (std::size_t i = 0; i < order_; ++i) {
      numbers[i] = sign_ * piece[i * stride_ + coordinate_];
      numbers[order_ + i] = weight_ < stride_ ? piece[i * stride_ + weight_] : 1.0;
    }
    stack_.push_back({std::move(numbers), 0});
    while (!stack_.empty()) {
      Part part = std::move(stack_.back());
      stack_.pop_back();
      const double ends = std::max(value(part, 0), value(part, order_ - 1));
      best = std::max(best, ends);
      double hull = ends;
      double size = 0.0;
      for (std::size_t i = 0; i < order_; ++i) {
        hull = std::max(hull, value(part, i));
        size = std::max(size, std::abs(value(part, i)));
      }
      if (hull - best <= std::numeric_limits<double>::epsilon() * size || part.depth == kDeepest) continue;
      halve(part);
    }
    return best;
  }

 private:
  struct Part {
    std::vector<double> numbers;  // premultiplied coordinates, then weights
    int depth = 0;
  };

  [[nodiscard]] double value(const Part& part, std::size_t i) const {
    return part.numbers[i] / part.numbers[order_ + i];
  }

  void halve(Part& part) {
    Part left{std::vector<double>(2 * order_), part.depth + 1};
    for (std::size_t half = 0; half < 2; ++half) {
      double* b = part.numbers.data() + half * order_;
      double* out = left.numbers.data() + half * order_;
      for (std::size_t level = 0; level < order_; ++level) {
        out[level] = b[0];
        for (std::size_t i = 0; i + level + 1 < order_; ++i) b[i] = 0.5 * b[i] + 0.5 * b[i + 1];
      }
    }
    ++part.depth;
    stack_.push_back(std::move(left));
    stack_.push_back(std::move(part));
  }

  std::size_t order_;
  std::size_t stride_;
  std::size_t weight_;
  std::size_t coordinate_;
  double sign_;
  std::vector<Part> stack_;
};

}  // namespace

double Box::diagonal() const {
  std::vector<double> sides(lo.size());
  for (std::size_t c = 0; c < lo.size(); ++c) sides[c] = hi[c] - lo[c];
  return detail::scaled_norm(sides);
}

Point Box::center() const {
  Point center(lo.size());
  for (std::size_t c = 0; c < lo.size(); ++c) center[c] = 0.5 * lo[c] + 0.5 * hi[c];
  return center;
}

void Box::include(std::span<const double> point) {
  if (empty()) {
    lo.assign(point.begin(), point.end());
    hi = lo;
    return;
  }
  if (point.size() != lo.size()) {
    throw InvalidArgument(
        fmt::format("a point of dimension {} in a box of dimension {}", point.size(), lo.size()));
  }
  for (std::size_t c = 0; c < lo.size(); ++c) {
    lo[c] = std::min(lo[c], point[c]);
    hi[c] = std::max(hi[c], point[c]);
  }
}

void Box::include(const Box& box) {
  if (box.empty()) return;
  include(box.lo);
  include(box.hi);
}

Box bounding_box(const Curve& curve) {
  const detail::Pieces pieces = detail::decompose(detail::premultiplied(curve));
  const auto dim = static_cast<std::size_t>(curve.dim());
  Box box{Point(dim), Point(dim)};
  for (std::size_t c = 0; c < dim; ++c) {
    Maximum upper(pieces, c, 1.0);
    Maximum lower(pieces, c, -1.0);
    double hi = -std::numeric_limits<double>::infinity();
    double lo = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      hi = upper.over(pieces[i], hi);
      lo = lower.over(pieces[i], lo);
    }
    box.lo[c] = -lo / pieces.scale;
    box.hi[c] = hi / pieces.scale;
  }
  return box;
}

}  // namespace v0
}  // namespace tandem
