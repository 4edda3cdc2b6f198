#pragma once

#include <string>
#include <variant>

#include "tandem/io/load.h"
#include "tandem/shape/shape.h"
#include "tandem/surface/surface.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// A surface by its name on the command line: FILE.json, or "-" for standard input.
/// @throws ParseError it is no surface; IoError; InvalidArgument the name of a format that holds none
[[nodiscard]] TANDEM_IO_EXPORT Surface load_surface(const std::string& name);

/// What a name stands for: a surface, if it is JSON that says so, or else a shape.
/// @throws ParseError, IoError, InvalidArgument as load_shape()
[[nodiscard]] TANDEM_IO_EXPORT std::variant<Shape, Surface> load_shape_or_surface(
    const std::string& name, const LoadOptions& options = {});

}  // namespace v0
}  // namespace tandem
