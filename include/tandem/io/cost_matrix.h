#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "tandem/io/files.h"
#include "tandem/io/pair_journal.h"
#include "tandem/rank/shape_descriptor.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// A finished matrix of costs in the format of NumPy (.npy, version 1.0): float64, the lowest byte first, n x
/// n, row by row. One piece per row of tiles, so that the matrix need not fit into memory; `journal` must
/// outlive the result. @throws InvalidArgument (also when a piece is asked for) a tile is not in the journal
[[nodiscard]] TANDEM_IO_EXPORT FilePieces npy_pieces(const PairJournal& journal);

/// The same as CSV (RFC 4180, but for its line ends: line feeds alone): the first row and the first column
/// hold the names, the corner is empty; the cell of a pair that is not comparable is empty. Numbers read back
/// equal.
/// @throws InvalidArgument there are not as many shapes as the journal has; and as npy_pieces()
[[nodiscard]] TANDEM_IO_EXPORT FilePieces csv_pieces(const PairJournal& journal,
                                                     std::span<const ShapeDescriptor> shapes);

/// A line per shape, name TAB label; a tab, line feed, carriage return or backslash in one of them is written
/// \t, \n, \r, \\.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_names(std::span<const ShapeDescriptor> shapes);

}  // namespace v0
}  // namespace tandem
