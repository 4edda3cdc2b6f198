#include "corpus_stream.h"

#include <fmt/format.h>

#include "progress_bar.h"

namespace cli {
namespace {

/// So many are named; the rest of a large corpus that is broken is only counted.
constexpr std::size_t kNamedFailures = 10;

}  // namespace

CorpusStream::CorpusStream(const std::vector<std::string>& names, const tandem::CorpusOptions& options,
                           const Messages& messages)
    : corpus_(names, options), messages_(messages) {}

tandem::CandidateSource CorpusStream::source() {
  return [this] { return corpus_.next(); };
}

tandem::StreamOptions CorpusStream::options(int threads) {
  tandem::StreamOptions options;
  options.threads = threads;
  options.fraction = [this] { return corpus_.fraction(); };
  options.progress = show_progress(messages_.quiet());
  options.on_failure = [this](const tandem::Candidate& candidate, const tandem::Error& error) {
    if (failed_++ >= kNamedFailures) return;
    const std::string_view what = error.what();
    const bool named = what.substr(0, candidate.name.size()) == candidate.name;
    messages_.warning(named ? std::string(what) : fmt::format("{}: {}", candidate.name, what));
  };
  return options;
}

void CorpusStream::finish() const {
  erase_progress_bar();
  if (failed_ > kNamedFailures) messages_.warning(fmt::format("{} candidates could not be read", failed_));
}

}  // namespace cli
