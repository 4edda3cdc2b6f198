#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "match/random_curves.h"
#include "match/turns.h"
#include "tandem/curve/arc_length.h"
#include "tandem/curve/edit.h"
#include "tandem/io/font.h"
#include "tandem/io/load.h"
#include "tandem/match/match.h"
#include "tandem/match/rotation.h"

namespace tandem {
namespace {

using testing_curves::moved;
using testing_curves::product;
using testing_curves::random_rotation;
using testing_curves::turned;
using testing_curves::uniform;

struct NamedCurve {
  std::string name;
  Curve curve;
};

/// A smooth loop in space.
Curve space_loop(std::mt19937& random) {
  const std::size_t n = 6 + random() % 6;
  Points points(3, n + 3);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t c = 0; c < 3; ++c) points[i][c] = uniform(random, -1.0, 1.0);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t c = 0; c < 3; ++c) points[n + i][c] = points[i][c];
  }
  std::vector<double> knots;
  for (std::size_t k = 0; k < n + 7; ++k) knots.push_back(static_cast<double>(k));
  return Curve(3, std::move(knots), std::move(points));
}

std::vector<NamedCurve> two_hundred_shapes() {
  std::vector<NamedCurve> shapes;
  const std::string icons = std::string(TANDEM_TEST_DATA) + "/icons/";
  for (const char* icon : {"account", "arrow-right-bold", "bell", "bird", "cat", "check-bold", "cog", "heart",
                           "home", "leaf", "star", "umbrella"}) {
    for (const Curve& contour : load_shape(icons + icon + ".svg").contours) {
      if (contour.is_closed()) shapes.push_back({icon, contour});
    }
  }
  for (const char* font : {"DejaVuSans.ttf", "DejaVuSerif.ttf"}) {
    for (const char c : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789&@")) {
      const std::string path = std::string("/usr/share/fonts/truetype/dejavu/") + font;
      shapes.push_back({std::string(font) + '#' + c, read_glyph(path, std::string(1, c)).contours.front()});
    }
  }
  std::mt19937 random(7);
  while (shapes.size() < 200) shapes.push_back({"loop " + std::to_string(shapes.size()), space_loop(random)});
  return shapes;
}

std::vector<Point> points_along(const Curve& curve, int count) {
  const ArcLength arc(curve);
  std::vector<Point> points;
  for (int k = 0; k < count; ++k) {
    points.push_back(curve.evaluate(arc.parameter_at(arc.length() * k / count)));
  }
  return points;
}

/// Largest distance of points of the turned curve from the curve, both centred, as a share of the extent.
double symmetry_defect(const Curve& curve, const Rotation& rotation) {
  constexpr int kDense = 2000;
  std::vector<Point> points = points_along(curve, kDense);
  Point center(points[0].size(), 0.0);
  for (const Point& p : points) {
    for (std::size_t c = 0; c < p.size(); ++c) center[c] += p[c] / kDense;
  }
  for (Point& p : points) {
    for (std::size_t c = 0; c < p.size(); ++c) p[c] -= center[c];
  }
  double worst = 0.0;
  for (int k = 0; k < kDense; k += 20) {
    Point q = points[static_cast<std::size_t>(k)];
    rotation.apply(q, q);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& p : points) {
      double square = 0.0;
      for (std::size_t c = 0; c < p.size(); ++c) square += (p[c] - q[c]) * (p[c] - q[c]);
      nearest = std::min(nearest, square);
    }
    worst = std::max(worst, nearest);
  }
  return std::sqrt(worst) / curve.extent();
}

// Spec C11. A shape with a symmetry of its own may be found turned by it as well.
TEST(Turned, TwoHundredShapesAreFound) {
  std::mt19937 random(11);
  int without_symmetry = 0;
  for (const auto& [name, shape] : two_hundred_shapes()) {
    const int dim = shape.dim();
    const Rotation turn = random_rotation(random, dim);
    const Interval domain = shape.domain();
    Curve other = move_seam(shape, domain.lo + uniform(random, 0.05, 0.95) * domain.length());
    if (random() % 2 == 0) other = reverse(other);
    other = turned(other, turn, uniform(random, 0.2, 5.0));
    std::vector<double> by;
    for (int c = 0; c < dim; ++c) by.push_back(uniform(random, -50.0, 50.0));
    other = moved(other, by);

    const Match found = match(shape, other, {.samples = {64, 64}, .rotate = true});
    const Rotation rotation(dim, found.report.rotation);
    const Rotation defect = product(turn.inverse(), rotation);
    EXPECT_LT(found.report.cost, 1e-6) << name;
    EXPECT_TRUE(found.report.validity.valid) << name;
    if (std::abs(defect.degrees()) <= 1e-3 * 180.0 / 3.14159265358979) {
      ++without_symmetry;
    } else {
      EXPECT_LT(symmetry_defect(shape, defect), 2e-3)
          << name << ", off by " << defect.degrees() << " degrees";
    }
  }
  EXPECT_GE(without_symmetry, 150);
  RecordProperty("without symmetry", without_symmetry);
}

}  // namespace
}  // namespace tandem
