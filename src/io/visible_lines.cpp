#include "io/visible_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

constexpr double kStep = 1.0;             // pixels between places where visibility is asked
constexpr double kStraight = 0.1;         // pixels that a point may be off when it is left out
constexpr double kShortest = 1.5;         // pixels; what flickers up for less is noise
constexpr std::size_t kMostPoints = 300;  // of a part: FreeType strokes it, which makes several of each

double distance(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
}

/// Of p from the chord from a to b, or infinite when it lies beyond an end.
double off_chord(const std::array<double, 2>& p, const std::array<double, 2>& a,
                 const std::array<double, 2>& b) {
  const double length = distance(a, b);
  if (!(length > 0.0)) return distance(p, a);
  const double along = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / length;
  if (along < 0.0 || along > length) return INFINITY;
  return std::fabs((p[0] - a[0]) * (b[1] - a[1]) - (p[1] - a[1]) * (b[0] - a[0])) / length;
}

/// Ramer, Douglas, Peucker.
void simplify(const PixelLine& line, std::size_t first, std::size_t last, std::vector<bool>& kept) {
  std::size_t worst = first;
  double most = kStraight;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double off = off_chord(line[i], line[first], line[last]);
    if (off > most) {
      most = off;
      worst = i;
    }
  }
  if (worst == first) return;
  kept[worst] = true;
  simplify(line, first, worst, kept);
  simplify(line, worst, last, kept);
}

void add_part(std::vector<PixelLine>& parts, PixelLine& line) {
  PixelLine whole = std::exchange(line, {});
  double length = 0.0;
  for (std::size_t i = 1; i < whole.size(); ++i) length += distance(whole[i - 1], whole[i]);
  if (length < kShortest) return;
  std::vector<bool> kept(whole.size(), false);
  kept.front() = kept.back() = true;
  // In pieces: the recursion is as deep as the line is long.
  constexpr std::size_t kPiece = 256;
  for (std::size_t i = 0; i + 1 < whole.size(); i += kPiece) {
    const std::size_t end = std::min(i + kPiece, whole.size() - 1);
    kept[end] = true;
    simplify(whole, i, end, kept);
  }
  PixelLine part;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (!kept[i]) continue;
    part.push_back(whole[i]);
    if (part.size() == kMostPoints) {
      parts.push_back(part);
      part = {whole[i]};
    }
  }
  if (part.size() > 1) parts.push_back(std::move(part));
}

}  // namespace

std::vector<PixelLine> visible_parts(std::span<const Points> lines, const Camera& camera, const Faces& faces,
                                     double slack) {
  std::vector<PixelLine> parts;
  for (const Points& points : lines) {
    PixelLine part;
    const auto visit = [&](const Vector3& p) {
      if (faces.is_visible(p, slack)) {
        part.push_back({p[0], p[1]});
      } else {
        add_part(parts, part);
      }
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector3 to = faces.to_pixel(camera.place(points[i]));
      if (i > 0) {
        const Vector3 from = faces.to_pixel(camera.place(points[i - 1]));
        const double length = distance({from[0], from[1]}, {to[0], to[1]});
        const auto steps = static_cast<std::size_t>(std::ceil(length / kStep));
        for (std::size_t k = 1; k < steps; ++k) {
          visit(from + static_cast<double>(k) / static_cast<double>(steps) * (to - from));
        }
      }
      visit(to);
    }
    add_part(parts, part);
  }
  return parts;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
