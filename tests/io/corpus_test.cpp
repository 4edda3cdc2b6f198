#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tandem/error.h"
#include "tandem/io/csv.h"
#include "tandem/io/files.h"
#include "tandem/io/itd.h"
#include "tandem/io/json.h"
#include "tandem/io/pair_journal.h"
#include "tandem/io/path_data.h"
#include "tandem/io/svg.h"
#include "tandem/io/tdx.h"

// The fuzzers' corpora, crashes of the past among them, through the readers in every ordinary build.

namespace {

namespace fs = std::filesystem;

struct Corpus {
  const char* name;
  std::function<void(const std::string&)> read;
};

const Corpus kCorpora[] = {
    {"path_data", [](const std::string& text) { (void)tandem::parse_path_data(text); }},
    {"svg", [](const std::string& text) { (void)tandem::parse_svg(text); }},
    {"tdx", [](const std::string& text) { (void)tandem::parse_tdx(text); }},
    {"json", [](const std::string& text) { (void)tandem::parse_json_curves(text); }},
    {"itd", [](const std::string& text) { (void)tandem::parse_itd(text); }},
    {"csv", [](const std::string& text) { (void)tandem::parse_csv(text); }},
    {"pair_journal",
     [](const std::string& text) { (void)tandem::scan_pair_journal(text, 7, tandem::PairTiles(6)); }},
};

TEST(Corpus, IsReadOrRefused) {
  for (const Corpus& corpus : kCorpora) {
    int entries = 0;
    int read = 0;
    for (const auto& entry :
         fs::directory_iterator(fs::path(TANDEM_TEST_DATA) / "../../fuzz/corpus" / corpus.name)) {
      SCOPED_TRACE(entry.path().string());
      ++entries;
      const std::string text = tandem::read_file(entry.path().string());
      try {
        corpus.read(text);
        ++read;
      } catch (const tandem::ParseError&) {
      } catch (const std::exception& error) {
        ADD_FAILURE() << error.what();
      }
    }
    EXPECT_GT(entries, 0) << corpus.name;
    EXPECT_GT(read, 0) << corpus.name;
  }
}

}  // namespace
