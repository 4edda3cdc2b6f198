#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "tandem/rank/all_pairs.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

struct TeamMessage {
  int from = 0;
  std::vector<std::uint64_t> words;
};

/// Processes that work on one task, on one machine or several of a kind: who this one is among them, and how
/// it talks to the others. The library does not care what carries the messages.
struct Team {
  int rank = 0;  ///< 0 leads
  int size = 1;
  /// Messages between two processes arrive in their order. Calls come from one thread at a time.
  std::function<void(int to, std::span<const std::uint64_t> words)> send;
  /// A message that has arrived; nothing: none has. Does not wait.
  std::function<std::optional<TeamMessage>()> receive;
};

/// all_pairs(), shared out: rank 0 calls this and the others follow_all_pairs(), with the same shapes and
/// options (but threads and progress). Tiles are handed out as they are asked for, this process takes part
/// with its own threads, and source and sink are called here alone, one call at a time. The costs are those
/// of all_pairs(), bit by bit. Returns when every other process has been sent home.
/// @returns false when progress said stop
/// @throws InvalidArgument as all_pairs(), or another process holds other shapes or options
TANDEM_EXPORT bool lead_all_pairs(const Team& team, std::span<const ShapeDescriptor> shapes,
                                  const TileSource& source, const TileSink& sink,
                                  const AllPairsOptions& options = {});

/// Works on what rank 0 hands out until there is no more.
/// @returns false when progress said stop: rank 0 still waits for this process then, which must end
/// @throws InvalidArgument as all_pairs()
TANDEM_EXPORT bool follow_all_pairs(const Team& team, std::span<const ShapeDescriptor> shapes,
                                    const AllPairsOptions& options = {});

}  // namespace v0
}  // namespace tandem
