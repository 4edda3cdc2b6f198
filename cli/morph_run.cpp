#include "morph_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "interrupt.h"
#include "progress_bar.h"
#include "tandem/match/rotation.h"
#include "tandem/morph/quality.h"

namespace cli {
namespace {

using tandem::Morph;
using tandem::Shape;

// Contours that a note names at most.
constexpr std::size_t kMostNamed = 5;

ShapeReport report_of(const Morph& morph, std::size_t key, const Shape& a, const Shape& b) {
  return make_report(a.contours.size(), b.contours.size(), [&](std::size_t i) -> const tandem::Match* {
    const std::optional<tandem::Match>& match = morph.match(key, i);
    return match ? &*match : nullptr;
  });
}

ShapeReport report_of(const tandem::MorphStep& step) {
  ShapeReport report;
  for (const tandem::ContourStep& contour : step.contours) {
    if (contour.match) {
      report.pairs.push_back({*contour.a, *contour.b, &*contour.match});
    } else if (contour.a) {
      report.unmatched_a.push_back(*contour.a);
    } else if (contour.b) {
      report.unmatched_b.push_back(*contour.b);
    }
  }
  return report;
}

const char* name_of(tandem::BlendKind kind) {
  switch (kind) {
    case tandem::BlendKind::bezier:
      return "bezier";
    case tandem::BlendKind::hermite:
      return "hermite";
    case tandem::BlendKind::similarity:
      return "similarity";
    case tandem::BlendKind::intrinsic:
      return "intrinsic";
    default:
      return "affine";
  }
}

/// `"blends": [...], "quality": {...}`: how each step is blended, and what the in-betweens are worth.
std::string format_quality(const tandem::PathMorph& morph) {
  std::string blends;
  bool detour = false;
  for (const tandem::MorphStep& step : morph.steps()) {
    blends += fmt::format("{}\"{}\"", blends.empty() ? "" : ", ", name_of(step.blend));
    detour = detour || step.detour;
  }
  const tandem::MorphQuality quality = tandem::measure_quality(morph);
  return fmt::format(
      "\"blends\": [{}], \"detour\": {}, \"smooth\": {}, \"pace\": [{}],\n"
      " \"quality\": {{\"in_betweens\": {}, \"crossing\": {}, \"crossing_between\": {}, \"folded\": {}, "
      "\"faulty\": {}, \"faulty_keys\": {}, \"g1_defect\": {}, \"length_deviation\": {}, "
      "\"area_deviation\": {}, \"step_ratio\": {}}}",
      blends, detour, morph.is_smooth(), fmt::join(morph.pace(), ", "), quality.in_betweens, quality.crossing,
      quality.crossing_between, quality.folded, quality.faulty, quality.faulty_keys,
      json_number(quality.g1_defect), json_number(quality.length_deviation),
      json_number(quality.area_deviation), json_number(quality.step_ratio));
}

/// A turn that nobody asked for should not puzzle anybody.
void say_turn(const Messages& messages, const ShapeReport& report) {
  if (report.pairs.empty()) return;
  const tandem::Match& match = *report.pairs.front().match;
  const double degrees = tandem::Rotation(match.curve.dim(), match.report.rotation).degrees();
  if (std::fabs(degrees) < 0.05) return;
  messages.note(
      fmt::format("turned by {:.1f} degrees on the way; --no-rotate blends as the shapes lie", degrees));
}

/// "contour 2 of B", counted from 0 as in reports.
std::string contour_name(std::size_t contour, std::size_t key) {
  return fmt::format("contour {} of {}", contour, key_name(key));
}

/// A fill closes what is open; a morph draws it as a stroke, or, where its file says how it is filled, fills
/// it, but knows nothing of the side that closes it.
void say_open(const Messages& messages, std::span<const Shape> keys, std::span<const tandem::Style> styles) {
  std::string open;
  std::size_t count = 0;
  bool any_closed = false;
  bool any_filled = false;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const bool filled = !styles.empty() && styles[k].fill.paints() && !styles[k].stroke.paints();
    for (std::size_t i = 0; i < keys[k].contours.size(); ++i) {
      const tandem::Curve& contour = keys[k].contours[i];
      any_closed = any_closed || contour.is_closed();
      if (contour.is_closed()) continue;
      any_filled = any_filled || filled;
      if (++count > kMostNamed) continue;
      open += (open.empty() ? "" : ", ") + contour_name(i, k);
    }
  }
  // Of lines that are stroked nothing is amiss.
  if (count == 0 || !(styles.empty() ? any_closed : any_filled)) return;
  if (count > kMostNamed) open += fmt::format(", and {} more", count - kMostNamed);
  const char* const how =
      any_filled ? "open though filled, and matched as lines from end to end" : "open, and drawn as strokes";
  messages.note(fmt::format("{}: {}; --closed yes closes them by straight lines", how, open));
}

/// Which closed contours became open ones.
void say_cut_open(const Messages& messages, const tandem::PathMorph& morph, std::span<const Shape> keys) {
  for (std::size_t k = 0; k < morph.steps().size(); ++k) {
    for (const tandem::ContourStep& step : morph.steps()[k].contours) {
      if (!step.match) continue;
      const bool a = keys[k].contours[*step.a].is_closed();
      const bool b = keys[k + 1].contours[*step.b].is_closed();
      if (a == b) continue;
      messages.note(fmt::format("{} is closed, {} open: the closed one is cut where that is best",
                                a ? contour_name(*step.a, k) : contour_name(*step.b, k + 1),
                                a ? contour_name(*step.b, k + 1) : contour_name(*step.a, k)));
    }
  }
}

/// --strict. False when nothing shall be written.
bool judge_run(const Command& command, MorphRun& result, const Messages& messages) {
  const bool valid = std::all_of(result.reports.begin(), result.reports.end(),
                                 [](const ShapeReport& r) { return r.valid(); });
  if (command.match.strict && !valid) {
    messages.error("no valid match exists for these samples (--strict): nothing was written");
    result.status = kNoValidMatch;
    return false;
  }
  return true;
}

}  // namespace

MorphRun run_morph(const Command& command, std::span<const Shape> keys, tandem::MorphOptions options,
                   const Messages& messages, bool note_turn, std::span<const tandem::Style> styles) {
  options.match.progress = show_progress(messages.quiet());
  MorphRun result;
  {
    const InterruptibleScope interruptible;
    if (keys.front().dim() == 2) {
      result.paths.emplace(keys, options);
    } else {
      result.curves.emplace(keys, options);
    }
  }
  throw_if_interrupted();
  erase_progress_bar();

  for (std::size_t key = 0; key + 1 < keys.size(); ++key) {
    result.reports.push_back(result.paths ? report_of(result.paths->steps()[key])
                                          : report_of(*result.curves, key, keys[key], keys[key + 1]));
  }
  if (!judge_run(command, result, messages)) return result;
  if (result.paths && options.match.closed != tandem::ClosedMode::yes) {
    say_open(messages, keys, styles);
    say_cut_open(messages, *result.paths, keys);
  }
  for (std::size_t key = 0; key < result.reports.size(); ++key) {
    warn(messages, result.reports[key], key);
    if (note_turn) say_turn(messages, result.reports[key]);
  }
  return result;
}

void say_smooth(const Messages& messages, bool smooth, std::size_t keys) {
  if (!smooth || keys > 2) return;
  messages.note(
      "--smooth passes the shapes between the first and the last, and with two there are none: it does "
      "nothing");
}

MorphRun run_motions(const Command& command, std::span<const tandem::Curve> motions,
                     tandem::MotionOptions options, const Messages& messages) {
  options.match.progress = show_progress(messages.quiet());
  MorphRun result;
  {
    const InterruptibleScope interruptible;
    result.motions.emplace(motions, options);
  }
  throw_if_interrupted();
  erase_progress_bar();
  for (std::size_t step = 0; step + 1 < motions.size(); ++step) {
    result.reports.push_back(make_report(1, 1, [&](std::size_t) { return &result.motions->match(step); }));
  }
  // No warnings: motions that go opposite ways for a moment do not fold.
  (void)judge_run(command, result, messages);
  return result;
}

std::string format_reports(const MorphRun& made) {
  std::string text;
  if (made.reports.size() == 1) {
    text = "\"report\": " + format_report(made.reports.front());
  } else {
    for (const ShapeReport& report : made.reports)
      text += (text.empty() ? "\"reports\": [" : ", ") + format_report(report);
    text += "]";
  }
  return made.paths ? text + ",\n " + format_quality(*made.paths) : text;
}

}  // namespace cli
