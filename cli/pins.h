#pragma once

#include <string>
#include <vector>

#include "tandem/match/correspondence.h"
#include "tandem/morph/morph.h"
#include "tandem/shape/shape.h"

namespace cli {

/// The pins `x1,y1=x2,y2` of --pin as parameters, for every pair of contours (in order): those of the points
/// of the outlines that are nearest. A pin belongs to the pair whose outlines are nearest to its two points.
/// @throws UsageError a pin that is no such pair of points
/// @throws tandem::InvalidArgument a shape that is not planar, or without contours
[[nodiscard]] std::vector<std::vector<tandem::ParameterPair>> locate_pins(
    const std::vector<std::string>& pins, const tandem::Shape& a, const tandem::Shape& b);

/// The same for a morph, which looks for the points itself. @throws UsageError as above
[[nodiscard]] std::vector<tandem::MorphPin> parse_pins(const std::vector<std::string>& pins);

}  // namespace cli
