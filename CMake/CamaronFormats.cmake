# camaron_format: declares one mesh format; called only in Readers/Formats.cmake.
#
#   camaron_format(
#     NAME        Visf                         # its folder, and stem of its classes and XML files
#     EXTENSIONS  visf                         # without the dot; several allowed; readers also take visf.gz
#     DESCRIPTION "Camarón Visf mesh"          # for users
#     READS       "every dialect"              # variants it reads and writes, for the table of formats
#     WRITES      "ASCII and binary"
#     LABEL       "Foo Bar"                    # of its reader in ParaView, without "Reader", if it is not NAME
#     REPRESENTATION "Mesh Inspection"         # that shows what is read first, if it is not ParaView's default
#     READER_PROXY FooReader                   # the proxy of its reader, if it is not <NAME>Reader
#     BASE        vtkFluentReader              # the base class of its reader, if it is not vtkMeshFileReader
#     REQUIRES    VTK::foo                     # modules of ParaView that it uses; without them, the format is left out
#     READER                                   # Readers/Visf/ has VisfReading.cxx and VisfReader.xml
#     WRITER)                                  # Readers/Visf/ has vtkVisfWriter.{h,cxx} and VisfWriter.xml
#
# The calls set CAMARON_FORMATS (all names), CAMARON_FORMATS_REQUIRE (modules),
# CAMARON_FORMATS_OF_LIBRARIES (names of those that require some, which read the bytes of files), CAMARON_READERS and CAMARON_WRITERS (names of formats
# with a reader or a writer), CAMARON_FORMAT_<NAME>_EXTENSIONS, _DESCRIPTION, _LABEL and _REPRESENTATION
# per format, and CAMARON_FORMATS_JSON, one JSON object per format; scripts read it from
# formats.json next to the plugin.
set(CAMARON_FORMATS)
set(CAMARON_FORMATS_REQUIRE)
set(CAMARON_FORMATS_OF_LIBRARIES)
set(CAMARON_READERS)
set(CAMARON_WRITERS)
set(CAMARON_FORMATS_JSON)
function (camaron_format)
  cmake_parse_arguments(PARSE_ARGV 0 format "READER;WRITER" "NAME;LABEL;DESCRIPTION;READS;WRITES;READER_PROXY;REPRESENTATION;BASE" "EXTENSIONS;REQUIRES")
  if (format_UNPARSED_ARGUMENTS OR NOT format_NAME OR NOT format_EXTENSIONS OR NOT format_DESCRIPTION)
    message(FATAL_ERROR "camaron_format needs NAME, EXTENSIONS and DESCRIPTION; "
      "not understood: ${format_UNPARSED_ARGUMENTS}")
  endif ()
  foreach (module IN LISTS format_REQUIRES)
    if (NOT TARGET "${module}")
      message(STATUS "Camaron: without the format ${format_NAME}, as this ParaView has no ${module}")
      return ()
    endif ()
  endforeach ()
  list(APPEND CAMARON_FORMATS_REQUIRE ${format_REQUIRES})
  if (format_REQUIRES)
    list(APPEND CAMARON_FORMATS_OF_LIBRARIES "${format_NAME}")
  endif ()
  list(APPEND CAMARON_FORMATS "${format_NAME}")
  if (format_READER)
    list(APPEND CAMARON_READERS "${format_NAME}")
  endif ()
  if (format_WRITER)
    list(APPEND CAMARON_WRITERS "${format_NAME}")
  endif ()
  foreach (name IN ITEMS CAMARON_FORMATS CAMARON_FORMATS_REQUIRE CAMARON_FORMATS_OF_LIBRARIES CAMARON_READERS CAMARON_WRITERS)
    set("${name}" "${${name}}" PARENT_SCOPE)
  endforeach ()
  set("CAMARON_FORMAT_${format_NAME}_EXTENSIONS" "${format_EXTENSIONS}" PARENT_SCOPE)
  if (NOT format_LABEL)
    set(format_LABEL "${format_NAME}")
  endif ()
  if (NOT format_BASE)
    set(format_BASE vtkMeshFileReader)
  endif ()
  foreach (field IN ITEMS DESCRIPTION LABEL REPRESENTATION BASE)
    set("CAMARON_FORMAT_${format_NAME}_${field}" "${format_${field}}" PARENT_SCOPE)
  endforeach ()

  # string(JSON) needs CMake 3.19.
  set(fields "\"name\": \"${format_NAME}\"")
  foreach (key IN ITEMS DESCRIPTION READS WRITES)
    string(TOLOWER "${key}" lower)
    string(REPLACE "\\" "\\\\" value "${format_${key}}")
    string(REPLACE "\"" "\\\"" value "${value}")
    string(APPEND fields ", \"${lower}\": \"${value}\"")
  endforeach ()
  list(JOIN format_EXTENSIONS "\", \"" extensions)
  string(APPEND fields ", \"extensions\": [\"${extensions}\"]")
  set(reader null)
  set(writer null)
  if (format_READER_PROXY)
    set(reader "\"${format_READER_PROXY}\"")
  elseif (format_READER)
    set(reader "\"${format_NAME}Reader\"")
  endif ()
  if (format_WRITER)
    set(writer "\"${format_NAME}Writer\"")
  endif ()
  string(APPEND fields ", \"reader\": ${reader}, \"writer\": ${writer}")
  if (CAMARON_FORMATS_JSON)
    string(APPEND CAMARON_FORMATS_JSON ",\n") # not a list: texts may contain semicolons
  endif ()
  string(APPEND CAMARON_FORMATS_JSON "{${fields}}")
  set(CAMARON_FORMATS_JSON "${CAMARON_FORMATS_JSON}" PARENT_SCOPE)
endfunction ()
