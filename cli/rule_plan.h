#pragma once

#include "commands.h"
#include "surface_output.h"
#include "tandem/surface/law.h"

namespace cli {

/// What rule and blend have in common, checked before anything is read.
struct RailPlan {
  SurfaceOutput output;
  tandem::MatchOptions match;
  tandem::LawOptions law;
  double crease = 0.0;
};

/// @throws UsageError
[[nodiscard]] RailPlan make_rail_plan(const Command& command);

/// Input `index`, which must be one curve. @throws tandem::InvalidArgument
[[nodiscard]] tandem::Curve single_curve(const Command& command, const std::vector<tandem::Shape>& shapes,
                                         std::size_t index);

/// What they share on the command line.
void add_rail_flags(Command& command);

}  // namespace cli
