#include "launch.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace cli {
namespace {

/// The first of these variables that is a positive number.
int number(const char* open_mpi, const char* mpich, int otherwise) {
  for (const char* name : {open_mpi, mpich}) {
    const char* text = std::getenv(name);
    if (text == nullptr) continue;
    char* end = nullptr;
    const long value = std::strtol(text, &end, 10);
    if (end != text && *end == '\0' && value >= 0 && value <= 1'000'000) return static_cast<int>(value);
  }
  return otherwise;
}

}  // namespace

Launch find_launch() {
  Launch launch;
  launch.size = std::max(1, number("OMPI_COMM_WORLD_SIZE", "PMI_SIZE", 1));
  launch.rank = number("OMPI_COMM_WORLD_RANK", "PMI_RANK", 0);
  launch.on_this_machine = std::max(1, number("OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS", 1));
  return launch;
}

int share_of_cores(const Launch& launch) {
  return std::max(1, static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN)) / launch.on_this_machine);
}

}  // namespace cli
