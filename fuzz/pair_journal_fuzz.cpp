#include <algorithm>

#include "check.h"
#include "rank/fnv.h"
#include "tandem/io/pair_journal.h"

namespace {

constexpr std::size_t kShapes = 6;
constexpr std::uint64_t kDigest = 7;

}  // namespace

/// What follows a good head, and any bytes at all.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tandem::PairTiles tiles(kShapes);
  const auto check = [&](std::string_view content) {
    const tandem::PairJournalScan scan = scan_pair_journal(content, kDigest, tiles);
    std::size_t done = 0;
    for (std::size_t k = 0; k < tiles.size(); ++k) {
      if (scan.offsets[k] == 0) continue;
      ++done;
      tandem::fuzz::require(scan.offsets[k] + tiles.tile(k).pairs() * sizeof(double) < scan.end);
    }
    tandem::fuzz::require(done == scan.done && scan.end <= content.size());
    tandem::fuzz::require(done == 0 || scan.kind == tandem::PairJournalScan::Kind::ours);
  };
  const std::string_view text = tandem::fuzz::text(data, size);
  check(text);
  // version 1, digest and number of shapes as above, checksum
  std::string head("\x89TDJ\r\n\x1a\n", 8);
  tandem::detail::Fnv sum;
  const auto put = [&head](std::uint64_t word) {
    for (int k = 0; k < 8; ++k) head += static_cast<char>(word >> (8 * k) & 0xFFU);
  };
  for (const std::uint64_t word : {std::uint64_t{1}, kDigest, std::uint64_t{kShapes}}) {
    put(word);
    sum.add_word(word);
  }
  put(sum.value());
  tandem::fuzz::require(scan_pair_journal(head, kDigest, tiles).kind == tandem::PairJournalScan::Kind::ours);
  check(head + std::string(text));
  return 0;
}
