# `cpack -G DEB` in the build folder makes a package for the Debian release whose ParaView the plugin
# was built with. Included by the top-level CMakeLists.txt, after the rules of `cmake --install`.
set(CPACK_PACKAGE_NAME "paraview-camaron")
set(CPACK_PACKAGE_VERSION "${Camaron_VERSION}")
# The project has no address; who passes the package on gives theirs as for Debian's other tools.
set(CPACK_PACKAGE_CONTACT "Camarón for ParaView authors <camaron@example.org>")
if (DEFINED ENV{DEBEMAIL})
  set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif ()
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "quality of polygonal and polyhedral meshes in ParaView")
set(CPACK_PACKAGE_DESCRIPTION "Camarón for ParaView reads meshes of any polygons and polyhedra, evaluates\n\
quality criteria on every cell, and shows which cells are bad and where they\n\
are. The package contains the plugin Camaron, the Python package camaron, the\n\
command camaron, its manual and examples.")
set(CPACK_PACKAGING_INSTALL_PREFIX "${prefix}")
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)

# The plugin fits this release of ParaView alone.
string(REGEX MATCH "^([0-9]+)\\.([0-9]+)\\.([0-9]+)" release "${ParaView_VERSION}")
math(EXPR next "${CMAKE_MATCH_3} + 1")
set(CPACK_DEBIAN_PACKAGE_DEPENDS "paraview (>= ${release}), \
paraview (<< ${CMAKE_MATCH_1}.${CMAKE_MATCH_2}.${next}~), python3, python3-paraview")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # and the libraries' packages
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "openmpi-bin, xauth, xvfb") # for several ranks, and pictures without a display

# Debian's ParaView lists in Manage Plugins, and finds by name, the plugins of the files that its paraview.conf names. One
# of these belongs to no other package.
set(CAMARON_PLUGIN_LIST "/usr/share/paraview/plugins")
set(CAMARON_INSTALLED_PYTHON "${prefix}/${CAMARON_PYTHON_DIR}")
set(packaging "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/packaging")
find_program(CAMARON_HELP2MAN help2man)
mark_as_advanced(CAMARON_HELP2MAN)
configure_file("packaging/debian/files.cmake.in" "${packaging}/files.cmake" @ONLY)
configure_file("packaging/debian/prerm.in" "${packaging}/prerm" @ONLY)
set(CPACK_PRE_BUILD_SCRIPTS "${packaging}/files.cmake")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${packaging}/prerm")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
