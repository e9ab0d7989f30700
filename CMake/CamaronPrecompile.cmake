# camaron_precompile(TARGET HEADER...): precompiles headers that many sources of a target include, and the standard
# library, which halves the time to build it. Every source still includes what it uses, so -DCAMARON_PRECOMPILE=OFF
# builds, too. Included by the top-level CMakeLists.txt.
option(CAMARON_PRECOMPILE "Precompile headers" ON)
mark_as_advanced(CAMARON_PRECOMPILE)

set(CAMARON_VTK_HEADERS
  vtkCellArray.h vtkCellData.h vtkDataSetAttributes.h vtkDoubleArray.h vtkFieldData.h vtkFloatArray.h vtkIdTypeArray.h
  vtkIntArray.h vtkNew.h vtkPointData.h vtkPoints.h vtkPolyData.h vtkSMPTools.h vtkSmartPointer.h vtkStringArray.h
  vtkUnsignedCharArray.h vtkUnstructuredGrid.h)

function (camaron_precompile target)
  set(headers algorithm array atomic cmath cstdint cstring functional limits map memory mutex numeric optional sstream
    string string_view tuple unordered_map utility vector ${ARGN})
  if (CAMARON_PRECOMPILE)
    list(TRANSFORM headers REPLACE "(.+)" "<\\1>")
    target_precompile_headers("${target}" PRIVATE ${headers})
  endif ()
endfunction ()

# For compiler caches: gcc tells them which precompiled headers it has read.
if (CAMARON_PRECOMPILE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>")
endif ()

# camaron_batches(TARGET [SIZE]): compiles the sources of each of a target's folders as one, or so many in a row, which saves
# a third of the time to build it. Names in unnamed namespaces are unique in a folder, and every source still includes what
# it uses, so -DCAMARON_BATCHES=OFF, for those who change the same sources again and again, builds, too.
option(CAMARON_BATCHES "Compile the sources of a folder together" ON)
mark_as_advanced(CAMARON_BATCHES)

function (camaron_batches target)
  if (NOT CAMARON_BATCHES)
    return ()
  endif ()
  set_target_properties("${target}" PROPERTIES UNITY_BUILD ON)
  if (ARGC GREATER 1)
    set_target_properties("${target}" PROPERTIES UNITY_BUILD_BATCH_SIZE "${ARGV1}")
    return ()
  endif ()
  set_target_properties("${target}" PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources "${target}" SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cxx$")
  foreach (source IN LISTS sources)
    string(FIND "${source}" "${CMAKE_BINARY_DIR}/" place)
    if (place EQUAL 0) # generated
      continue ()
    endif ()
    string(REPLACE "${CMAKE_CURRENT_SOURCE_DIR}/" "" path "${source}")
    get_filename_component(folder "${path}" DIRECTORY)
    string(MAKE_C_IDENTIFIER "in ${folder}" group)
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}")
  endforeach ()
endfunction ()
