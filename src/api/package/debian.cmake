# `cpack --config build/release/CPackConfig.cmake` makes four Debian packages: libups0 (the libraries), libups-dev,
# ups-tools (the program) and python3-ups. What they depend on is what they were built with: build on the release that
# they are for. A build configured with CMAKE_INSTALL_PREFIX=/usr has its libraries in Debian's folder of the architecture.
set(UPS_PACKAGE_CONTACT "UPS local build <root@localhost>" CACHE STRING "Maintainer that the packages name")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ups)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT ${UPS_PACKAGE_CONTACT})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES TRUE)
set(CPACK_COMPONENTS_ALL runtime development python)
if(TARGET ups_program)
  list(APPEND CPACK_COMPONENTS_ALL tools)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src/api)
foreach(extra ${extras})
  list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src/extras/${extra})
endforeach()

# Each has its terms where Debian has them; `cmake --install` does without.
function(ups_package component name section description)
  string(TOUPPER CPACK_DEBIAN_${component} package)
  set(${package}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(${package}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(${package}_DESCRIPTION "${description}" PARENT_SCOPE)
  install(FILES copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

set(same_version "libups0 (= ${PROJECT_VERSION})")
ups_package(runtime libups0 libs "The libraries: the core and what reads and writes glTF,
 OpenEXR, PNG, maps and reports, each with a C interface.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
# oneTBB loads it where it is there, and takes memory from it: see ups_base.h on exhausted memory.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS libtbbmalloc2)
# What a package depends on whose programs are linked with the libraries: before 1.0 not the next minor version.
if(PROJECT_VERSION_MAJOR EQUAL 0)
  math(EXPR next "${PROJECT_VERSION_MINOR} + 1")
  set(next 0.${next})
else()
  math(EXPR next "${PROJECT_VERSION_MAJOR} + 1")
endif()
set(shlibs)
foreach(library ${libraries})
  string(APPEND shlibs
         "lib${library} ${UPS_SOVERSION} libups0 (>= ${PROJECT_VERSION}), libups0 (<< ${next})\n")
endforeach()
file(CONFIGURE OUTPUT shlibs CONTENT "${shlibs}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/triggers ${CMAKE_CURRENT_BINARY_DIR}/shlibs)

# Its pkg-config files of the extras, and its static libraries, need the others' development files.
ups_package(development libups-dev libdevel "Development files: headers, CMake and pkg-config
 files, static libraries, the sources of the C# binding, samples.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "${same_version}, libembree-dev, libtbb-dev, libtinygltf-dev, libopenexr-dev, libopencolorio-dev, libcairo2-dev")

ups_package(tools ups-tools science "The program ups, which renders glTF scenes with photometric
 files: tables, maps, images and a report.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "${same_version}")

ups_package(python python3-ups python "The Python package ups, with numpy arrays.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${same_version}, python3 (>= 3.11), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-matplotlib)
include(CPack)
