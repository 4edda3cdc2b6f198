# libtandem_cad.so, which tandem::io loads when a STEP, IGES or BREP file is named. An optional component: without it
# everything else is the same, and the program starts without OpenCASCADE. Not under a sanitizer, unless asked for:
# OpenCASCADE itself leaks.
if(TANDEM_BUILD_CAD STREQUAL "AUTO" AND TANDEM_SANITIZE)
  set(TANDEM_HAS_OCCT FALSE)
elseif(TANDEM_BUILD_CAD STREQUAL "AUTO" OR TANDEM_BUILD_CAD)
  # By hand: its own package configuration wants all of its parts, the windows among them.
  find_path(OCCT_INCLUDE_DIR STEPControl_Reader.hxx PATH_SUFFIXES opencascade)
  set(occt_libraries)
  foreach(part TKernel TKMath TKG3d TKGeomBase TKBRep TKTopAlgo TKShHealing TKXSBase TKSTEPBase TKSTEP TKIGES TKOffset)
    find_library(OCCT_${part} ${part})
    mark_as_advanced(OCCT_${part})
    list(APPEND occt_libraries ${OCCT_${part}})
  endforeach()
  if(OCCT_INCLUDE_DIR AND NOT occt_libraries MATCHES NOTFOUND)
    set(TANDEM_HAS_OCCT TRUE)
  elseif(NOT TANDEM_BUILD_CAD STREQUAL "AUTO")
    message(FATAL_ERROR "TANDEM_BUILD_CAD is on, but OpenCASCADE was not found (Debian: libocct-data-exchange-dev)")
  endif()
endif()

if(TANDEM_HAS_OCCT)
  file(GLOB cad_sources CONFIGURE_DEPENDS src/cad/*.cpp)
  add_library(tandem_cad MODULE ${cad_sources})
  tandem_compile_options(tandem_cad)
  target_include_directories(tandem_cad PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_include_directories(tandem_cad SYSTEM PRIVATE ${OCCT_INCLUDE_DIR})
  # Lofts are for the tests alone.
  set(occt_test_libraries ${occt_libraries})
  list(REMOVE_ITEM occt_libraries ${OCCT_TKOffset})
  target_link_libraries(tandem_cad PRIVATE tandem_io fmt::fmt ${occt_libraries})
  set_target_properties(tandem_cad PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
  install(TARGETS tandem_cad LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
