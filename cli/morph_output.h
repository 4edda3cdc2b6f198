#pragma once

#include <string>
#include <vector>

#include "commands.h"
#include "messages.h"
#include "output.h"
#include "tandem/io/animation.h"
#include "tandem/io/css.h"
#include "tandem/io/look.h"
#include "tandem/morph/path_morph.h"

namespace cli {

/// What `morph` shall write, checked before anything is read.
struct MorphOutput {
  Format format = Format::json;
  std::vector<double> positions;  ///< --at, or --frames spread over [0, 1]
  bool at_given = false;          ///< --at was there
  std::string title;              ///< from the names of the inputs
  bool still = false;             ///< one in-between as a still .svg
  bool png_frames = false;        ///< a directory of .png, not of .svg
  int frames = 0;                 ///< --frames; 0: not given
  int size = 0;                   ///< pixels of the longer side
  std::vector<double> key_times;  ///< tandem::MorphOptions::times
  tandem::AnimationOptions animation;
  tandem::CssOptions css;
};

/// Options that decide what is written, and how.
void add_morph_output_flags(Command& command);

/// @throws UsageError options that do not go together, or values that cannot be
[[nodiscard]] MorphOutput plan_morph_output(const Command& command);

/// Says which of the options that were given have no say in this output: a still picture has no duration.
void note_idle_flags(const Command& command, const MorphOutput& plan, const Messages& messages);

/// Planar in-betweens. reports: members of the JSON object, `"report": {...}`.
void write_morph(const Command& command, const MorphOutput& plan, const tandem::PathMorph& paths,
                 const tandem::Look& look, const std::string& reports);

}  // namespace cli
