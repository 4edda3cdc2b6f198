// The ruled surface between two curves of a file, and how good it is.
#include <cstdio>
#include <vector>

#include "tandem/io/load.h"
#include "tandem/tandem.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::vector<tandem::Curve> curves = tandem::load_shape(argv[1]).contours;
  const tandem::RuledSurface ruled = tandem::rule(curves[0], curves[1]);
  const tandem::RuledReport& report = ruled.report;
  std::printf("<T1,T2> > 0 on %.2f %% of the length, largest crease %.3f rad, mean warp %.3f rad\n",
              100.0 * report.tangents.valid_share, report.rulings.crease_angle,
              report.rulings.mean_warp_angle);
  const tandem::Point middle = ruled.surface.evaluate(0.5, 0.5);  // half-way along the ruling at u = 0.5
  std::printf("%zu x %zu control points; (%.3f, %.3f, %.3f)\n", ruled.surface.size(tandem::Along::u),
              ruled.surface.size(tandem::Along::v), middle[0], middle[1], middle[2]);

  return report.rulings.crease_angle < 0.0175 ? 0 : 1;
}
