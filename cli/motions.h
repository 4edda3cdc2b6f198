#pragma once

#include <optional>
#include <vector>

#include "commands.h"
#include "messages.h"
#include "morph_output.h"
#include "tandem/io/csv.h"
#include "tandem/morph/morph.h"

namespace cli {

/// The tables of the inputs when these are motions: CSV files, all of them, of other than two columns of
/// values (which are drawings), or of any when .csv is what shall be written.
/// @throws UsageError .csv wanted of other inputs; tandem::ParseError
[[nodiscard]] std::optional<std::vector<tandem::CsvTable>> load_motions(const Command& command, Format format,
                                                                        const Messages& messages);

/// Blends them and writes what `output` says. options: the planar morph's.
Status morph_motions(const Command& command, const std::vector<tandem::CsvTable>& tables,
                     const MorphOutput& output, const tandem::MorphOptions& options,
                     const Messages& messages);

}  // namespace cli
