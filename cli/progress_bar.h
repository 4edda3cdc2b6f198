#pragma once

#include <cstddef>

#include "tandem/progress.h"

namespace cli {

/// A progress callback that stops at Ctrl-C and, when standard error is a terminal, draws a bar there once
/// the work has taken half a second. part of parts: the work is one of several equal steps, and the bar runs
/// over all of them.
[[nodiscard]] tandem::Progress show_progress(bool quiet, std::size_t part = 0, std::size_t parts = 1);

/// Takes the bar off the terminal, if there is one. Safe in a signal handler.
void erase_progress_bar();

}  // namespace cli
