#pragma once

#include <vector>

#include "commands.h"
#include "messages.h"
#include "tandem/io/look.h"
#include "tandem/morph/path_morph.h"

namespace cli {

/// Says what of the inputs' styles and view boxes does not come out as one would expect.
void say_look(const Messages& messages, const Command& command, const std::vector<tandem::Drawing>& drawings,
              const tandem::Look& look, const tandem::PathMorph& morph);

}  // namespace cli
