#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tandem/surface/surface.h"

namespace tandem::figures {

/// Lines of a surface, seen from one side: what does not lie in the plane is projected along an oblique view.
class LineDrawing {
 public:
  /// A line through points, in user coordinates: y up in the plane, z up in space.
  void add_line(const std::vector<Point>& points, std::string_view stroke, double width);

  /// The surface's edges along u, boldly, and lines across: `count` of them, evenly spread in u. In the plane
  /// those parts of them on which the Jacobian has the sign of the smaller part are red.
  void add_rulings(const Surface& surface, int count);
  /// Lines of constant v, ends included.
  void add_lines_along(const Surface& surface, int count);

  /// All of it, fitted into a box.
  [[nodiscard]] std::string svg(double width, double height) const;

 private:
  struct Line {
    std::vector<Point> points;  ///< of the drawing, y down
    std::string stroke;
    double width;
  };
  std::vector<Line> lines_;
};

}  // namespace tandem::figures
