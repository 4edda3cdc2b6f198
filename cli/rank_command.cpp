#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "all_pairs.h"
#include "commands.h"
#include "corpus_stream.h"
#include "interrupt.h"
#include "launch.h"
#include "messages.h"
#include "output.h"
#include "progress_bar.h"
#include "report.h"
#include "tandem/error.h"
#include "tandem/io/corpus.h"
#include "tandem/io/rank_page.h"
#include "usage_error.h"

namespace cli {
namespace {

using tandem::Comparison;
using tandem::RankedShape;
using tandem::Ranking;
using tandem::ShapeDescriptor;

/// The one shape behind the name.
ShapeDescriptor load_query(const std::string& name, const tandem::CorpusOptions& options) {
  tandem::Corpus corpus({name}, options);
  const std::optional<tandem::Candidate> query = corpus.next();
  if (!query) throw tandem::InvalidArgument(name + ": holds no shape");
  ShapeDescriptor shape = query->describe();
  if (corpus.next()) {
    throw tandem::InvalidArgument(
        fmt::format("{}: holds several shapes; the query is one of them, {}#NAME", name, name));
  }
  return shape;
}

std::string format_line(const RankedShape& each, std::size_t rank) {
  const Comparison& c = each.comparison;
  std::string rotation;
  for (const double value : c.rotation.values())
    rotation += (rotation.empty() ? "" : ", ") + json_number(value);
  return fmt::format(
      R"({{"rank": {}, "name": {}, "label": {}, "index": {}, "cost": {}, "degrees": {}, "rotation": [{}], )"
      R"("mirrored": {}, "reversed": {}, "shift": {}}})"
      "\n",
      rank, json_string(each.name), each.label.empty() ? "null" : json_string(each.label), each.index,
      json_number(c.cost), json_number(c.rotation.degrees()), rotation, c.mirrored, c.reversed, c.shift);
}

std::string format_lines(const Ranking& ranking) {
  std::string text;
  for (std::size_t k = 0; k < ranking.best.size(); ++k) text += format_line(ranking.best[k], k + 1);
  return text;
}

/// A name on one line of a terminal: control characters as \xHH.
std::string printable(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte < 0x20 || byte == 0x7F ? fmt::format("\\x{:02X}", byte) : std::string(1, c);
  }
  return text;
}

std::string format_table(const Ranking& ranking) {
  std::string text =
      fmt::format("{:>5}  {:>9}  {:>7}  {:<8}  {}\n", "rank", "cost", "turn", "mirrored", "name");
  for (std::size_t k = 0; k < ranking.best.size(); ++k) {
    const RankedShape& each = ranking.best[k];
    // Rounding may leave a minus before zero.
    const double degrees = std::round(each.comparison.rotation.degrees() * 10.0) / 10.0 + 0.0;
    text += fmt::format("{:>5}  {:>9.6f}  {:>6.1f}°  {:<8}  {}\n", k + 1, each.comparison.cost, degrees,
                        each.comparison.mirrored ? "yes" : "no", printable(each.name));
  }
  return text;
}

void say_what_is_missing(const Messages& messages, const Ranking& ranking) {
  if (ranking.incomparable > 0) {
    messages.warning(fmt::format(
        "{} of {} candidates cannot be compared with the query: open against closed, or another dimension",
        ranking.incomparable, ranking.candidates));
  }
  const std::size_t compared = ranking.candidates - ranking.failed - ranking.incomparable;
  if (compared > ranking.best.size()) {
    messages.note(
        fmt::format("the best {} of {} candidates; --top 0 lists all", ranking.best.size(), compared));
  }
}

Ranking rank_candidates(const Command& command, const ShapeDescriptor& query, tandem::RankOptions options,
                        const tandem::CorpusOptions& corpus, const Messages& messages) {
  const InterruptibleScope interruptible;
  CorpusStream stream({command.inputs.begin() + 1, command.inputs.end()}, corpus, messages);
  const int threads = options.stream.threads;
  options.stream = stream.options(threads);
  Ranking ranking = tandem::rank(query, stream.source(), options);
  throw_if_interrupted();
  stream.finish();
  return ranking;
}

Status run(const Command& command) {
  if (command.rank.all_pairs) return run_all_pairs(command);
  if (find_launch().is_shared()) {
    throw UsageError("several processes share the work of rank --all-pairs only; start one for a query");
  }
  const Messages messages(command.common.quiet);
  if (command.inputs.size() < 2) {
    throw UsageError(fmt::format("rank takes a query and one or more candidates, not {} name{}",
                                 command.inputs.size(), command.inputs.size() == 1 ? "" : "s"));
  }
  check_standard_input(command);
  tandem::RankOptions options = to_rank_options(command.rank);
  const bool to_file = !command.output.empty();
  const Format format = to_file
                            ? output_format(command.output, command.to, {Format::html, Format::json_lines})
                            : Format::json_lines;
  options.keep_shapes = to_file && format == Format::html;
  const tandem::CorpusOptions corpus{to_load_options(command.common), to_rank_samples(command.rank)};
  const ShapeDescriptor query = load_query(command.inputs.front(), corpus);
  if (to_file) check_writable(command.output);
  const Ranking ranking = rank_candidates(command, query, options, corpus, messages);
  if (ranking.best.empty()) {
    throw tandem::InvalidArgument(fmt::format("none of {} candidates can be compared with {}",
                                              ranking.candidates, command.inputs.front()));
  }
  say_what_is_missing(messages, ranking);
  if (to_file) {
    write_output(command.output, format == Format::html
                                     ? tandem::format_rank_page(query, ranking, command.inputs.front())
                                     : format_lines(ranking));
  }
  if (command.common.json && command.output != "-") write_output("-", format_lines(ranking));
  if (!command.common.json && !to_file) write_output("-", format_table(ranking));
  return kDone;
}

void add_flags(Command& command) {
  command.app->add_option("shapes", command.inputs,
                          "The query, then candidates: shapes, directories, fonts, .jsonl or .tdx files");
  command.app
      ->add_option("-o,--output", command.output,
                   ".html (pictures of the best), .jsonl, or - for standard output; all pairs: .npy, .csv")
      ->type_name("OUT");
  command.app->add_option("--to", command.to, "html, jsonl, npy, csv: whatever the ending of OUT")
      ->type_name("FORMAT");
  add_common_flags(*command.app, command.common);
  add_rank_flags(*command.app, command.rank);
}

}  // namespace

const Subcommand kRankCommand = {"rank", "Candidates by how well they match a query, best first", add_flags,
                                 run};

}  // namespace cli
