#pragma once

#include <string>
#include <vector>

#include "messages.h"
#include "tandem/io/csv.h"

namespace cli {

/// Puts the columns of every table into the order of the first one's: those of the same name belong together.
/// Tables without names, or with other names, are taken column by column; names that differ are warned of.
/// files: what the tables are called. @throws InvalidArgument other numbers of columns
void pair_columns(std::vector<tandem::CsvTable>& tables, const std::vector<std::string>& files,
                  const Messages& messages);

}  // namespace cli
