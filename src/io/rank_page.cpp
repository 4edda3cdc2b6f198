#include "tandem/io/rank_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "io/html.h"
#include "io/number.h"
#include "io/page.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr const char* kStyle = R"page(:root { --width: 72rem; --shape: #c9ced8; }
@media (prefers-color-scheme: dark) { :root { --shape: #3c4552; } }
header { display: flex; gap: 1.2rem; align-items: center; }
header svg { width: 8rem; flex: none; }
p { margin: 0; color: var(--soft); }
ol { list-style: none; margin: 0; padding: 0; display: grid; gap: .7rem;
  grid-template-columns: repeat(auto-fill, minmax(9.5rem, 1fr)); }
li { background: var(--card); border: 1px solid var(--line); border-radius: 12px; padding: .6rem .7rem; min-width: 0; }
svg { display: block; width: 100%; aspect-ratio: 1; overflow: visible; }
li svg { padding: .3rem; }
.shape { fill: var(--shape); }
.open { fill: none; stroke: var(--soft); stroke-width: .03; }
.query { fill: none; stroke: var(--to); stroke-width: .014; stroke-linejoin: round; }
header .shape { fill: var(--ink); }
header .open { stroke: var(--ink); }
.cost { display: flex; justify-content: space-between; font-variant-numeric: tabular-nums; }
.cost b { font-weight: 600; }
.cost span, .how { color: var(--soft); }
.name, .how { font-size: .8rem; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
)page";

struct Vertex {
  double x = 0.0;
  double y = 0.0;
};

/// The chords one after the other; a loop is closed by spreading its gap, and starts at its end.
std::vector<Vertex> vertices(const ShapeDescriptor& shape, const Points& tangents) {
  std::vector<Vertex> path(1);
  for (std::size_t k = 0; k < shape.size(); ++k) {
    const Vertex last = path.back();
    const double length = shape.lengths()[k];
    const double y = shape.dim() > 1 ? tangents[k][1] : 0.0;
    path.push_back({last.x + length * tangents[k][0], last.y + length * y});
  }
  if (!shape.is_closed()) return path;
  const Vertex gap = path.back();
  for (std::size_t k = 0; k < path.size(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(path.size() - 1);
    path[k].x -= share * gap.x;
    path[k].y -= share * gap.y;
  }
  path.pop_back();
  return path;
}

struct Frame {
  Vertex middle;
  double size = 1.0;
};

Frame frame_of(const std::vector<Vertex>& path) {
  Vertex lo = path.front();
  Vertex hi = path.front();
  for (const Vertex& v : path) {
    lo = {std::min(lo.x, v.x), std::min(lo.y, v.y)};
    hi = {std::max(hi.x, v.x), std::max(hi.y, v.y)};
  }
  return {{0.5 * (lo.x + hi.x), 0.5 * (lo.y + hi.y)}, std::max({hi.x - lo.x, hi.y - lo.y, 1e-9})};
}

/// Into the unit square, its own middle in the square's.
std::string path_data(const std::vector<Vertex>& path, const Frame& frame, Vertex middle, bool closed) {
  std::string d;
  for (const Vertex& v : path) {
    d += d.empty() ? 'M' : 'L';
    append_number(d, 0.5 + (v.x - middle.x) / frame.size, 4);
    d += ' ';
    append_number(d, 0.5 + (v.y - middle.y) / frame.size, 4);
  }
  return closed ? d + 'Z' : d;
}

/// The query's tangents as they were laid on the candidate's.
Points laid_over(const ShapeDescriptor& query, const Comparison& comparison) {
  Points tangents = query.tangents();
  if (comparison.mirrored) {
    for (std::size_t k = 0; k < tangents.size(); ++k) tangents[k][0] = -tangents[k][0];
  }
  return comparison.rotation.dim() == query.dim() ? comparison.rotation(std::move(tangents)) : tangents;
}

std::string picture(const ShapeDescriptor& shape, const ShapeDescriptor* query,
                    const Comparison* comparison) {
  const std::vector<Vertex> path = vertices(shape, shape.tangents());
  Frame frame = frame_of(path);
  const Vertex middle = frame.middle;
  std::string over;
  std::vector<Vertex> second;
  if (query != nullptr) {
    second = vertices(*query, laid_over(*query, *comparison));
    const Frame other = frame_of(second);
    frame.size = std::max(frame.size, other.size);
    over = fmt::format(R"(<path class="query" d="{}"/>)",
                       path_data(second, frame, other.middle, query->is_closed()));
  }
  return fmt::format(R"(<svg viewBox="0 0 1 1" aria-hidden="true"><path class="{}" d="{}"/>{}</svg>)",
                     shape.is_closed() ? "shape" : "open", path_data(path, frame, middle, shape.is_closed()),
                     over);
}

std::string how(const Comparison& comparison) {
  std::string text;
  const double degrees = comparison.rotation.degrees();
  if (std::fabs(degrees) >= 0.05) text = fmt::format("turned {:.1f}°", degrees);
  if (comparison.mirrored) text += text.empty() ? "mirrored" : ", mirrored";
  return text.empty() ? "as it lies" : text;
}

}  // namespace

std::string format_rank_page(const ShapeDescriptor& query, const Ranking& ranking, const std::string& title) {
  Page page;
  page.title = title;
  page.style = kStyle;
  page.lead = fmt::format(
      "<header>{}<div><h1>{}</h1><p>The best {} of {} candidates. The query lies over each "
      "shape as an outline.</p></div></header>",
      picture(query, nullptr, nullptr), escape_html(title), ranking.best.size(), ranking.candidates);
  page.body = "<ol>\n";
  for (std::size_t k = 0; k < ranking.best.size(); ++k) {
    const RankedShape& each = ranking.best[k];
    const std::string name = escape_html(each.name);
    // The end of a path tells files apart; the whole of it is in the tooltip.
    const std::string last = escape_html(each.name.substr(each.name.find_last_of('/') + 1));
    page.body += fmt::format(R"(<li>{}<div class="cost"><b>{:.4f}</b><span>{}</span></div>)"
                             R"(<div class="how">{}</div><div class="name" title="{}">{}</div></li>)"
                             "\n",
                             each.shape ? picture(*each.shape, &query, &each.comparison) : "",
                             each.comparison.cost, k + 1, how(each.comparison), name, last);
  }
  page.body += "</ol>\n";
  return format_page(page);
}

}  // namespace v0
}  // namespace tandem
