#include "segment_figures.h"

#include <fmt/format.h>

#include <vector>

#include "sheet.h"
#include "tandem/io/load.h"
#include "tandem/io/path_data.h"
#include "tandem/tandem.h"

namespace tandem::figures {

namespace {

const std::vector<double> kTimes = {0.0, 0.2, 0.4, 0.6, 0.8, 1.0};

CubicPath path_of(const std::string& data) {
  const Curve curve = load_shape(data).contours.front();
  return to_cubic_path(curve, 1e-9 * curve.extent());
}

Shape shape_of(const CubicPath& path) {
  return {{to_curve(path)}};
}

std::vector<Shape> hermite_row(const CubicPath& a, const CubicPath& b) {
  const HermiteBlend blend(a, b);
  std::vector<Shape> shapes;
  for (double s : kTimes) shapes.push_back(shape_of(blend.at(s)));
  return shapes;
}

std::vector<Shape> bezier_row(const CubicPath& a, const CubicPath& b) {
  std::vector<Shape> shapes;
  for (double s : kTimes) shapes.push_back(shape_of(bezier_blend(a, b, s)));
  return shapes;
}

/// A path with the two handles of its middle joint.
std::string with_handles(const CubicPath& path, const char* color, double width) {
  const Points& p = path.control_points();
  std::string svg = fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n",
                                format_path_data(std::vector<CubicPath>{path}, {}, 2), color, width);
  svg += fmt::format(
      "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}\" fill=\"none\" stroke=\"#e8590c\"/>\n", p[2][0],
      p[2][1], p[3][0], p[3][1], p[4][0], p[4][1]);
  for (std::size_t i : {2, 3, 4}) {
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"#e8590c\"/>\n", p[i][0], p[i][1]);
  }
  return svg;
}

/// Figure 1: the joint of two segments, smooth in both curves, blended in both forms.
std::string joint() {
  const CubicPath a = path_of("M10 90C20 60 60 20 100 20C120 20 170 50 190 90");
  const CubicPath b = path_of("M10 200C60 230 95 235 95 190C95 130 130 120 190 150");
  const auto picture = [&](const CubicPath& half) {
    return with_handles(a, "#b6c2cc", 2) + with_handles(b, "#b6c2cc", 2) + with_handles(half, "#3b6b8f", 3);
  };
  Sheet sheet(0, 0);
  sheet.add_svg("s = 1/2 in Bezier form: a corner", picture(bezier_blend(a, b, 0.5)), 200, 240);
  sheet.add_svg("s = 1/2 in Hermite form: smooth", picture(HermiteBlend(a, b).at(0.5)), 200, 240);
  return sheet.svg();
}

/// Figure 2: a path through the joints of five segments and of three.
std::string graph() {
  const CubicPath a = path_of(
      "M0 0C10 -20 20 -20 30 0C35 5 40 5 45 0C55 -20 65 -20 75 0C80 30 90 30 95 0C105 -10 115 -10 125 0");
  const CubicPath b = path_of("M0 0C15 -30 60 -30 75 0C80 35 95 35 100 0C110 -10 120 -10 130 0");
  const SegmentMatch match = match_segments(a, b, {.direction = Direction::forward});
  constexpr double kCell = 44.0;
  std::string svg;
  for (std::size_t i = 0; i <= a.segment_count(); ++i) {
    svg += fmt::format(
        "<path d=\"M{0} 24V{1}\" stroke=\"#bbb\"/><text class=\"small middle\" x=\"{0}\" "
        "y=\"16\">{2}</text>\n",
        20 + kCell * static_cast<double>(i), 24 + kCell * static_cast<double>(b.segment_count()), i);
  }
  for (std::size_t j = 0; j <= b.segment_count(); ++j) {
    svg += fmt::format(
        "<path d=\"M20 {0}H{1}\" stroke=\"#bbb\"/><text class=\"small\" x=\"6\" y=\"{2}\">{3}</text>\n",
        24 + kCell * static_cast<double>(j), 20 + kCell * static_cast<double>(a.segment_count()),
        28 + kCell * static_cast<double>(j), j);
  }
  std::string d;
  for (const Node& node : match.path) {
    d += fmt::format("{}{} {}", d.empty() ? 'M' : 'L', 20 + kCell * node.i, 24 + kCell * node.j);
    svg += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"5\" fill=\"#1d2b53\"/>\n", 20 + kCell * node.i,
                       24 + kCell * node.j);
  }
  svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#1d2b53\" stroke-width=\"3\"/>\n", d);
  Sheet sheet(130, 70);
  sheet.add_svg("Joints of five segments (across) and of three (down), and the optimal path", svg, 260, 172);
  sheet.add_row("Blended along it", hermite_row(match.a, match.b));
  return sheet.svg();
}

/// Figure 3: two smooth loops in both forms.
std::string smoothness() {
  const CubicPath a =
      path_of("M20 50C20 20 40 0 70 0C100 0 120 20 120 50C120 80 100 100 70 100C40 100 20 80 20 50Z");
  const CubicPath b =
      path_of("M30 80C-10 60 20 -10 60 20C75 31 70 60 90 50C130 30 150 90 110 95C70 100 50 90 30 80Z");
  const SegmentMatch match = match_segments(a, b);
  Sheet sheet(120, 110);
  sheet.add_row("Bezier form", bezier_row(match.a, match.b));
  sheet.add_row("Hermite form", hermite_row(match.a, match.b));
  return sheet.svg();
}

/// Vertices against vertices, the classical way: three steps, squared distances between centred vertices.
/// Where a step moves along one polygon only, the other one's edge is a point.
SegmentMatch match_vertices(const CubicPath& a, const CubicPath& b) {
  const auto centred = [](const CubicPath& path) {
    Points points(2, path.segment_count());
    Point center(2, 0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        points[i][k] = path.control_points()[3 * i][k];
        center[k] += points[i][k] / static_cast<double>(points.size());
      }
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = 0; k < 2; ++k) points[i][k] -= center[k];
    }
    return points;
  };
  const Points p = centred(a);
  const Points q = centred(b);
  NodeTable table{p.size(), q.size(), {}, std::vector<std::uint8_t>(p.size() * q.size())};
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      const double x = p[i][0] - q[j][0];
      const double y = p[i][1] - q[j][1];
      table.cost.push_back(x * x + y * y);
    }
  }
  const Path path = closed_path(table);
  const auto polygon = [&](const CubicPath& from, int Node::*index) {
    const auto n = static_cast<int>(from.segment_count());
    const auto vertex = [&](std::size_t k) {
      return from.control_points()[static_cast<std::size_t>(3 * (path.nodes[k].*index % n))];
    };
    Points points;
    points.push_back(vertex(0));
    for (std::size_t k = 1; k < path.nodes.size(); ++k) {
      for (const double t : {1.0 / 3.0, 2.0 / 3.0, 1.0}) {
        Point point(2);
        for (std::size_t d = 0; d < 2; ++d) point[d] = (1.0 - t) * vertex(k - 1)[d] + t * vertex(k)[d];
        points.push_back(t == 1.0 ? Point(vertex(k).begin(), vertex(k).end()) : point);
      }
    }
    return CubicPath(std::move(points), true);
  };
  return {polygon(a, &Node::i), polygon(b, &Node::j), {}, {}};
}

/// Figure 4: polygons.
std::string polygons() {
  const CubicPath a = path_of("M0 60L30 60L30 20L50 0L70 20L70 60L100 60L100 100L0 100Z");
  const CubicPath b = path_of("M0 40L60 40L60 10L90 10L90 40L110 40L110 90L0 90Z");
  const SegmentMatch vertices = match_vertices(a, b);
  const SegmentMatch segments = match_segments(a, b);
  Sheet sheet(120, 100);
  sheet.add_row("Vertex to vertex", hermite_row(vertices.a, vertices.b));
  sheet.add_row("Segment to segment", hermite_row(segments.a, segments.b));
  return sheet.svg();
}

/// Figure 5: curves with alike features and different numbers of segments.
std::string features() {
  const CubicPath a = path_of(
      "M0 50C20 20 60 10 90 30C100 36 108 42 115 48L140 25C136 42 136 58 140 75L115 54C105 70 60 95 25 72C14 "
      "65 6 58 0 50Z");
  const CubicPath b = path_of(
      "M5 40C14 26 26 18 40 14C46 4 56 0 66 2C62 8 62 12 64 16C80 22 92 32 100 44C106 34 114 28 124 26C118 "
      "36 116 44 116 52"
      "C118 60 122 68 128 74C116 74 106 68 100 60C86 76 64 84 42 78C26 74 12 60 5 40Z");
  const SegmentMatch match = match_segments(a, b);
  Sheet sheet(120, 100);
  sheet.add_row(fmt::format("{} segments against {}, redrawn with {}", a.segment_count(), b.segment_count(),
                            match.a.segment_count()),
                hermite_row(match.a, match.b));
  return sheet.svg();
}

}  // namespace

std::map<std::string, std::string> segment_figures() {
  return {{"segments-1.svg", joint()},
          {"segments-2.svg", graph()},
          {"segments-3.svg", smoothness()},
          {"segments-4.svg", polygons()},
          {"segments-5.svg", features()}};
}

}  // namespace tandem::figures
