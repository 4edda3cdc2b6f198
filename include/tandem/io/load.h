#pragma once

#include <string>

#include "tandem/io/look.h"
#include "tandem/shape/shape.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

struct LoadOptions {
  FillRule fill_rule = FillRule::nonzero;  ///< for bare path data
};

/// A shape by its name on the command line (docs/interface.md, "Naming a curve or a shape"): a file, a part
/// of a file (FILE.svg#ID, FONT.ttf#A, FILE.json#2), path data itself, or "-" for standard input.
/// @throws ParseError, IoError, InvalidArgument (a name that is neither a file nor path data)
[[nodiscard]] TANDEM_IO_EXPORT Shape load_shape(const std::string& name, const LoadOptions& options = {});

/// The same with how it is drawn, as far as the file says so (SVG does).
[[nodiscard]] TANDEM_IO_EXPORT Drawing load_drawing(const std::string& name, const LoadOptions& options = {});

}  // namespace v0
}  // namespace tandem
