#include "morph_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "interrupt.h"
#include "progress_bar.h"
#include "tandem/match/rotation.h"

namespace cli {
namespace {

using tandem::Morph;
using tandem::Shape;

ShapeReport report_of(const Morph& morph, std::size_t key, const Shape& a, const Shape& b) {
  return make_report(a.contours.size(), b.contours.size(), [&](std::size_t i) -> const tandem::Match* {
    const std::optional<tandem::Match>& match = morph.match(key, i);
    return match ? &*match : nullptr;
  });
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

}  // namespace

MorphRun run_morph(const Command& command, std::span<const Shape> keys, tandem::MorphOptions options,
                   const Messages& messages, bool note_turn) {
  options.match.progress = show_progress(messages.quiet());
  MorphRun result;
  {
    const InterruptibleScope interruptible;
    result.curves.emplace(keys, options);
  }
  throw_if_interrupted();
  erase_progress_bar();

  for (std::size_t key = 0; key + 1 < keys.size(); ++key) {
    result.reports.push_back(report_of(*result.curves, key, keys[key], keys[key + 1]));
  }
  const bool valid = std::all_of(result.reports.begin(), result.reports.end(),
                                 [](const ShapeReport& r) { return r.valid(); });
  if (command.match.strict && !valid) {
    messages.error("no valid match exists for these samples (--strict): nothing was written");
    result.status = kNoValidMatch;
    return result;
  }
  for (const ShapeReport& report : result.reports) {
    warn(messages, report);
    if (note_turn) say_turn(messages, report);
  }
  if (keys.front().dim() == 2) result.paths.emplace(*result.curves);
  return result;
}

std::string format_reports(const std::vector<ShapeReport>& reports) {
  if (reports.size() == 1) return "\"report\": " + format_report(reports.front());
  std::string text = "\"reports\": [";
  for (std::size_t i = 0; i < reports.size(); ++i) text += (i == 0 ? "" : ", ") + format_report(reports[i]);
  return text + "]";
}

}  // namespace cli
