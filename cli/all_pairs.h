#pragma once

#include "commands.h"

namespace cli {

/// `tandem rank --all-pairs`: the matrix of costs of a corpus, which can be interrupted and gone on with,
/// alone or as one of the processes of mpirun.
[[nodiscard]] Status run_all_pairs(const Command& command);

}  // namespace cli
