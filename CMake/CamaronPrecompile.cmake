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
