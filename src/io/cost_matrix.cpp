#include "tandem/io/cost_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "io/little_endian.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace {

/// Some whole rows of the matrix.
struct Band {
  std::size_t first = 0;
  std::size_t size = 0;  ///< of a row
  std::vector<double> costs;

  [[nodiscard]] std::size_t rows() const { return costs.size() / size; }
  [[nodiscard]] std::span<const double> row(std::size_t i) const {
    return std::span(costs).subspan(i * size, size);
  }
};

/// The rows of the k-th row of tiles: its own tiles and, mirrored, those above.
Band read_band(const PairJournal& journal, std::size_t block) {
  const PairTiles& tiles = journal.tiles();
  const PairTile own = tiles.tile(tiles.index(block, block));
  Band band{own.row, tiles.shapes(), {}};
  band.costs.assign((own.row_end - own.row) * band.size, 0.0);
  for (std::size_t other = 0; other < tiles.blocks(); ++other) {
    const std::size_t index = tiles.index(std::min(block, other), std::max(block, other));
    const PairTile tile = tiles.tile(index);
    const std::vector<double> costs = journal.costs(index);
    auto cost = costs.begin();
    for (std::size_t i = tile.row; i < tile.row_end; ++i) {
      for (std::size_t j = std::max(tile.column, i + 1); j < tile.column_end; ++j, ++cost) {
        if (other >= block) band.costs[(i - own.row) * band.size + j] = *cost;
        if (other <= block) band.costs[(j - own.row) * band.size + i] = *cost;
      }
    }
  }
  return band;
}

/// `head`, then format(band) for every row of tiles.
template <class Format>
FilePieces pieces(const PairJournal& journal, std::string head, Format format) {
  const std::size_t missing = journal.tiles().size() - journal.done();
  if (missing > 0) throw InvalidArgument(fmt::format("{} tiles are not in the journal yet", missing));
  return [&journal, head = std::move(head), format,
          next = std::size_t{0}]() mutable -> std::optional<std::string> {
    const std::size_t piece = next++;
    if (piece == 0) return head;
    if (piece > journal.tiles().blocks()) return std::nullopt;
    return format(read_band(journal, piece - 1));
  };
}

std::string format_npy_head(std::size_t rows, std::size_t columns) {
  // The magic string, version 1.0, and the length of what follows, which ends at a multiple of 64 bytes.
  std::string text =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", rows, columns);
  constexpr std::size_t kBefore = 10;
  constexpr std::size_t kAlignment = 64;
  text.append(kAlignment - 1 - (kBefore + text.size()) % kAlignment, ' ');
  text += '\n';
  std::string head("\x93NUMPY\x01\x00", 8);
  head += static_cast<char>(text.size() & 0xFFU);
  head += static_cast<char>(text.size() >> 8U);
  return head + text;
}

std::string quoted(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + '"';
}

void append_escaped(std::string& line, std::string_view text) {
  for (const char c : text) {
    switch (c) {
      case '\t':
        line += "\\t";
        break;
      case '\n':
        line += "\\n";
        break;
      case '\r':
        line += "\\r";
        break;
      case '\\':
        line += "\\\\";
        break;
      default:
        line += c;
    }
  }
}

}  // namespace

FilePieces npy_pieces(const PairJournal& journal) {
  const std::size_t n = journal.tiles().shapes();
  return pieces(journal, format_npy_head(n, n), [](const Band& band) {
    std::string bytes;
    bytes.reserve(band.costs.size() * sizeof(double));
    for (const double cost : band.costs) detail::put_number(bytes, cost);
    return bytes;
  });
}

FilePieces csv_pieces(const PairJournal& journal, std::span<const ShapeDescriptor> shapes) {
  if (shapes.size() != journal.tiles().shapes()) {
    throw InvalidArgument(
        fmt::format("{} shapes were given, {} are in the journal", shapes.size(), journal.tiles().shapes()));
  }
  std::string head;
  for (const ShapeDescriptor& shape : shapes) head += "," + quoted(shape.name());
  return pieces(journal, head + "\n", [shapes](const Band& band) {
    std::string text;
    for (std::size_t i = 0; i < band.rows(); ++i) {
      text += quoted(shapes[band.first + i].name());
      for (const double cost : band.row(i)) {
        text += ',';
        if (!std::isnan(cost)) fmt::format_to(std::back_inserter(text), "{}", cost);
      }
      text += '\n';
    }
    return text;
  });
}

std::string format_names(std::span<const ShapeDescriptor> shapes) {
  std::string text;
  for (const ShapeDescriptor& shape : shapes) {
    append_escaped(text, shape.name());
    text += '\t';
    append_escaped(text, shape.label());
    text += '\n';
  }
  return text;
}

}  // namespace v0
}  // namespace tandem
