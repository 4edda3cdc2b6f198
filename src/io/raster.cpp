#include "io/raster.h"

#include <fmt/format.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_STROKER_H

#include <algorithm>
#include <cmath>
#include <limits>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr double kUnits = 64.0;              // FreeType's coordinates are 26.6
constexpr double kFarthest = 200'000.0;      // pixels; what lies beyond is cut off, lest FreeType overflow
constexpr std::size_t kMostPoints = 32'767;  // of an outline

void check(FT_Error error, const char* what) {
  if (error != 0) throw InvalidArgument(fmt::format("picture: FreeType cannot {} (error {})", what, error));
}

/// What an FT_Outline points to.
struct OutlineData {
  std::vector<FT_Vector> points;
  std::vector<char> tags;
  std::vector<short> contours;

  [[nodiscard]] FT_Outline outline(int flags) {
    FT_Outline result{};
    result.n_points = static_cast<short>(points.size());
    result.n_contours = static_cast<short>(contours.size());
    result.points = points.data();
    result.tags = tags.data();
    result.contours = contours.data();
    result.flags = flags;
    return result;
  }
};

FT_Pos units(double pixels) {
  return static_cast<FT_Pos>(std::lround(std::clamp(pixels, -kFarthest, kFarthest) * kUnits));
}

// FreeType's y axis points up.
OutlineData outline_of(std::span<const CubicPath* const> paths, const Canvas& canvas) {
  OutlineData data;
  for (const CubicPath* path : paths) {
    const Points& points = path->control_points();
    // The last point of a closed path is the first one, which FreeType adds by itself.
    const std::size_t count = points.size() - (path->is_closed() ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 p = canvas.to_pixels({points[i][0], points[i][1]});
      data.points.push_back({units(p.x), units(canvas.height - p.y)});
      data.tags.push_back(i % 3 == 0 ? FT_CURVE_TAG_ON : FT_CURVE_TAG_CUBIC);
    }
    if (data.points.size() > kMostPoints) {
      throw InvalidArgument(fmt::format(
          "picture: the contours have more than {} control points, too many for a picture of pixels",
          kMostPoints));
    }
    data.contours.push_back(static_cast<short>(data.points.size() - 1));
  }
  return data;
}

// In FreeType's units, in which it would stroke it.
bool is_point(const CubicPath& path, const Canvas& canvas) {
  const CubicPath* const one[] = {&path};
  const OutlineData data = outline_of(one, canvas);
  return std::all_of(data.points.begin(), data.points.end(), [&](const FT_Vector& p) {
    return p.x == data.points.front().x && p.y == data.points.front().y;
  });
}

// FreeType's fixed numbers are 16.16.
constexpr double kFixedOne = 65'536.0;
constexpr double kLargestLimit = 1000.0;

/// A dot as a line that is one unit of FreeType's long: of no length it would draw nothing.
CubicPath short_line(const CubicPath& point, const Canvas& canvas) {
  const auto p = point.control_points().front();
  const double length = 1.0 / (kUnits * canvas.scale());
  Points points;
  for (int i = 0; i < 4; ++i) points.push_back(Point{p[0] + length * i / 3.0 - 0.5 * length, p[1]});
  return CubicPath(std::move(points), false);
}

// Of lines that are stroked together: their borders have several times as many.
constexpr std::size_t kStrokedPoints = 4096;

}  // namespace

struct Rasterizer::Impl {
  Canvas canvas;
  FillRule fill_rule;
  double line_width;
  FT_Library library = nullptr;
  FT_Stroker stroker = nullptr;

  Impl(const Canvas& c, FillRule rule, double width) : canvas(c), fill_rule(rule), line_width(width) {
    check(FT_Init_FreeType(&library), "start");
    if (FT_Stroker_New(library, &stroker) != 0) {
      FT_Done_FreeType(library);
      throw InvalidArgument("picture: FreeType cannot start a stroker");
    }
  }
  ~Impl() {
    FT_Stroker_Done(stroker);
    FT_Done_FreeType(library);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[nodiscard]] Raster render(FT_Outline& outline) const {
    Raster raster{canvas.width, canvas.height, {}};
    raster.coverage.resize(static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height));
    FT_Bitmap bitmap{};
    bitmap.width = static_cast<unsigned>(canvas.width);
    bitmap.rows = static_cast<unsigned>(canvas.height);
    bitmap.pitch = canvas.width;
    bitmap.buffer = raster.coverage.data();
    bitmap.num_grays = 256;
    bitmap.pixel_mode = FT_PIXEL_MODE_GRAY;
    check(FT_Outline_Get_Bitmap(library, &outline, &bitmap), "draw the outline");
    return raster;
  }

  void take(const Pen& pen) const {
    const double half = std::min(0.5 * pen.width * canvas.scale(), kFarthest);
    const auto radius = static_cast<FT_Fixed>(std::lround(half * kUnits));
    const FT_Stroker_LineCap cap = pen.cap == LineCap::round    ? FT_STROKER_LINECAP_ROUND
                                   : pen.cap == LineCap::square ? FT_STROKER_LINECAP_SQUARE
                                                                : FT_STROKER_LINECAP_BUTT;
    // As SVG has it, a join beyond the limit is a bevel.
    const FT_Stroker_LineJoin join = pen.join == LineJoin::round   ? FT_STROKER_LINEJOIN_ROUND
                                     : pen.join == LineJoin::bevel ? FT_STROKER_LINEJOIN_BEVEL
                                                                   : FT_STROKER_LINEJOIN_MITER_FIXED;
    FT_Stroker_Set(stroker, std::max<FT_Fixed>(radius, 1), cap, join,
                   static_cast<FT_Fixed>(std::lround(std::min(pen.miter_limit, kLargestLimit) * kFixedOne)));
  }

  /// Lines as one stroked path: where they overlap, they cover as much as one.
  [[nodiscard]] Raster stroke(std::span<const CubicPath* const> paths, bool closed) const {
    OutlineData data = outline_of(paths, canvas);
    FT_Outline line = data.outline(FT_OUTLINE_NONE);
    check(FT_Stroker_ParseOutline(stroker, &line, closed ? 0 : 1), "stroke the outline");
    FT_UInt points = 0;
    FT_UInt contours = 0;
    check(FT_Stroker_GetCounts(stroker, &points, &contours), "stroke the outline");
    FT_Outline border{};
    check(FT_Outline_New(library, points, static_cast<FT_Int>(contours), &border), "hold the stroke");
    border.n_points = 0;
    border.n_contours = 0;
    FT_Stroker_Export(stroker, &border);
    try {
      Raster raster = render(border);
      FT_Outline_Done(library, &border);
      return raster;
    } catch (...) {
      FT_Outline_Done(library, &border);
      throw;
    }
  }
};

Rasterizer::Rasterizer(const Canvas& canvas, FillRule fill_rule, double line_width)
    : impl_(std::make_unique<Impl>(canvas, fill_rule, line_width)) {}
Rasterizer::Rasterizer(Rasterizer&&) noexcept = default;
Rasterizer& Rasterizer::operator=(Rasterizer&&) noexcept = default;
Rasterizer::~Rasterizer() = default;

void lay_over(Raster& under, const Raster& over) {
  for (std::size_t i = 0; i < over.coverage.size(); ++i) {
    const int below = under.coverage[i];
    const int above = over.coverage[i];
    under.coverage[i] = static_cast<std::uint8_t>(below + above - (below * above + 127) / 255);
  }
}

Raster Rasterizer::draw(std::span<const CubicPath> paths) const {
  std::vector<CubicPath> closed;
  std::vector<CubicPath> open;
  for (const CubicPath& path : paths) (path.is_closed() ? closed : open).push_back(path);
  Raster raster = fill(closed);
  // Butt caps: a line that has shrunk to a point draws nothing.
  if (!open.empty()) lay_over(raster, stroke(open, {impl_->line_width, LineCap::butt, LineJoin::round}));
  return raster;
}

Raster Rasterizer::fill(std::span<const CubicPath> paths) const {
  std::vector<const CubicPath*> all;
  for (const CubicPath& path : paths) all.push_back(&path);
  OutlineData data = outline_of(all, impl_->canvas);
  FT_Outline filled =
      data.outline(impl_->fill_rule == FillRule::evenodd ? FT_OUTLINE_EVEN_ODD_FILL : FT_OUTLINE_NONE);
  return impl_->render(filled);
}

Raster Rasterizer::stroke(std::span<const CubicPath> paths, const Pen& pen) const {
  const Canvas& canvas = impl_->canvas;
  Raster raster{canvas.width, canvas.height, {}};
  raster.coverage.resize(static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height));
  if (pen.width <= 0.0) return raster;
  impl_->take(pen);
  for (const bool closed : {false, true}) {
    std::vector<CubicPath> dots;
    dots.reserve(paths.size());  // they are pointed to
    std::vector<const CubicPath*> lines;
    std::size_t points = 0;
    const auto draw_lines = [&] {
      if (!lines.empty()) lay_over(raster, impl_->stroke(lines, closed));
      lines.clear();
      points = 0;
    };
    for (const CubicPath& path : paths) {
      if (path.is_closed() != closed) continue;
      const CubicPath* line = &path;
      if (is_point(path, canvas)) {
        if (closed || pen.cap == LineCap::butt) continue;
        line = &dots.emplace_back(short_line(path, canvas));
      }
      if (points + line->control_points().size() > kStrokedPoints) draw_lines();
      lines.push_back(line);
      points += line->control_points().size();
    }
    draw_lines();
  }
  return raster;
}

}  // namespace v0
}  // namespace tandem
