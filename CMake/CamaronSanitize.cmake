# What CAMARON_SANITIZE means: everything of ours is built with AddressSanitizer and
# UndefinedBehaviorSanitizer, ready to be linked with libFuzzer; any finding ends the program.
# Included by the top CMakeLists.txt. ParaView's libraries stay as they are.
if (NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "CAMARON_SANITIZE needs clang: -DCMAKE_CXX_COMPILER=clang++")
endif ()

set(CAMARON_SANITIZERS "address,undefined,float-cast-overflow")
# Whether a check of the vptr is in its cache depends on addresses, and libFuzzer would follow that: with
# the same seed it would try other files every time.
add_compile_options(
  "-fsanitize=${CAMARON_SANITIZERS},fuzzer-no-link" -fno-sanitize=vptr -fno-sanitize-recover=all
  -fno-omit-frame-pointer -O1 -gline-tables-only -gdwarf-4) # which addr2line reads
add_link_options("-fsanitize=${CAMARON_SANITIZERS}")
add_compile_definitions(
  __SANITIZE_ADDRESS__=1 # which gcc and newer clang define themselves
  _GLIBCXX_ASSERTIONS)   # of std::vector's [] and the like

find_program(CAMARON_SYMBOLIZER NAMES llvm-symbolizer addr2line)
mark_as_advanced(CAMARON_SYMBOLIZER)
add_compile_definitions("CAMARON_SYMBOLIZER=\"$<$<BOOL:${CAMARON_SYMBOLIZER}>:${CAMARON_SYMBOLIZER}>\"")
