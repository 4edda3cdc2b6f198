#include "tandem/surface/tessellate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "surface/random_surfaces.h"
#include "surface/solids.h"
#include "tandem/error.h"
#include "tandem/surface/edit.h"

namespace tandem {
namespace {

using std::numbers::pi;
using testing::RandomSurfaces;

TEST(Tessellate, ClosedSurfacesAreWatertightAndEncloseTheirVolume) {
  struct Case {
    Surface surface;
    double volume;
    double area;
  };
  const std::vector<Case> cases = {
      {testing::sphere(), 4.0 / 3.0 * pi, 4.0 * pi},
      {testing::torus(0.3), 2.0 * pi * pi * 0.09, 4.0 * pi * pi * 0.3},
      {testing::can(), 2.0 * pi, 6.0 * pi},
  };
  for (const Case& c : cases) {
    for (const double chord : {1e-2, 1e-3, 1e-4}) {
      const TriangleMesh mesh = tessellate(c.surface, {.chord = chord, .angle = 1.0});
      EXPECT_TRUE(is_watertight(mesh));
      // The chord distance is a share of the extent, some 4 here; the mesh is inside by some of it.
      EXPECT_NEAR(volume(mesh), c.volume, 4.0 * chord * c.area);
      EXPECT_NEAR(area(mesh), c.area, 20.0 * chord * c.area);
    }
  }
}

}  // namespace
}  // namespace tandem
