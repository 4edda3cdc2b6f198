// Two planar curves in step: B comes back reparametrised, exactly, and runs over A's domain.
#include <cstdio>

#include "tandem/tandem.h"

int main() {
  const tandem::Curve a = tandem::Curve::bezier({{0, 0}, {1, 2}, {3, 2}, {4, 0}});
  const tandem::Curve b = tandem::Curve::clamped_uniform(2, {{0, 1}, {0, 3}, {3, 3}, {3, 1}, {5, 1}});
  const tandem::Match match = tandem::match(a, b);
  const tandem::Point p = match.curve.evaluate(0.5);  // belongs to a.evaluate(0.5)
  std::printf("cost %.4f, valid %d, b in step at u = 0.5: (%.3f, %.3f)\n", match.report.cost,
              match.report.validity.valid, p[0], p[1]);

  return match.report.validity.valid ? 0 : 1;
}
