#include "tandem/io/pair_journal.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "io/scratch_directory.h"
#include "tandem/error.h"
#include "tandem/io/cost_matrix.h"
#include "tandem/io/files.h"

namespace {

using tandem::FilePieces;
using tandem::PairJournal;
using tandem::PairJournalScan;
using tandem::PairTile;
using tandem::PairTiles;
using tandem::Points;
using tandem::scan_pair_journal;
using tandem::ShapeDescriptor;
using Kind = PairJournalScan::Kind;

class PairJournalFile : public tandem::test::ScratchDirectory {
 protected:
  [[nodiscard]] std::string file() const { return path("m.partial"); }
};
using PairJournalScanning = PairJournalFile;
using CostMatrixFile = PairJournalFile;

constexpr std::uint64_t kDigest = 0x0123456789ABCDEF;

/// What pair (i, j) costs in these tests: all kinds of numbers.
double cost_of(std::size_t i, std::size_t j) {
  if (i == j) return 0.0;
  const double x = static_cast<double>(std::min(i, j));
  const double y = static_cast<double>(std::max(i, j));
  if (static_cast<int>(x + y) % 7 == 3) return std::numeric_limits<double>::quiet_NaN();
  if (static_cast<int>(x + y) % 11 == 5) return std::numeric_limits<double>::infinity();
  return (x + 1.0) / (y + 3.0);
}

std::vector<double> costs_of(const PairTile& tile) {
  std::vector<double> costs;
  for (std::size_t i = tile.row; i < tile.row_end; ++i) {
    for (std::size_t j = std::max(tile.column, i + 1); j < tile.column_end; ++j)
      costs.push_back(cost_of(i, j));
  }
  return costs;
}

bool same_bits(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() != y.size()) return false;
  return x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
}

void fill(PairJournal& journal) {
  for (std::size_t k = journal.tiles().size(); k-- > 0;) journal.add(k, costs_of(journal.tiles().tile(k)));
}

std::string content(const FilePieces& next) {
  std::string all;
  while (const std::optional<std::string> piece = next()) all += *piece;
  return all;
}

ShapeDescriptor shape(std::string name, std::string label = {}) {
  return {false, Points({{1.0, 0.0}}), {1.0}, std::move(name), std::move(label)};
}

TEST_F(PairJournalFile, KeepsWhatWasAdded) {
  for (const std::size_t n : {1U, 2U, 60U, 100U}) {
    {
      PairJournal journal(file(), kDigest, n);
      EXPECT_EQ(journal.done(), 0U);
      fill(journal);
      EXPECT_EQ(journal.done(), journal.tiles().size());
    }
    PairJournal journal(file(), kDigest, n);
    EXPECT_FALSE(journal.replaced_another());
    EXPECT_EQ(journal.done(), journal.tiles().size());
    for (std::size_t k = 0; k < journal.tiles().size(); ++k) {
      EXPECT_TRUE(same_bits(journal.costs(k), costs_of(journal.tiles().tile(k))));
    }
    journal.remove();
    EXPECT_FALSE(std::filesystem::exists(file()));
  }
}

TEST_F(PairJournalFile, CutsOffATornTailAtEveryByte) {
  constexpr std::size_t kShapes = 50;
  {
    PairJournal journal(file(), kDigest, kShapes);
    fill(journal);
  }
  const std::string whole = tandem::read_file(file());
  const PairTiles tiles(kShapes);
  std::size_t last = tiles.size();
  for (std::size_t size = whole.size(); size-- > whole.size() - 200;) {
    const PairJournalScan scan = scan_pair_journal(whole.substr(0, size), kDigest, tiles);
    EXPECT_EQ(scan.kind, Kind::ours);
    EXPECT_LE(scan.end, size);
    EXPECT_LT(scan.done, tiles.size());
    EXPECT_LE(scan.done, last);
    last = scan.done;
  }
  EXPECT_LT(last, tiles.size() - 2);
  for (const std::string& tail : {std::string("x"), std::string(64, '\0'), std::string(500, '\xFF')}) {
    tandem::write_file(file(), whole.substr(0, whole.size() - 5) + tail);
    PairJournal journal(file(), kDigest, kShapes);
    EXPECT_EQ(journal.done(), tiles.size() - 1);
    fill(journal);
    EXPECT_EQ(tandem::read_file(file()), whole);
  }
}

TEST_F(PairJournalFile, TellsAForeignFileFromAJournalOfAnotherRun) {
  tandem::write_file(file(), "my notes");
  EXPECT_THROW(PairJournal(file(), kDigest, 5), tandem::IoError);
  EXPECT_EQ(tandem::read_file(file()), "my notes");
  tandem::write_file(file(), "\x89TD");  // cut off at once
  EXPECT_FALSE(PairJournal(file(), kDigest, 5).replaced_another());
  {
    PairJournal journal(file(), kDigest, 5);
    fill(journal);
  }
  EXPECT_EQ(PairJournal(file(), kDigest, 5).done(), PairTiles(5).size());
  EXPECT_TRUE(PairJournal(file(), kDigest, 6).replaced_another());
  EXPECT_EQ(PairJournal(file(), kDigest, 6).done(), 0U);
  EXPECT_TRUE(PairJournal(file(), kDigest + 1, 6).replaced_another());
}

TEST_F(PairJournalFile, IsForOneAtATime) {
  {
    const PairJournal journal(file(), kDigest, 5);
    EXPECT_THROW(PairJournal(file(), kDigest, 5), tandem::IoError);
  }
  EXPECT_NO_THROW(PairJournal(file(), kDigest, 5));
  EXPECT_THROW(PairJournal(path("missing/m.partial"), kDigest, 5), tandem::IoError);
}

TEST_F(PairJournalFile, RefusesWhatIsNoTile) {
  PairJournal journal(file(), kDigest, 5);
  const std::vector<double> two(2, 0.0);
  EXPECT_THROW(journal.add(1, two), tandem::InvalidArgument);
  EXPECT_THROW(journal.add(journal.tiles().size(), {}), tandem::InvalidArgument);
  EXPECT_THROW((void)journal.costs(0), tandem::InvalidArgument);
  EXPECT_THROW((void)tandem::npy_pieces(journal), tandem::InvalidArgument);
}

TEST_F(PairJournalScanning, TakesAnyBytes) {
  constexpr std::size_t kShapes = 30;
  {
    PairJournal journal(file(), kDigest, kShapes);
    fill(journal);
  }
  const std::string whole = tandem::read_file(file());
  const PairTiles tiles(kShapes);
  EXPECT_TRUE(
      rc::check("one byte is another: the records before it stay", [&](unsigned place, unsigned char bit) {
        std::string damaged = whole;
        const std::size_t at = place % whole.size();
        damaged[at] = static_cast<char>(damaged[at] ^ (1U << bit % 8U));
        const PairJournalScan scan = scan_pair_journal(damaged, kDigest, tiles);
        RC_ASSERT(scan.end <= at);
        RC_ASSERT(scan.done < tiles.size());
        RC_ASSERT(scan.kind == (at < 8 ? Kind::foreign : at < 40 ? Kind::other : Kind::ours));
        for (std::size_t k = 0; k < tiles.size(); ++k)
          RC_ASSERT(scan.offsets[k] < scan.end || scan.offsets[k] == 0U);
      }));
}

TEST_F(CostMatrixFile, NpyIsWhatNumPyReads) {
  for (const std::size_t n : {1U, 3U, 60U, 100U}) {
    PairJournal journal(file(), kDigest, n);
    fill(journal);
    const std::string npy = content(tandem::npy_pieces(journal));
    EXPECT_EQ(npy.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t head =
        10 + static_cast<unsigned char>(npy[8]) + 256U * static_cast<unsigned char>(npy[9]);
    EXPECT_EQ(head % 64, 0U);
    EXPECT_EQ(npy[head - 1], '\n');
    const std::string number = std::to_string(n);
    EXPECT_EQ(
        npy.find("{'descr': '<f8', 'fortran_order': False, 'shape': (" + number + ", " + number + "), }"),
        10U);
    ASSERT_EQ(npy.size(), head + n * n * sizeof(double));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        double cost = -1.0;
        std::memcpy(&cost, npy.data() + head + (i * n + j) * sizeof cost, sizeof cost);
        ASSERT_TRUE(cost == cost_of(i, j) || (std::isnan(cost) && std::isnan(cost_of(i, j))));
      }
    }
    journal.remove();
  }
}

TEST_F(CostMatrixFile, CsvHasNamesAndEmptyCells) {
  PairJournal journal(file(), kDigest, 4);
  fill(journal);
  const std::vector<ShapeDescriptor> shapes = {shape("a"), shape("b, \"c\""), shape("d"), shape("")};
  EXPECT_EQ(content(tandem::csv_pieces(journal, shapes)),
            ",a,\"b, \"\"c\"\"\",d,\n"
            "a,0,0.25,0.2,\n"
            "\"b, \"\"c\"\"\",0.25,0,,0.3333333333333333\n"
            "d,0.2,,0,inf\n"
            ",,0.3333333333333333,inf,0\n");
  EXPECT_THROW((void)tandem::csv_pieces(journal, std::span(shapes).first(3)), tandem::InvalidArgument);
}

TEST(Names, AreOneLineEach) {
  const std::vector<ShapeDescriptor> shapes = {shape("a", "x"), shape("b\tc\nd\\e"), shape("f")};
  EXPECT_EQ(tandem::format_names(shapes), "a\tx\nb\\tc\\nd\\\\e\t\nf\t\n");
}

}  // namespace
