#pragma once

#include <string>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/shape/shape.h"

namespace tandem::figures {

/// A sheet of pictures in rows, drawn as SVG: every row a label and a sequence of shapes or pieces of SVG.
class Sheet {
 public:
  /// cell: width and height of a picture, in user units.
  Sheet(double cell_width, double cell_height) : cell_width_(cell_width), cell_height_(cell_height) {}

  /// A row of shapes, all to one scale. `label` stands above it.
  void add_row(const std::string& label, const std::vector<Shape>& shapes);
  /// A row of SVG of the caller's, `height` tall.
  void add_svg(const std::string& label, const std::string& svg, double width, double height);

  [[nodiscard]] std::string svg() const;

 private:
  double cell_width_;
  double cell_height_;
  double width_ = 0.0;
  double height_ = 0.0;
  std::string body_;
};

/// In-betweens of two curves by their parameters alone, without matching: what the figures of [C] call naive.
[[nodiscard]] std::vector<Shape> naive_in_betweens(const Curve& a, const Curve& b,
                                                   const std::vector<double>& times);

}  // namespace tandem::figures
