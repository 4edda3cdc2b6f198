#include "sweep_figure.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "line_drawing.h"
#include "sheet.h"
#include "tandem/curve/compatible.h"
#include "tandem/curve/edit.h"
#include "tandem/match/match.h"
#include "tandem/surface/loft.h"

namespace tandem::figures {
namespace {

constexpr double kWidth = 380.0;
constexpr double kHeight = 260.0;
constexpr int kSections = 13;  // of a sweep
constexpr int kRulings = 72;
constexpr double kRadius = 2.6;  // of the arc of the sweep

/// A closed quadratic through the plane y = 0 of space, by the corners (x, z) of its control polygon.
Curve outline(const std::vector<std::array<double, 2>>& corners) {
  Points points(3, corners.size() + 2);
  std::vector<double> knots;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i][0] = corners[i % corners.size()][0];
    points[i][2] = corners[i % corners.size()][1];
  }
  for (std::size_t i = 0; i < points.size() + 3; ++i) knots.push_back(static_cast<double>(i));
  return with_domain(Curve(2, std::move(knots), std::move(points)), {0.0, 1.0});
}

Curve desk() {
  return outline({{-1.0, 0.45},
                  {-1.0, 0.2},
                  {-0.8, 0.2},
                  {-0.8, -0.5},
                  {-0.6, -0.5},
                  {-0.6, 0.2},
                  {0.6, 0.2},
                  {0.6, -0.5},
                  {0.8, -0.5},
                  {0.8, 0.2},
                  {1.0, 0.2},
                  {1.0, 0.45}});
}

/// It begins at its tail, and has more corners at its head.
Curve turtle() {
  return outline({{-0.8, 0.2},
                  {-1.2, 0.05},
                  {-0.75, 0.0},
                  {-0.7, -0.4},
                  {-0.35, -0.4},
                  {-0.4, -0.05},
                  {0.3, -0.05},
                  {0.35, -0.4},
                  {0.65, -0.4},
                  {0.65, 0.0},
                  {0.9, 0.15},
                  {1.1, 0.15},
                  {1.3, 0.25},
                  {1.3, 0.45},
                  {1.1, 0.55},
                  {0.9, 0.4},
                  {0.65, 0.35},
                  {0.3, 0.8},
                  {-0.45, 0.8}});
}

/// The curve with `place` applied to its control points: an affine map of the curve.
template <class Place>
Curve placed(const Curve& curve, const Place& place) {
  Points points(3, curve.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<double, 3> p = place(curve.control_points()[i]);
    for (std::size_t c = 0; c < 3; ++c) points[i][c] = p[c];
  }
  return Curve(curve.degree(), curve.knots(), std::move(points));
}

/// The surface that the outline sweeps while it goes round an arc and becomes the other one: curves in one
/// function space.
Surface sweep(const std::vector<Curve>& ends) {
  std::vector<Curve> sections;
  for (int k = 0; k < kSections; ++k) {
    const double s = static_cast<double>(k) / (kSections - 1);
    const double turn = 0.5 * std::numbers::pi * s;
    Points points(3, ends[0].size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        points[i][c] = (1.0 - s) * ends[0].control_points()[i][c] + s * ends[1].control_points()[i][c];
      }
    }
    sections.push_back(placed(Curve(ends[0].degree(), ends[0].knots(), std::move(points)), [&](auto p) {
      const double r = kRadius + p[0];
      return std::array{r * std::cos(turn), r * std::sin(turn), p[2]};
    }));
  }
  return loft(sections).surface;
}

/// The ruled surface between outlines in parallel planes.
Surface ruling(const std::vector<Curve>& ends) {
  const auto behind = [](auto p) { return std::array{p[0] + 0.4, 2.6, p[2]}; };
  return loft(std::array{ends[0], placed(ends[1], behind)}, {.degree = 1}).surface;
}

LineDrawing drawing_of(const Surface& surface, int lines_along) {
  LineDrawing drawing;
  if (lines_along > 0) drawing.add_lines_along(surface, lines_along);
  drawing.add_rulings(surface, kRulings);
  return drawing;
}

std::string side_by_side(const Surface& left, const Surface& right, int lines_along) {
  return drawing_of(left, lines_along).svg(kWidth, kHeight) +
         fmt::format("<g transform=\"translate({:.0f} 0)\">\n{}</g>\n", kWidth,
                     drawing_of(right, lines_along).svg(kWidth, kHeight));
}

std::string figure_2() {
  const std::array<Curve, 2> given = {desk(), turtle()};
  const std::vector<Curve> by_parameter = make_compatible(given);
  // Matched where they lie, in one plane; the order 2 law is enough for lines.
  const std::vector<Match> chain = match_chain(given);
  const std::vector<Curve> in_step = make_compatible(std::array<Curve, 2>{given[0], chain.front().curve});
  Sheet sheet(kWidth, kHeight);
  sheet.add_svg("Ruled from outline to outline, by parameter and in step",
                side_by_side(ruling(by_parameter), ruling(in_step), 0), 2.0 * kWidth, kHeight);
  sheet.add_svg("Swept along an arc while one becomes the other, by parameter and in step",
                side_by_side(sweep(by_parameter), sweep(in_step), kSections - 1), 2.0 * kWidth, kHeight);
  return sheet.svg();
}

}  // namespace

std::map<std::string, std::string> sweep_figures() {
  return {{"ruled-2.svg", figure_2()}};
}

}  // namespace tandem::figures
