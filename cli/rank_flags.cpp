#include "rank_flags.h"

#include "values.h"

namespace cli {
namespace {

using tandem::RankCost;

constexpr int kMostSamples = 2'000;  // a comparison takes time with their square, and memory
constexpr int kDefaultSamples = 100;
constexpr int kDefaultTop = 100;
constexpr int kMostListed = 1'000'000'000;
constexpr double kLargestCharge = 2.0;  // no node costs more

}  // namespace

void add_rank_flags(CLI::App& command, RankFlags& flags) {
  command.add_option("--cost", flags.cost, "symmetric (default), paper, elastic")->type_name("NAME");
  command
      .add_option("--charge", flags.charge,
                  "symmetric: the price of a step that is not diagonal (docs/recognition.md)")
      ->type_name("X");
  command.add_option("--top", flags.top, "How many of the best to list (100); 0: all")->type_name("N");
  command.add_flag("--rotate", flags.rotate, "A turned shape is the same shape (default)");
  command.add_flag("--no-rotate", flags.no_rotate, "Compare shapes as they lie");
  command.add_flag("--mirror", flags.mirror, "A mirrored shape is the same shape, too");
  command.add_flag("--exhaustive", flags.exhaustive, "Prune nothing: slower, the same answer");
  command.add_flag("--all-pairs", flags.all_pairs,
                   "No query: every candidate against every other, into -o FILE.npy or FILE.csv");
  add_samples_flag(command, flags);
  add_threads_flag(command, flags);
}

void add_samples_flag(CLI::App& command, RankFlags& flags) {
  command.add_option("--samples", flags.samples, "Nodes per shape (100)")->type_name("M");
}

void add_threads_flag(CLI::App& command, RankFlags& flags) {
  command.add_option("--threads", flags.threads, "Threads to use (all); the result does not depend on it")
      ->type_name("N");
}

tandem::CompareOptions to_compare_options(const RankFlags& flags) {
  if (flags.rotate && flags.no_rotate) throw UsageError("--rotate and --no-rotate exclude each other");
  tandem::CompareOptions options;
  options.cost = choose<RankCost>(
      "--cost", flags.cost,
      {{"symmetric", RankCost::symmetric}, {"paper", RankCost::paper}, {"elastic", RankCost::elastic}});
  options.rotate = !flags.no_rotate;
  options.mirror = flags.mirror;
  if (!flags.charge.empty()) {
    if (options.cost != RankCost::symmetric) throw UsageError("--charge belongs to --cost symmetric");
    options.charge = parse_number("--charge", flags.charge, 0.0, kLargestCharge);
  }
  return options;
}

tandem::RankOptions to_rank_options(const RankFlags& flags) {
  tandem::RankOptions options;
  options.compare = to_compare_options(flags);
  options.top = static_cast<std::size_t>(flags.top.empty() ? kDefaultTop
                                                           : parse_count("--top", flags.top, 0, kMostListed));
  options.prune = !flags.exhaustive;
  options.stream.threads = to_threads(flags);
  return options;
}

int to_rank_samples(const RankFlags& flags) {
  return flags.samples.empty() ? kDefaultSamples : parse_count("--samples", flags.samples, 3, kMostSamples);
}

int to_threads(const RankFlags& flags) {
  return flags.threads.empty() ? 0 : parse_count("--threads", flags.threads, 1, 1024);
}

}  // namespace cli
