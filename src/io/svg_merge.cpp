#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "io/svg_reader.h"
#include "tandem/curve/arc_length.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/measures.h"

namespace tandem {
inline namespace v0 {
namespace {

// Which of two areas is larger need not be known more closely, as a share of the contour's extent.
constexpr double kTolerance = 1e-3;

/// Inside and along the line, as far as they are painted; what overlaps counts twice.
double painted_area(const Shape& shape, const Style& style) {
  double area = 0.0;
  for (const Curve& contour : shape.contours) {
    const double extent = bounding_box(contour).diagonal();
    if (extent == 0.0) continue;
    const CubicPath path = to_cubic_path(contour, kTolerance * extent);
    if (style.fill.paints()) area += std::fabs(signed_area(path));
    if (style.stroke.paints()) area += style.stroke_width * arc_length(contour, kTolerance);
  }
  return area;
}

struct Painted {
  Style style;
  double area = 0.0;
};

// That of the contours that lie in one element, where they agree; single ones of several elements are filled
// each on its own.
FillRule common_fill_rule(const std::vector<SvgElement>& elements) {
  if (elements.size() == 1) return elements.front().shape.fill_rule;
  bool several = false;
  bool all_evenodd = true;
  for (const SvgElement& element : elements) {
    if (element.shape.contours.size() < 2) continue;
    several = true;
    all_evenodd = all_evenodd && element.shape.fill_rule == FillRule::evenodd;
  }
  return several && all_evenodd ? FillRule::evenodd : FillRule::nonzero;
}

}  // namespace

Drawing merge(const SvgPicture& picture) {
  Drawing drawing;
  drawing.view_box = picture.view_box;
  drawing.missed = picture.missed;
  drawing.shape.fill_rule = common_fill_rule(picture.elements);
  std::vector<Painted> styles;
  for (const SvgElement& element : picture.elements) {
    const Shape& shape = element.shape;
    drawing.shape.contours.insert(drawing.shape.contours.end(), shape.contours.begin(), shape.contours.end());
    if (!element.style) continue;
    auto same = std::find_if(styles.begin(), styles.end(),
                             [&](const Painted& painted) { return painted.style == *element.style; });
    if (same == styles.end()) same = styles.insert(same, {*element.style, 0.0});
    same->area += painted_area(shape, *element.style);
  }
  if (styles.empty()) return drawing;
  const auto largest = std::max_element(styles.begin(), styles.end(), [](const Painted& a, const Painted& b) {
    return a.area < b.area;  // of equals the first
  });
  drawing.style = largest->style;
  drawing.several_styles = styles.size() > 1;
  const auto is_line = [](const Painted& painted) {
    return painted.style.stroke.paints() && !painted.style.fill.paints();
  };
  if (!drawing.style->stroke.paints() && std::any_of(styles.begin(), styles.end(), is_line)) {
    drawing.missed.emplace_back("its lines beside what is filled");
  }
  return drawing;
}

}  // namespace v0
}  // namespace tandem
