#pragma once

#include <cstddef>
#include <string>

#include "messages.h"
#include "tandem/io/corpus.h"
#include "tandem/rank/rank.h"

namespace cli {

/// A corpus as rank and index run over it: with a progress bar, Ctrl-C, and warnings about what is broken.
class CorpusStream {
 public:
  CorpusStream(const std::vector<std::string>& names, const tandem::CorpusOptions& options,
               const Messages& messages);

  [[nodiscard]] tandem::CandidateSource source();
  [[nodiscard]] tandem::StreamOptions options(int threads);
  /// Says how many candidates could not be read, if there were any.
  void finish() const;

 private:
  tandem::Corpus corpus_;
  const Messages& messages_;
  std::size_t failed_ = 0;
};

}  // namespace cli
