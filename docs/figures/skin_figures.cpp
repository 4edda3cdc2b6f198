#include "skin_figures.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "sheet.h"
#include "tandem/io/files.h"
#include "tandem/io/json.h"
#include "tandem/io/scene.h"
#include "tandem/io/surface_picture.h"
#include "tandem/surface/loft.h"
#include "tandem/surface/skin.h"
#include "tandem/surface/solid.h"

namespace tandem::figures {
namespace {

constexpr int kSize = 560;  // pixels of the longer side

// A picture as part of another one, and its size as it says itself.
struct Part {
  std::string svg;
  double width = 0.0;
  double height = 0.0;
};

double attribute(const std::string& svg, const std::string& name) {
  return std::stod(svg.substr(svg.find(name + "=\"") + name.size() + 2));
}

Part part_of(const Scene& scene) {
  std::string svg = format_scene_svg(scene, kSize);
  const double width = attribute(svg, " width");
  const double height = attribute(svg, " height");
  return {std::move(svg), width, height};
}

void add(Sheet& sheet, const std::string& label, const Scene& scene) {
  const Part part = part_of(scene);
  sheet.add_svg(label, part.svg, part.width, part.height);
}

/// [C] Figure 14: five sections with a bell each.
std::string figure_14() {
  const std::string path = "examples/data/bells.json";
  const std::vector<Curve> sections = parse_json_curves(read_file(path), path);
  Sheet sheet(0, 0);
  add(sheet, "Skinned by parameter", scene_of(loft(sections).surface, sections));
  add(sheet, "In step", scene_of(skin(sections).surface, sections));
  return sheet.svg();
}

Curve circle(double x, double y, double z, double r) {
  constexpr int n = 24;
  Points points(3, n + 3);
  std::vector<double> knots;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(i) / n;
    points[i][0] = x + r * std::cos(a);
    points[i][1] = y + r * std::sin(a);
    points[i][2] = z;
  }
  for (int i = 0; i < n + 7; ++i) knots.push_back(i);
  return Curve(3, std::move(knots), std::move(points));
}

/// Contours of one, two and three parts: level by level a solid.
std::string contours_to_solid_figure() {
  const std::vector<std::vector<Curve>> levels = {
      {circle(0, 0, 0, 2.2)},
      {circle(0, 0, 1, 2)},
      {circle(-1.6, 0, 2, 1.1), circle(1.6, 0, 2, 1.1)},
      {circle(-2.2, 0, 3, 1.1), circle(2.2, 0, 3, 1)},
      {circle(-2.4, 1, 4, 0.7), circle(-2.4, -1, 4, 0.7), circle(2.5, 0, 4, 0.9)},
      {circle(-2.4, 1.4, 5, 0.6), circle(-2.4, -1.4, 5, 0.6), circle(2.6, 0, 5, 0.6)}};
  std::vector<Curve> contours;
  for (const auto& level : levels) contours.insert(contours.end(), level.begin(), level.end());
  Sheet sheet(0, 0);
  add(sheet, "Contours on six levels, and the closed mesh through them",
      scene_of(contours_to_solid(levels).mesh, contours));
  return sheet.svg();
}

}  // namespace

std::map<std::string, std::string> skin_figures() {
  return {{"figure-14.svg", figure_14()}, {"contours.svg", contours_to_solid_figure()}};
}

}  // namespace tandem::figures
