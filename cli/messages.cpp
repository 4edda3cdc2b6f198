#include "messages.h"

#include <fmt/format.h>

#include <cstdio>

#include "progress_bar.h"

namespace cli {

void Messages::error(std::string_view text) const {
  erase_progress_bar();
  if (!quiet_) fmt::print(stderr, "tandem: {}\n", text);
}

void Messages::warning(std::string_view text) const {
  erase_progress_bar();
  if (!quiet_) fmt::print(stderr, "tandem: warning: {}\n", text);
}

void Messages::note(std::string_view text) const {
  erase_progress_bar();
  if (!quiet_) fmt::print(stderr, "tandem: note: {}\n", text);
}

}  // namespace cli
