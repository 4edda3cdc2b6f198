#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tandem/io/load.h"
#include "tandem/rank/rank.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

struct CorpusOptions {
  LoadOptions load = {};
  int samples = 100;  ///< see DescribeOptions; those of a .tdx file are what they are
};

/// The candidates behind names on the command line (docs/interface.md, "A corpus"), one after the other:
/// a directory, a font, a FILE.jsonl or a FILE.tdx counts as many, any other name as one shape.
///
/// Files are opened when their turn comes, and one is held at a time; those of single shapes are read by the
/// candidate's describe(), in parallel. A candidate that was named itself is `required`. Names and labels:
/// a glyph is called FONT#GLYPH, its label is its character; a line of .jsonl has "name" and "label" members
/// or is called FILE.jsonl#N; a file below a directory has the name of its own directory for a label, unless
/// that is the one that was named.
class TANDEM_IO_EXPORT Corpus {
 public:
  /// Lists the directories. @throws IoError a name that is no file and cannot be anything else, or a
  ///         directory that cannot be read
  explicit Corpus(const std::vector<std::string>& names, const CorpusOptions& options = {});
  Corpus(Corpus&&) noexcept;
  Corpus& operator=(Corpus&&) noexcept;
  ~Corpus();

  /// Nothing: the end. @throws IoError, ParseError a font, .jsonl or .tdx file that was named cannot be read
  [[nodiscard]] std::optional<Candidate> next();
  /// How much of it has been handed out, in [0,1].
  [[nodiscard]] double fraction() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace v0
}  // namespace tandem
