#include "line_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tandem/surface/edit.h"

namespace tandem::figures {

namespace {

constexpr int kPieces = 160;  // of a line along the surface
constexpr int kAcross = 24;   // and of one across it
constexpr int kEdgeSteps = 2000;
constexpr double kEdgePiece = 0.005;  // shortest piece of an edge, as a share of the surface's size

/// Oblique: depth runs to the right and up.
Point projected(const Point& p) {
  if (p.size() == 2) return {p[0], -p[1]};
  return {p[0] + 0.45 * p[1], -p[2] - 0.35 * p[1]};
}

double distance(const Point& p, const Point& q) {
  return p.size() == 2 ? std::hypot(p[0] - q[0], p[1] - q[1])
                       : std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// Is every point at one height? Then the other two coordinates are drawn.
bool is_flat(const Surface& surface) {
  if (surface.dim() != 3) return false;
  const double z = surface.control_points()[0][2];
  for (std::size_t i = 0; i < surface.control_points().size(); ++i) {
    if (surface.control_points()[i][2] != z) return false;
  }
  return true;
}

Point at(const Surface& surface, double u, double v, bool flat) {
  Point p = surface.evaluate(u, v);
  if (flat) p.pop_back();
  return p;
}

double jacobian(const Surface& surface, double u, double v) {
  const Points d = surface.derivatives(u, v, 1);
  return d[1][0] * d[2][1] - d[1][1] * d[2][0];
}

double place(const Interval& domain, int i, int count) {
  return domain.lo + domain.length() * i / count;
}

/// The sign that less of the surface has.
double rarer_sign(const Surface& surface) {
  int positive = 0;
  int all = 0;
  for (int i = 0; i < kPieces; ++i) {
    for (int j = 0; j < kAcross; ++j, ++all) {
      const double u = place(surface.domain(Along::u), 2 * i + 1, 2 * kPieces);
      const double v = place(surface.domain(Along::v), 2 * j + 1, 2 * kAcross);
      if (jacobian(surface, u, v) > 0.0) ++positive;
    }
  }
  return 2 * positive > all ? -1.0 : 1.0;
}

}  // namespace

void LineDrawing::add_line(const std::vector<Point>& points, std::string_view stroke, double width) {
  Line line{{}, std::string(stroke), width};
  for (const Point& p : points) line.points.push_back(projected(p));
  lines_.push_back(std::move(line));
}

void LineDrawing::add_rulings(const Surface& surface, int count) {
  const bool flat = is_flat(surface);
  const bool planar = flat || surface.dim() == 2;
  const double wrong = planar ? rarer_sign(surface) : 0.0;
  const Interval u_domain = surface.domain(Along::u);
  const Interval v_domain = surface.domain(Along::v);
  for (int i = 0; i <= count; ++i) {
    const double u = place(u_domain, i, count);
    std::vector<Point> whole;
    std::vector<Point> red;
    for (int j = 0; j <= kAcross; ++j) {
      const double v = place(v_domain, j, kAcross);
      whole.push_back(at(surface, u, v, flat));
      if (wrong != 0.0 && jacobian(surface, u, v) * wrong > 0.0) red.push_back(whole.back());
    }
    add_line(whole, "#7a8ba0", 0.7);
    if (red.size() > 1) add_line(red, "#d33", 1.4);
  }
  for (const double v : {v_domain.lo, v_domain.hi}) {
    std::vector<Point> edge = {at(surface, u_domain.lo, v, flat)};
    for (int i = 1; i <= kEdgeSteps; ++i) {
      // The law may make an edge much faster in one place than in another.
      const Point p = at(surface, place(u_domain, i, kEdgeSteps), v, flat);
      if (i == kEdgeSteps || distance(p, edge.back()) > kEdgePiece * surface.extent()) edge.push_back(p);
    }
    add_line(edge, "#124", 2.0);
  }
}

void LineDrawing::add_lines_along(const Surface& surface, int count) {
  for (int j = 0; j <= count; ++j) {
    std::vector<Point> line;
    for (int i = 0; i <= kPieces; ++i) {
      line.push_back(at(surface, place(surface.domain(Along::u), i, kPieces),
                        place(surface.domain(Along::v), j, count), false));
    }
    add_line(line, "#c9a24a", 0.7);
  }
}

std::string LineDrawing::svg(double width, double height) const {
  Point lo = lines_.front().points.front();
  Point hi = lo;
  for (const Line& line : lines_) {
    for (const Point& p : line.points) {
      for (std::size_t c = 0; c < 2; ++c) {
        lo[c] = std::min(lo[c], p[c]);
        hi[c] = std::max(hi[c], p[c]);
      }
    }
  }
  constexpr double kMargin = 8.0;
  const double scale =
      std::min((width - 2 * kMargin) / (hi[0] - lo[0]), (height - 2 * kMargin) / (hi[1] - lo[1]));
  std::string svg;
  for (const Line& line : lines_) {
    std::string points;
    for (const Point& p : line.points) {
      points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ",
                            0.5 * width + scale * (p[0] - 0.5 * (lo[0] + hi[0])),
                            0.5 * height + scale * (p[1] - 0.5 * (lo[1] + hi[1])));
    }
    svg += fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" points=\"{}\"/>\n",
                       line.stroke, line.width, points);
  }
  return svg;
}

}  // namespace tandem::figures
