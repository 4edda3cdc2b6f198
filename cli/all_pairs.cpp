#include "all_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "corpus_stream.h"
#include "interrupt.h"
#include "launch.h"
#include "messages.h"
#include "mpi_team.h"
#include "output.h"
#include "progress_bar.h"
#include "tandem/error.h"
#include "tandem/io/cost_matrix.h"
#include "tandem/io/pair_journal.h"
#include "tandem/rank/team.h"
#include "usage_error.h"

namespace cli {
namespace {

using tandem::AllPairsOptions;
using tandem::PairJournal;
using tandem::ShapeDescriptor;

/// What the command line asks for.
struct Task {
  Format format = Format::npy;
  std::string output;
  std::string journal;
  tandem::CorpusOptions corpus;
  AllPairsOptions options;
};

/// Said now rather than when the work is done. @throws tandem::IoError
void check_regular(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw tandem::IoError(path + ": is not a regular file, beside which a journal could stand");
  }
}

Task read_task(const Command& command, const Launch& launch) {
  if (command.inputs.empty()) throw UsageError("rank --all-pairs takes one or more candidates");
  if (command.output.empty() || command.output == "-") {
    throw UsageError("rank --all-pairs needs -o FILE.npy or FILE.csv: its journal stands beside the file");
  }
  if (!command.rank.top.empty()) throw UsageError("--top does not go with --all-pairs, which lists all");
  if (command.rank.exhaustive) {
    throw UsageError("--exhaustive does not go with --all-pairs, which prunes nothing");
  }
  if (command.common.json) throw UsageError("--json does not go with --all-pairs");
  check_standard_input(command);
  if (launch.is_shared() && std::count(command.inputs.begin(), command.inputs.end(), "-") > 0) {
    throw UsageError("several processes cannot share standard input");
  }
  check_regular(command.output);
  Task task;
  task.format = output_format(command.output, command.to, {Format::npy, Format::csv});
  task.output = command.output;
  task.journal = command.output + ".partial";
  task.corpus = {to_load_options(command.common), to_rank_samples(command.rank)};
  task.options.compare = to_compare_options(command.rank);
  task.options.threads = to_threads(command.rank);
  if (launch.is_shared() && task.options.threads == 0) task.options.threads = share_of_cores(launch);
  return task;
}

std::vector<ShapeDescriptor> read_shapes(const Command& command, const Task& task, const Messages& messages) {
  const InterruptibleScope interruptible;
  std::vector<ShapeDescriptor> shapes;
  CorpusStream stream(command.inputs, task.corpus, messages);
  (void)tandem::describe_all(
      stream.source(), [&](ShapeDescriptor shape) { shapes.push_back(std::move(shape)); },
      stream.options(task.options.threads));
  throw_if_interrupted();
  stream.finish();
  if (shapes.empty()) throw tandem::InvalidArgument("there is no shape to compare: nothing was written");
  return shapes;
}

PairJournal open_journal(const Task& task, const std::vector<ShapeDescriptor>& shapes,
                         const Messages& messages) {
  PairJournal journal(task.journal, tandem::all_pairs_digest(shapes, task.options.compare), shapes.size());
  if (journal.replaced_another()) {
    messages.warning(task.journal + " was begun with other shapes or options: starting anew");
  } else if (journal.done() > 0) {
    messages.note(fmt::format("going on with {}: {} % are done", task.journal,
                              100 * journal.done() / journal.tiles().size()));
  }
  return journal;
}

/// The bar, Ctrl-C, and how to go on after it: said at once, since mpirun ends its processes soon after a
/// signal.
tandem::Progress show_tiles(const PairJournal& journal, const std::string& path, const Messages& messages) {
  auto said = std::make_shared<std::atomic<bool>>(false);
  return [&journal, &messages, path, said, bar = show_progress(messages.quiet())](double) {
    if (bar(static_cast<double>(journal.done()) / static_cast<double>(journal.tiles().size()))) return true;
    if (!said->exchange(true)) {
      messages.note(fmt::format("{} % are done; the same command goes on from there (with {})",
                                100 * journal.done() / journal.tiles().size(), path));
    }
    return false;
  };
}

/// The tiles that the journal lacks, into the journal.
void compare_pairs(const Task& task, const std::vector<ShapeDescriptor>& shapes, PairJournal& journal,
                   MpiTeam* mpi, const Messages& messages) {
  const InterruptibleScope interruptible;
  AllPairsOptions options = task.options;
  options.progress = show_tiles(journal, task.journal, messages);
  const tandem::TileSource source = [&journal,
                                     next = std::size_t{0}]() mutable -> std::optional<std::size_t> {
    while (next < journal.tiles().size() && journal.has(next)) ++next;
    if (next == journal.tiles().size()) return std::nullopt;
    return next++;
  };
  const tandem::TileSink sink = [&journal](std::size_t tile, std::span<const double> costs) {
    journal.add(tile, costs);
  };
  if (mpi != nullptr) {
    (void)lead_all_pairs(mpi->team(), shapes, source, sink, options);
    mpi->leave();
  } else {
    (void)all_pairs(shapes, source, sink, options);
  }
  erase_progress_bar();
  throw_if_interrupted();
}

std::string names_path(const std::string& output) {
  return std::filesystem::path(output).replace_extension(".names.txt").string();
}

void write_matrix(const Task& task, const std::vector<ShapeDescriptor>& shapes, PairJournal& journal,
                  const Messages& messages) {
  const bool npy = task.format == Format::npy;
  if (npy) write_output(names_path(task.output), tandem::format_names(shapes));
  {
    const WritingScope writing;
    tandem::FilePieces pieces = npy ? npy_pieces(journal) : csv_pieces(journal, shapes);
    tandem::write_file(task.output, [&pieces] {
      throw_if_interrupted();
      return pieces();
    });
    journal.remove();
  }
  messages.note(fmt::format("{0} x {0} costs in {1}", shapes.size(), task.output));
}

Status follow(const Task& task, const std::vector<ShapeDescriptor>& shapes, MpiTeam& mpi) {
  const InterruptibleScope interruptible;
  AllPairsOptions options = task.options;
  options.progress = [](double) { return interrupt_signal() == 0; };
  if (!follow_all_pairs(mpi.team(), shapes, options)) throw Interrupted{};
  mpi.leave();
  return kDone;
}

}  // namespace

Status run_all_pairs(const Command& command) {
  const Launch launch = find_launch();
  const Messages messages(command.common.quiet || launch.rank > 0);
  const Task task = read_task(command, launch);
  std::optional<MpiTeam> mpi;
  if (launch.is_shared()) mpi.emplace(launch);
  const std::vector<ShapeDescriptor> shapes = read_shapes(command, task, messages);
  if (mpi && mpi->team().rank > 0) return follow(task, shapes, *mpi);
  PairJournal journal = open_journal(task, shapes, messages);
  compare_pairs(task, shapes, journal, mpi ? &*mpi : nullptr, messages);
  write_matrix(task, shapes, journal, messages);
  return kDone;
}

}  // namespace cli
