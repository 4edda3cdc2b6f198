#pragma once

#include <optional>
#include <string>

#include "tandem/surface/certificate.h"
#include "tandem/surface/hermite_surface.h"
#include "tandem/surface/ruled.h"

namespace cli {

/// docs/interface.md, "The report of rule": the match report with what concerns the surface behind it.
[[nodiscard]] std::string format_rule_report(const tandem::RuledSurface& ruled,
                                             const std::optional<tandem::Certificate>& certificate);

/// docs/interface.md, "The report of blend".
[[nodiscard]] std::string format_blend_report(const tandem::HermiteSurface& blend);

}  // namespace cli
