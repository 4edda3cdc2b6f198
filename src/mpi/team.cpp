#include "tandem/rank/team.h"

#include <mpi.h>

#include "tandem/version.h"

/// The optional component libtandem_mpi.so: carries the messages of a team. The program loads it when it runs
/// under mpirun with others. MPI ends all processes by itself when a call of it fails.

#define TANDEM_MPI_EXPORT __attribute__((visibility("default")))

namespace {

constexpr int kTag = 0;

void send(int to, std::span<const std::uint64_t> words) {
  MPI_Send(words.data(), static_cast<int>(words.size()), MPI_UINT64_T, to, kTag, MPI_COMM_WORLD);
}

std::optional<tandem::TeamMessage> receive() {
  int arrived = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &arrived, &status);
  if (arrived == 0) return std::nullopt;
  int count = 0;
  MPI_Get_count(&status, MPI_UINT64_T, &count);
  tandem::TeamMessage message{status.MPI_SOURCE, std::vector<std::uint64_t>(static_cast<std::size_t>(count))};
  MPI_Recv(message.words.data(), count, MPI_UINT64_T, message.from, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

}  // namespace

extern "C" {

/// Asked before anything else: the rest is C++ of this very version.
TANDEM_MPI_EXPORT const char* tandem_mpi_version() {
  return tandem::kVersion.data();
}

/// Nothing, or why not.
TANDEM_MPI_EXPORT const char* tandem_mpi_join(tandem::Team* team) {
  int level = MPI_THREAD_SINGLE;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &level);
  if (level < MPI_THREAD_SERIALIZED) return "this MPI was built without threads";
  MPI_Comm_rank(MPI_COMM_WORLD, &team->rank);
  MPI_Comm_size(MPI_COMM_WORLD, &team->size);
  team->send = send;
  team->receive = receive;
  return nullptr;
}

TANDEM_MPI_EXPORT void tandem_mpi_leave() {
  MPI_Finalize();
}

}  // extern "C"
