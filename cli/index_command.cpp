#include <fmt/format.h>

#include <string>

#include "commands.h"
#include "corpus_stream.h"
#include "interrupt.h"
#include "messages.h"
#include "output.h"
#include "tandem/error.h"
#include "tandem/io/tdx.h"
#include "usage_error.h"

namespace cli {
namespace {

Status run(const Command& command) {
  const Messages messages(command.common.quiet);
  if (command.inputs.empty())
    throw UsageError("index takes one or more shapes, directories, fonts or .jsonl files");
  if (command.output.empty()) throw UsageError("index needs -o FILE.tdx, or - for standard output");
  check_standard_input(command);
  if (command.output != "-") (void)output_format(command.output, command.to, {Format::index});
  check_writable(command.output);
  const tandem::CorpusOptions options{to_load_options(command.common), to_rank_samples(command.rank)};
  std::string records;
  std::size_t count = 0;
  {
    const InterruptibleScope interruptible;
    CorpusStream stream(command.inputs, options, messages);
    (void)tandem::describe_all(
        stream.source(),
        [&](const tandem::ShapeDescriptor& shape) {
          records += tandem::format_tdx_record(shape);
          ++count;
        },
        stream.options(to_threads(command.rank)));
    throw_if_interrupted();
    stream.finish();
  }
  if (count == 0) throw tandem::InvalidArgument("there is no shape to index: nothing was written");
  write_output(command.output, tandem::format_tdx_head(count) + records);
  if (command.output != "-") messages.note(fmt::format("{} shapes in {}", count, command.output));
  return kDone;
}

void add_flags(Command& command) {
  command.app->add_option("shapes", command.inputs,
                          "Directories, fonts, .jsonl files, shapes, and other indices");
  command.app->add_option("-o,--output", command.output, ".tdx, or - for standard output")->type_name("OUT");
  command.app->add_option("--to", command.to, "tdx: whatever the ending of OUT")->type_name("FORMAT");
  add_common_flags(*command.app, command.common);
  add_samples_flag(*command.app, command.rank);
  add_threads_flag(*command.app, command.rank);
}

}  // namespace

const Subcommand kIndexCommand = {"index", "Shapes prepared once for rank", add_flags, run};

}  // namespace cli
