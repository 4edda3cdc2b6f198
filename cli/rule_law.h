#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "commands.h"
#include "messages.h"
#include "output.h"
#include "tandem/curve/curve.h"
#include "tandem/match/reparametrization.h"
#include "tandem/surface/law.h"

namespace cli {

/// The law that --order and --tolerance ask for, `usual` where they are silent. @throws UsageError --reduce
[[nodiscard]] tandem::LawOptions law_options(const Command& command, tandem::LawOptions usual);

/// Lowers the order of a law until what is composed with it fits: into STEP, IGES and BREP, which end at
/// degree 25, and below a degree that is computed in seconds, and with some digits left. Not when --order was
/// given. degree_with(q): the degree of the surface along u when the law is of degree q.
/// @throws tandem::InvalidArgument no order fits
void fit_order(const Command& command, Format format, const std::function<int(int)>& degree_with,
               tandem::LawOptions& law, const Messages& messages);

/// Warns when a law is further from its match than was asked, both as shares of its domain. whose: "the law".
void warn_of_deviation(const Messages& messages, std::string_view whose, double deviation, double tolerance);

/// The same of the furthest of the sections of a skin.
void warn_of_deviation(const Messages& messages, const std::vector<tandem::Reparametrization>& laws,
                       double tolerance);

/// The degree along u of a surface between curves as they are and curves composed with a law of degree q.
[[nodiscard]] int ruled_degree(const std::vector<const tandem::Curve*>& kept,
                               const std::vector<const tandem::Curve*>& composed, int q);

/// That of a skin or of its sections in step; loft() keeps rational ones from going beyond it.
[[nodiscard]] int skinned_degree(const std::vector<tandem::Curve>& sections, int q);

/// --help of laws for skins, which have defaults of their own.
void describe_skin_laws(CLI::App& app);

}  // namespace cli
