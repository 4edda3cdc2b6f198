# libtandem_mpi.so, which the program loads when mpirun has started several of it. An optional component: without it
# everything else is the same. Not under a sanitizer, unless asked for: MPI itself leaks.
if(TANDEM_BUILD_MPI STREQUAL "AUTO")
  if(NOT TANDEM_SANITIZE)
    set(MPI_CXX_SKIP_MPICXX ON)
    find_package(MPI QUIET COMPONENTS CXX)
  endif()
elseif(TANDEM_BUILD_MPI)
  set(MPI_CXX_SKIP_MPICXX ON)
  find_package(MPI REQUIRED COMPONENTS CXX)
endif()

if(TANDEM_BUILD_MPI AND MPI_CXX_FOUND)
  add_library(tandem_mpi MODULE src/mpi/team.cpp)
  tandem_compile_options(tandem_mpi)
  target_include_directories(tandem_mpi PRIVATE
    ${PROJECT_SOURCE_DIR}/include ${PROJECT_BINARY_DIR}/include)
  target_link_libraries(tandem_mpi PRIVATE MPI::MPI_CXX)
  set_target_properties(tandem_mpi PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
  add_dependencies(tandem_cli tandem_mpi)
  install(TARGETS tandem_mpi LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
