#include "mpi_team.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <string_view>

#include "tandem/error.h"
#include "tandem/version.h"

namespace cli {
namespace {

constexpr const char* kLibrary = "libtandem_mpi.so";

/// A function of the component. The types are those of src/mpi/team.cpp.
template <class Function>
Function* find(void* library, const char* name) {
  void* symbol = dlsym(library, name);
  if (symbol == nullptr) throw tandem::IoError(fmt::format("{} has no {}", kLibrary, name));
  return reinterpret_cast<Function*>(symbol);
}

}  // namespace

MpiTeam::MpiTeam(const Launch& launch) {
  // RTLD_GLOBAL: Open MPI loads plugins of its own, which look for its symbols.
  void* library = dlopen(kLibrary, RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr) {
    throw tandem::IoError(
        fmt::format("this program was started as one of {} processes, but cannot work with others: {}; build "
                    "it with TANDEM_BUILD_MPI=ON, or start one process",
                    launch.size, dlerror()));
  }
  const std::string_view version = find<const char*()>(library, "tandem_mpi_version")();
  if (version != tandem::kVersion) {
    throw tandem::IoError(
        fmt::format("{} belongs to tandem {}, this is {}", kLibrary, version, tandem::kVersion));
  }
  leave_ = find<void()>(library, "tandem_mpi_leave");
  if (const char* reason = find<const char*(tandem::Team*)>(library, "tandem_mpi_join")(&team_)) {
    throw tandem::IoError(reason);
  }
  if (team_.size != launch.size) {
    throw tandem::IoError(
        fmt::format("mpirun started {} processes, but {} finds {}: are they of the same MPI?", launch.size,
                    kLibrary, team_.size));
  }
}

void MpiTeam::leave() {
  leave_();
}

}  // namespace cli
