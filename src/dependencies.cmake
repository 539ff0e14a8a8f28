# What the library links, found the same way by its build and by projects that use it.
include(CMakeFindDependencyMacro)

find_dependency(Threads)
find_dependency(Imath CONFIG)
find_dependency(OpenEXR CONFIG)
find_dependency(OpenImageIO CONFIG)
find_dependency(TBB CONFIG)
find_dependency(embree 3 CONFIG)
find_dependency(fmt CONFIG)
find_dependency(nlohmann_json CONFIG)
find_dependency(OpenSSL COMPONENTS Crypto)
find_dependency(tinyobjloader CONFIG)
find_dependency(PkgConfig)
# Debian 12's CMake config of OpenColorIO names folders that do not exist; libdeflate has none.
foreach(module OpenColorIO libdeflate)
  if(NOT TARGET PkgConfig::${module})
    pkg_check_modules(${module} REQUIRED IMPORTED_TARGET GLOBAL ${module})
  endif()
endforeach()
# Debian 12's CMake config of OpenSubdiv names a static library that is not shipped.
if(NOT TARGET OpenSubdiv::osdCPU)
  find_path(OPENSUBDIV_INCLUDE_DIR opensubdiv/bfr/surface.h REQUIRED) # Bfr came with 3.5
  find_library(OPENSUBDIV_CPU_LIBRARY osdCPU REQUIRED)
  add_library(OpenSubdiv::osdCPU UNKNOWN IMPORTED GLOBAL)
  set_target_properties(OpenSubdiv::osdCPU PROPERTIES
    IMPORTED_LOCATION ${OPENSUBDIV_CPU_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${OPENSUBDIV_INCLUDE_DIR})
endif()
