#pragma once

namespace cli {

/// Where this process stands among those that mpirun started with it.
struct Launch {
  int rank = 0;
  int size = 1;
  int on_this_machine = 1;

  [[nodiscard]] bool is_shared() const noexcept { return size > 1; }
};

/// What mpirun (of Open MPI, MPICH and its kin) has left in the environment; one process without it.
[[nodiscard]] Launch find_launch();

/// Threads for this process, so that those on one machine have its cores between them.
[[nodiscard]] int share_of_cores(const Launch& launch);

}  // namespace cli
