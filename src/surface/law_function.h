#pragma once

#include "curve/evaluator.h"
#include "tandem/curve/curve.h"
#include "tandem/curve/interval.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// An increasing scalar curve, forwards and backwards.
class LawFunction {
 public:
  explicit LawFunction(const Curve& law) : evaluator_(law), domain_(law.domain()) {}

  [[nodiscard]] double value(double u) const {
    double v = 0.0;
    evaluator_.point(u, {&v, 1});
    return v;
  }

  /// Where it has the value, by halving as far as doubles go; an end of the domain for a value beyond.
  [[nodiscard]] double parameter(double v) const {
    double lo = domain_.lo;
    double hi = domain_.hi;
    if (v <= value(lo)) return lo;
    if (v >= value(hi)) return hi;
    while (true) {
      const double middle = lo + 0.5 * (hi - lo);
      if (!(lo < middle && middle < hi)) return middle;
      (value(middle) < v ? lo : hi) = middle;
    }
  }

 private:
  Evaluator evaluator_;
  Interval domain_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
