// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What the sanitizers of a program do if ASAN_OPTIONS and the like say nothing else. CMake
// names a program that finds places in the source, as clang's own is in a package that may not be
// there.

extern "C" const char* __asan_default_options()
{
  return "external_symbolizer_path=" CAMARON_SYMBOLIZER;
}
extern "C" const char* __tsan_default_options()
{
  return "external_symbolizer_path=" CAMARON_SYMBOLIZER;
}
// A thread may read a parallel loop of VTK after its last range, when VTK's caller, which waits
// where ThreadSanitizer does not see it, already uses that memory for the next one.
extern "C" const char* __tsan_default_suppressions()
{
  return "race:vtkSMPToolsAPI::SetBackend\n";
}
extern "C" const char* __ubsan_default_options()
{
  return "print_stacktrace=1";
}
