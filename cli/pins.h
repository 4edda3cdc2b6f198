#pragma once

#include <string>
#include <vector>

#include "tandem/match/correspondence.h"
#include "tandem/morph/morph.h"
#include "tandem/shape/shape.h"

namespace cli {

/// The pins `x1,y1=x2,y2` of --pin as parameters, for every pair of contours (in order): those of the points
/// of the outlines that are nearest, or of `t1=t2` these themselves, on the first pair. A pin belongs to the
/// pair whose outlines are nearest to its two points.
/// @throws UsageError a pin that is no such pair of points
/// @throws tandem::InvalidArgument a shape that is not planar, or without contours
[[nodiscard]] std::vector<std::vector<tandem::ParameterPair>> locate_pins(
    const std::vector<std::string>& pins, const tandem::Shape& a, const tandem::Shape& b);

/// Whether the pins are pairs of times, `t1=t2`, and not of points.
[[nodiscard]] bool are_time_pins(const std::vector<std::string>& pins);

/// The times `t1=t2`: parameters of curves over time. @throws UsageError a pin that is no such pair
[[nodiscard]] std::vector<tandem::ParameterPair> parse_time_pins(const std::vector<std::string>& pins);

/// The same for a morph, which looks for the points itself. @throws UsageError as above
[[nodiscard]] std::vector<tandem::MorphPin> parse_pins(const std::vector<std::string>& pins);

}  // namespace cli
