#include "morph/in_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tandem/curve/bounding_box.h"
#include "tandem/curve/compatible.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using Curves = std::vector<std::optional<Curve>>;

bool has_extent(const Curve* curve) {
  return curve != nullptr && curve->extent() > 0.0;
}

// The curves so far, moved to the domain that the last match cut them open at.
void follow_cut(Curves& curves, Interval domain) {
  for (std::optional<Curve>& curve : curves) {
    if (curve && !(curve->domain() == domain)) curve = move_seam(*curve, domain.lo);
  }
}

bool all_closed(const Curves& curves) {
  return std::all_of(curves.begin(), curves.end(), [](const auto& c) { return !c || c->is_closed(); });
}

Match match_keys(const Curve& a, const Curve& b, std::size_t key, std::size_t contour,
                 const MatchOptions& options) {
  try {
    return match(a, b, options);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(
        fmt::format("contour {} of keys {} and {}: {}", contour, key, key + 1, error.what()));
  }
}

// Index of the nearest key that has the contour, the earlier one on a tie.
template <class Has>
std::size_t nearest(std::size_t key, std::size_t count, Has has) {
  for (std::size_t distance = 0; distance < count; ++distance) {
    if (distance <= key && has(key - distance)) return key - distance;
    if (key + distance < count && has(key + distance)) return key + distance;
  }
  return key;
}

Curve collapsed(const Curve& like, std::span<const double> center) {
  Points points = like.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) std::copy(center.begin(), center.end(), points[i].begin());
  return Curve(like.degree(), like.knots(), std::move(points), like.weights());
}

// Fills the gaps of `compatible`, whose curves are those of the keys that have the contour.
std::vector<Curve> fill_gaps(const std::vector<const Curve*>& sources, const Curves& in_step,
                             const std::vector<Curve>& compatible) {
  std::vector<Curve> curves;
  std::size_t next = 0;
  for (std::size_t key = 0; key < sources.size(); ++key) {
    if (in_step[key]) {
      curves.push_back(compatible[next++]);
      continue;
    }
    // A point stays where it is; what is missing stands in for the nearest key.
    const std::size_t from =
        nearest(key, sources.size(), [&](std::size_t k) { return sources[k] != nullptr; });
    curves.push_back(collapsed(compatible.front(), bounding_box(*sources[from]).center()));
  }
  return curves;
}

}  // namespace

InStep put_in_step(const std::vector<const Curve*>& sources, std::size_t contour, const MatchOptions& options,
                   const std::function<Progress(std::size_t key)>& progress_of) {
  InStep result;
  const std::size_t count = sources.size();
  result.matches.resize(count - 1);
  Curves in_step(count);
  std::optional<std::size_t> last;
  for (std::size_t key = 0; key < count; ++key) {
    if (!has_extent(sources[key])) continue;
    const Curve& curve = *sources[key];
    if (!last) {
      in_step[key] = curve;
    } else if (*last + 1 == key) {
      MatchOptions own = options;
      own.progress = progress_of(*last);
      // A closed curve may be cut open for an open one only if the keys before it can be cut there too.
      if (own.closed == ClosedMode::automatic && !curve.is_closed() && !all_closed(in_step)) {
        own.closed = ClosedMode::no;
      }
      Match found = match_keys(*in_step[*last], curve, *last, contour, own);
      if (found.report.cancelled) {
        result.cancelled = true;
        return result;
      }
      follow_cut(in_step, found.curve.domain());
      in_step[key] = found.curve;
      result.matches[*last] = std::move(found);
    } else {
      // It shrank to a point in between: nothing to be in step with.
      in_step[key] = with_domain(clamp(curve), in_step[*last]->domain());
    }
    last = key;
  }
  if (!last) {  // points throughout
    const std::size_t some = nearest(0, count, [&](std::size_t k) { return sources[k] != nullptr; });
    result.curves = fill_gaps(sources, in_step, {*sources[some]});
    return result;
  }
  std::vector<Curve> present;
  for (const std::optional<Curve>& curve : in_step) {
    if (curve) present.push_back(*curve);
  }
  result.curves = fill_gaps(sources, in_step, with_common_denominator(present));
  return result;
}

}  // namespace v0
}  // namespace tandem
