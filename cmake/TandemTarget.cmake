# What every target of the project is compiled with.
include(GenerateExportHeader)

# Same results on every machine: no fused multiply-add, no fast-math (docs/architecture.md, decision 7).
function(tandem_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  if(TANDEM_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${TANDEM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    if(TANDEM_SANITIZE MATCHES "address.*undefined" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # AddressSanitizer faults on the first two by itself, and the third changes nothing on the machines that we know.
      # They double the time to compile; the fuzz targets (clang) keep them.
      target_compile_options(${target} PRIVATE -fno-sanitize=null,object-size,alignment)
    endif()
    target_link_options(${target} PRIVATE -fsanitize=${TANDEM_SANITIZE})
  endif()
endfunction()

# A library of the project: warnings, public headers, visibility macros, and its place in the package.
function(tandem_library target)
  tandem_compile_options(${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  generate_export_header(${target} BASE_NAME ${target}
    EXPORT_FILE_NAME ${PROJECT_BINARY_DIR}/include/tandem/${target}_export.h)
  # Before 1.0 a minor version may break the binary interface.
  set_target_properties(${target} PROPERTIES
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  if(NOT TARGET tandem::${target})
    add_library(tandem::${target} ALIAS ${target})
  endif()
  install(TARGETS ${target} EXPORT tandemTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()
