# `cpack -G DEB` in the build folder makes a package for the Debian release whose ParaView the plugin
# was built with. Included by the top-level CMakeLists.txt, after the rules of `cmake --install`.
set(CPACK_PACKAGE_NAME "paraview-camaron")
set(CPACK_PACKAGE_VERSION "${Camaron_VERSION}")
set(CPACK_PACKAGE_CONTACT "The Camarón for ParaView authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "quality of polygonal and polyhedral meshes in ParaView")
set(CPACK_PACKAGE_DESCRIPTION "Camarón for ParaView reads meshes of any polygons and polyhedra,\
 evaluates quality criteria on every cell, and shows which cells are bad and where they are.\n\
 The package contains the plugin Camaron, the Python package camaron, the command camaron,\
 its manual and examples.")
set(CPACK_PACKAGING_INSTALL_PREFIX "${prefix}")
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)

# The plugin fits this release of ParaView alone, whose package depends on the same libraries.
string(REGEX MATCH "^([0-9]+)\\.([0-9]+)\\.([0-9]+)" release "${ParaView_VERSION}")
math(EXPR next "${CMAKE_MATCH_3} + 1")
set(CPACK_DEBIAN_PACKAGE_DEPENDS "paraview (>= ${release}), \
paraview (<< ${CMAKE_MATCH_1}.${CMAKE_MATCH_2}.${next}~), python3-paraview")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "openmpi-bin, xauth, xvfb") # for several ranks, and pictures without a display

# ParaView finds plugins by name in the files that its paraview.conf lists; see ListPlugin.cmake.in.
get_filename_component(folder "${CAMARON_PLUGINS_DIR}" DIRECTORY)
set(CAMARON_PARAVIEW_CONF "${prefix}/${folder}/paraview.conf")
file(RELATIVE_PATH CAMARON_CONF_LINE "/${folder}" "/${CAMARON_PLUGINS_DIR}/camaron.plugins.xml")
set(CAMARON_INSTALLED_PYTHON "${prefix}/${CAMARON_PYTHON_DIR}")
set(packaging "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/packaging")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA)
foreach (script IN ITEMS postinst prerm triggers)
  configure_file("packaging/debian/${script}.in" "${packaging}/${script}" @ONLY)
  list(APPEND CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${packaging}/${script}")
endforeach ()
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
