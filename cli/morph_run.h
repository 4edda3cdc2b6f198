#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "commands.h"
#include "messages.h"
#include "report.h"
#include "tandem/io/style.h"
#include "tandem/morph/morph.h"
#include "tandem/morph/motion_morph.h"
#include "tandem/morph/path_morph.h"
#include "tandem/shape/shape.h"

namespace cli {

/// Shapes that were matched, each with the next, and what came of it. The reports point into the morph.
struct MorphRun {
  Status status = kDone;                   ///< kNoValidMatch: --strict, nothing shall be written
  std::optional<tandem::PathMorph> paths;  ///< of planar shapes
  std::optional<tandem::Morph> curves;     ///< of others
  std::optional<tandem::MotionMorph> motions;
  std::vector<ShapeReport> reports;  ///< one per pair of neighbours
};

/// Matches with a progress bar, and says what there is to say about the result. note_turn: a turn is seen on
/// the way. styles: of the keys, as far as their files say so (Look). @throws Interrupted
[[nodiscard]] MorphRun run_morph(const Command& command, std::span<const tandem::Shape> keys,
                                 tandem::MorphOptions options, const Messages& messages, bool note_turn,
                                 std::span<const tandem::Style> styles = {});

/// --smooth does nothing for two keys: says so.
void say_smooth(const Messages& messages, bool smooth, std::size_t keys);

/// The same of motions, curves over time. @throws Interrupted
[[nodiscard]] MorphRun run_motions(const Command& command, std::span<const tandem::Curve> motions,
                                   tandem::MotionOptions options, const Messages& messages);

/// `"report": {...}` of two keys, `"reports": [...]` of more, and of planar shapes `"blends"` and
/// `"quality"`: members of a JSON object.
[[nodiscard]] std::string format_reports(const MorphRun& made);

}  // namespace cli
