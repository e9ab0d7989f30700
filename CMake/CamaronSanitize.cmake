# Implements CAMARON_SANITIZE: builds all of Camarón with AddressSanitizer and UndefinedBehaviorSanitizer (address),
# ready for linking with libFuzzer, or with ThreadSanitizer (thread); any finding ends the program.
# ParaView's libraries are not instrumented. Included by the top-level CMakeLists.txt.
if (NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "CAMARON_SANITIZE needs clang: -DCMAKE_CXX_COMPILER=clang++")
endif ()

if (CAMARON_SANITIZE STREQUAL "thread")
  set(sanitizers "thread")
  add_compile_options("-fsanitize=${sanitizers}")
else ()
  set(sanitizers "address,undefined,float-cast-overflow")
  # No vptr checks: their cache depends on addresses, and libFuzzer would treat its hits as coverage,
  # so that runs with the same seed would try different files. What null, object-size and pointer-overflow find,
  # AddressSanitizer finds mostly, too, where such a pointer is used; without them the compiler takes a quarter less time
  # and inlines operator[] of std::vector.
  set(not_sanitized "vptr,null,object-size,pointer-overflow")
  add_compile_options(
    "-fsanitize=${sanitizers},fuzzer-no-link" "-fno-sanitize=${not_sanitized}" -fno-sanitize-recover=all)
  add_compile_definitions(__SANITIZE_ADDRESS__=1) # gcc and newer clang define it themselves
endif ()
add_compile_options(-fno-omit-frame-pointer -O1 -gline-tables-only -gdwarf-4) # for addr2line
add_link_options("-fsanitize=${sanitizers}")
add_compile_definitions(_GLIBCXX_ASSERTIONS) # checks operator[] of std::vector and others

find_program(CAMARON_SYMBOLIZER NAMES llvm-symbolizer addr2line)
mark_as_advanced(CAMARON_SYMBOLIZER)
add_compile_definitions("CAMARON_SYMBOLIZER=\"$<$<BOOL:${CAMARON_SYMBOLIZER}>:${CAMARON_SYMBOLIZER}>\"")
