# Sets CAMARON_FULL_VERSION, such as 0.1.0+3f2a9c1b2d, and CAMARON_PROVENANCE, a line about this build.
# The part after + is a hash of the plugin's sources when CMake configured: equal sources have equal
# versions, whether from git or a tarball. Included by the top-level CMakeLists.txt.
function (camaron_hash_sources result)
  set(files)
  foreach (folder IN ITEMS Core Filters Plugin Readers Representations)
    file(GLOB_RECURSE found RELATIVE "${Camaron_SOURCE_DIR}" "${Camaron_SOURCE_DIR}/${folder}/*")
    list(APPEND files ${found})
  endforeach ()
  list(FILTER files EXCLUDE REGEX "/Testing/|README\\.md$|~$")
  set(hashes)
  foreach (file IN LISTS files)
    file(SHA1 "${Camaron_SOURCE_DIR}/${file}" hash)
    string(APPEND hashes "${hash} ${file}\n")
  endforeach ()
  string(SHA1 hash "${hashes}")
  string(SUBSTRING "${hash}" 0 10 hash)
  set("${result}" "${hash}" PARENT_SCOPE)
endfunction ()

camaron_hash_sources(hash_of_sources)
set(CAMARON_FULL_VERSION "${Camaron_VERSION}+${hash_of_sources}")

set(CAMARON_PROVENANCE "camaron ${CAMARON_FULL_VERSION} for ParaView ${ParaView_VERSION}, built by \
${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}, ${CMAKE_BUILD_TYPE}")
if (CAMARON_WITH_QT)
  string(APPEND CAMARON_PROVENANCE ", Qt")
endif ()
if (CAMARON_WITH_PYTHON)
  string(APPEND CAMARON_PROVENANCE ", Python")
endif ()
if (PARAVIEW_USE_MPI)
  string(APPEND CAMARON_PROVENANCE ", MPI")
endif ()
