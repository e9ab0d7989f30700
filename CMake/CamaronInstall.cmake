# Rules of `cmake --install`: the plugin and the Python package go where a ParaView with the same
# prefix finds them, and the command `camaron` is installed. Included by the top-level
# CMakeLists.txt.
get_filename_component(libdir "${ParaView_DIR}/../.." REALPATH)
get_filename_component(prefix "${ParaView_PREFIX_PATH}" REALPATH)
file(RELATIVE_PATH libdir "${prefix}" "${libdir}")
if (libdir MATCHES "^(\\.\\.|$)")
  set(libdir "${CMAKE_INSTALL_LIBDIR}")
endif ()
set(CAMARON_PLUGINS_DIR "${libdir}/${PARAVIEW_PLUGIN_SUBDIR}")
set(CAMARON_DATA_DIR "${CMAKE_INSTALL_DATADIR}/camaron")
set(CAMARON_PYTHON_DIR "${CAMARON_DATA_DIR}/python")
if (PARAVIEW_PYTHONPATH)
  set(CAMARON_PYTHON_DIR "${PARAVIEW_PYTHONPATH}")
endif ()

install(TARGETS Camaron DESTINATION "${CAMARON_PLUGINS_DIR}/Camaron")
if (TARGET CamaronPanel)
  install(TARGETS CamaronPanel DESTINATION "${CAMARON_PLUGINS_DIR}/Camaron/Panel")
endif ()
if (TARGET CamaronIdleRanks)
  install(TARGETS CamaronIdleRanks DESTINATION "${CAMARON_PLUGINS_DIR}/Camaron")
endif ()
install(FILES "$<TARGET_FILE_DIR:Camaron>/formats.json" "$<TARGET_FILE_DIR:Camaron>/version.txt"
  DESTINATION "${CAMARON_PLUGINS_DIR}/Camaron")
install(FILES "$<TARGET_FILE_DIR:Camaron>/../camaron.plugins.xml" DESTINATION "${CAMARON_PLUGINS_DIR}")

set(doc "${CMAKE_INSTALL_DATADIR}/doc/paraview-camaron")
install(FILES README.md CHANGELOG.md LICENSE DESTINATION "${doc}")
install(FILES LICENSE DESTINATION "${doc}" RENAME copyright) # where Debian's users look for it
install(DIRECTORY Documentation DESTINATION "${doc}" PATTERN "*.py" EXCLUDE)
install(DIRECTORY Readers DESTINATION "${doc}" FILES_MATCHING PATTERN "README.md"
  PATTERN "Testing" EXCLUDE PATTERN "Base" EXCLUDE PATTERN "Intake" EXCLUDE)
install(DIRECTORY Examples DESTINATION "${doc}")

set(installed "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/installed")
configure_file(CMake/ListPlugin.cmake.in "${installed}/ListPlugin.cmake" @ONLY)
install(SCRIPT "${installed}/ListPlugin.cmake")
set(modulefiles "${CMAKE_INSTALL_DATADIR}/modulefiles/camaron")
file(RELATIVE_PATH CAMARON_UP_TO_PREFIX "/${modulefiles}" "/")
configure_file(packaging/modulefile.in "${installed}/modulefile" @ONLY)
install(FILES "${installed}/modulefile" DESTINATION "${modulefiles}" RENAME "${Camaron_VERSION}")

# The command camaron is a Python program, too.
if (NOT CAMARON_WITH_PYTHON)
  return ()
endif ()
install(DIRECTORY Scripts/camaron DESTINATION "${CAMARON_PYTHON_DIR}" PATTERN "__pycache__" EXCLUDE)
file(RELATIVE_PATH plugin "/${CAMARON_PYTHON_DIR}/camaron" "/${CAMARON_PLUGINS_DIR}/Camaron/Camaron.so")
file(WRITE "${installed}/plugin" "${plugin}\n") # where the package finds the plugin in python3
install(FILES "${installed}/plugin" DESTINATION "${CAMARON_PYTHON_DIR}/camaron")
configure_file(Scripts/launcher/installed.sh.in "${installed}/installed.sh" @ONLY)
install(PROGRAMS camaron DESTINATION "${CAMARON_DATA_DIR}")
install(FILES Scripts/launcher/console.sh Scripts/launcher/trust.sh Scripts/launcher/build.sh
  "${installed}/installed.sh" DESTINATION "${CAMARON_DATA_DIR}/Scripts/launcher")
install(PROGRAMS Scripts/launcher/in-own-folder Scripts/launcher/with-display Scripts/launcher/with-ranks
  DESTINATION "${CAMARON_DATA_DIR}/Scripts/launcher")
file(RELATIVE_PATH link "/${CMAKE_INSTALL_BINDIR}" "/${CAMARON_DATA_DIR}/camaron")
file(CREATE_LINK "${link}" "${installed}/camaron" SYMBOLIC)
install(FILES "${installed}/camaron" DESTINATION "${CMAKE_INSTALL_BINDIR}")
