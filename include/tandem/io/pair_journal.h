#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/rank/all_pairs.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// The journal of a run over all pairs: the costs of every tile that is done, in the order in which they
/// were. Words are 64 bits, the lowest byte first:
///
///   head:     8 bytes 89 54 44 4A 0D 0A 1A 0A; version (1); all_pairs_digest(); number of shapes;
///             checksum of these three
///   record:   index of the tile; its costs; checksum of these
///
/// A checksum is FNV-1a over the words before it. Each record is handed to the system in one piece as soon as
/// the tile is done, so that a process that is killed at any moment loses nothing but the tiles it was at. (A
/// machine that loses its power may lose more; what is damaged then is noticed and computed again.)
struct PairJournalScan {
  enum class Kind {
    none,     ///< nothing, or not yet a whole head
    other,    ///< a journal, but of other shapes, options or another version
    foreign,  ///< no journal
    ours,
  };
  Kind kind = Kind::none;
  std::vector<std::uint64_t> offsets;  ///< of each tile's costs; 0: not there
  std::size_t done = 0;                ///< tiles that are there
  std::size_t end = 0;                 ///< where the first record begins that is damaged or cut off
};

/// What of `content` belongs to this run. Never throws because of what it reads.
[[nodiscard]] TANDEM_IO_EXPORT PairJournalScan scan_pair_journal(std::string_view content,
                                                                 std::uint64_t digest,
                                                                 const PairTiles& tiles);

/// A journal on disk, for one process at a time.
class TANDEM_IO_EXPORT PairJournal {
 public:
  /// Takes up the journal, or begins one where there is none, or one of other shapes or options. What follows
  /// the last whole record is cut off.
  /// @throws IoError it cannot be read or written, is no journal, or another process writes to it
  PairJournal(const std::string& path, std::uint64_t digest, std::size_t shapes);
  PairJournal(PairJournal&&) noexcept;
  PairJournal& operator=(PairJournal&&) noexcept;
  ~PairJournal();

  [[nodiscard]] const PairTiles& tiles() const noexcept;
  /// Number of tiles that are there. May be asked while another thread adds one.
  [[nodiscard]] std::size_t done() const noexcept;
  [[nodiscard]] bool has(std::size_t tile) const;
  /// A journal of other shapes or options was there and is gone.
  [[nodiscard]] bool replaced_another() const noexcept;
  /// Appends a tile; one that is there already is passed over.
  /// @throws IoError; InvalidArgument the number of costs is not the tile's
  void add(std::size_t tile, std::span<const double> costs);
  /// @throws IoError; InvalidArgument the tile is not there
  [[nodiscard]] std::vector<double> costs(std::size_t tile) const;
  /// Takes the file away; nothing else may be asked afterwards. @throws IoError
  void remove();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace v0
}  // namespace tandem
