#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "io/match_picture_parts.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/io/path_data.h"
#include "tandem/shape/shape.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr int kLinks = 56;
constexpr int kGraphSamples = 400;  // polyline of a scalar curve
constexpr double kWide = 1.7;       // both curves wider than this times their height: one above the other

// The curve as it is drawn: planar. A scalar curve becomes its graph, of others the first two coordinates are
// taken.
Curve planar(const Curve& curve) {
  if (curve.dim() == 2) return curve;
  Points points;
  if (curve.dim() > 2) {
    for (std::size_t i = 0; i < curve.size(); ++i) points.push_back(curve.control_points()[i].first(2));
    return Curve(curve.degree(), curve.knots(), std::move(points), curve.weights());
  }
  std::vector<double> knots;
  const Interval domain = curve.domain();
  for (int i = 0; i <= kGraphSamples; ++i) {
    const double t = i == kGraphSamples ? domain.hi : domain.lo + domain.length() * i / kGraphSamples;
    const std::array<double, 2> row{t, curve.evaluate(t)[0]};
    points.push_back(row);
    knots.push_back(t);
  }
  knots.insert(knots.begin(), domain.lo);
  knots.push_back(domain.hi);
  return Curve(1, std::move(knots), std::move(points));
}

// The map from the curve's box into the middle of the frame.
Transform fit_into(const Box& box, const Frame& frame, double scale) {
  const Point center = box.center();
  return {scale,
          0.0,
          0.0,
          scale,
          frame.x + frame.width / 2.0 - scale * center[0],
          frame.y + frame.height / 2.0 - scale * center[1]};
}

double scale_for(const Box& box, const Frame& frame) {
  const double width = std::max(box.hi[0] - box.lo[0], std::numeric_limits<double>::min());
  const double height = std::max(box.hi[1] - box.lo[1], std::numeric_limits<double>::min());
  return std::min(frame.width / width, frame.height / height);
}

bool is_wide(const Box& box) {
  return box.hi[0] - box.lo[0] > kWide * (box.hi[1] - box.lo[1]);
}

std::array<Frame, 2> halves(const Frame& frame, bool stacked) {
  constexpr double kGap = 48.0;
  if (stacked) {
    const double height = (frame.height - kGap) / 2.0;
    return {Frame{frame.x, frame.y, frame.width, height},
            Frame{frame.x, frame.y + height + kGap, frame.width, height}};
  }
  const double width = (frame.width - kGap) / 2.0;
  return {Frame{frame.x, frame.y, width, frame.height},
          Frame{frame.x + width + kGap, frame.y, width, frame.height}};
}

// A quiet rainbow: equal steps look about equal, no colour screams.
std::string hue(double share) {
  const auto wave = [&](double phase) {
    double x = share + phase;
    x -= std::floor(x);
    const double ramp = std::clamp(std::fabs(x * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    return 0.22 + 0.58 * ramp;
  };
  return color(wave(0.0), 0.88 * wave(2.0 / 3.0), wave(1.0 / 3.0));
}

double wrapped(double t, const Curve& curve) {
  const Interval domain = curve.domain();
  if (domain.contains(t) || !curve.is_closed()) return domain.clamp(t);
  const double periods = std::floor((t - domain.lo) / domain.length());
  return domain.clamp(t - periods * domain.length());
}

// `count` pairs evenly spaced along the path, both curves counting alike.
std::vector<ParameterPair> evenly_spaced(const Correspondence& c, int count) {
  std::vector<double> along{0.0};
  for (std::size_t i = 1; i < c.points.size(); ++i) {
    along.push_back(along.back() + std::fabs(c.points[i].u - c.points[i - 1].u) / c.domain_u.length() +
                    std::fabs(c.points[i].v - c.points[i - 1].v) / c.domain_v.length());
  }
  std::vector<ParameterPair> pairs;
  for (int k = 0; k < count; ++k) {
    const double want = along.back() * k / (c.closed ? count : count - 1);
    const auto next = std::upper_bound(along.begin() + 1, along.end() - 1, want);
    const auto i = static_cast<std::size_t>(next - along.begin());
    const double length = along[i] - along[i - 1];
    const double share = length > 0.0 ? (want - along[i - 1]) / length : 0.0;
    const ParameterPair& p = c.points[i - 1];
    const ParameterPair& q = c.points[i];
    pairs.push_back({p.u + share * (q.u - p.u), p.v + share * (q.v - p.v)});
  }
  return pairs;
}

std::string outline(const Curve& curve) {
  const std::vector<CubicPath> path{to_cubic_path(curve, 0.05)};
  const char* fill = path[0].is_closed() ? "#232a36" : "none";
  return fmt::format(
      "<path d=\"{}\" fill=\"{}\" fill-opacity=\"0.07\" stroke=\"#232a36\" stroke-width=\"2\" "
      "stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n",
      format_path_data(path, {}, 2), fill);
}

}  // namespace

std::string draw_links(const Curve& a, const Curve& b, const Correspondence& correspondence, Frame frame) {
  std::array<Curve, 2> curves{planar(a), planar(b)};
  const std::array<Box, 2> boxes{bounding_box(curves[0]), bounding_box(curves[1])};
  const std::array<Frame, 2> frames = halves(frame, is_wide(boxes[0]) && is_wide(boxes[1]));
  std::array<double, 2> scales{scale_for(boxes[0], frames[0]), scale_for(boxes[1], frames[1])};
  // Curves of about the same size keep it, so that they can be compared.
  const double ratio = scales[0] / scales[1];
  if (ratio > 0.5 && ratio < 2.0) scales[0] = scales[1] = std::min(scales[0], scales[1]);
  std::string text;
  for (std::size_t i = 0; i < 2; ++i) {
    curves[i] = transform(curves[i], fit_into(boxes[i], frames[i], scales[i]));
    text += outline(curves[i]);
  }
  if (correspondence.points.size() < 2) return text;
  std::string links;
  std::string dots;
  const std::vector<ParameterPair> pairs = evenly_spaced(correspondence, kLinks);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Point p = curves[0].evaluate(wrapped(pairs[k].u, a));
    const Point q = curves[1].evaluate(wrapped(pairs[k].v, b));
    const std::string tint = hue(0.9 * static_cast<double>(k) / static_cast<double>(pairs.size()));
    const double radius = k == 0 ? 6.0 : 3.4;  // the start stands out
    links += fmt::format("<path d=\"M{} {}L{} {}\" stroke=\"{}\"/>\n", pixels(p[0]), pixels(p[1]),
                         pixels(q[0]), pixels(q[1]), tint);
    for (const Point& at : {p, q}) {
      dots += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", pixels(at[0]),
                          pixels(at[1]), radius, tint);
    }
  }
  return text + "<g fill=\"none\" stroke-width=\"1.1\" stroke-opacity=\"0.5\">\n" + links + "</g>\n" +
         "<g stroke=\"#ffffff\" stroke-width=\"1\">\n" + dots + "</g>\n";
}

}  // namespace v0
}  // namespace tandem
