#pragma once

#include "launch.h"
#include "tandem/rank/team.h"

namespace cli {

/// The processes of one mpirun. MPI is an optional component in a library of its own, which is loaded here
/// and nowhere else, so that everything else starts without it.
class MpiTeam {
 public:
  /// @throws tandem::IoError the component is not there, or of another version or another MPI than mpirun
  explicit MpiTeam(const Launch& launch);

  [[nodiscard]] const tandem::Team& team() const noexcept { return team_; }
  /// Every process calls this when its work is done. One that ends without it ends the others, too.
  void leave();

 private:
  tandem::Team team_;
  void (*leave_)() = nullptr;
};

}  // namespace cli
