# Compiles the files of a target in fewer, larger pieces (CMake's "unity build"): what a file costs is mostly its headers.
# No two files of a target name two things alike (tools/check_names.py), so any of them may share a piece. Files that
# Highway compiles once for each SIMD level stay alone.
set(TOCCATA_PIECE_BYTES 90000 CACHE STRING "How much source a united piece holds at most")

# toccata_unite(TARGET FILE…): the files in their order by folder, cut where a piece is full.
function(toccata_unite target)
  set(piece 0)
  set(filled 0)
  list(SORT ARGN)
  foreach(file IN LISTS ARGN)
    file(STRINGS ${file} of_every_level REGEX "^#include <hwy/foreach_target.h>" LIMIT_COUNT 1)
    if(of_every_level)
      continue()
    endif()
    file(SIZE ${file} bytes)
    math(EXPR filled "${filled} + ${bytes}")
    if(filled GREATER TOCCATA_PIECE_BYTES)
      math(EXPR piece "${piece} + 1")
      set(filled ${bytes})
    endif()
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${piece})
  endforeach()
  # g++ tidies its memory up a tenth of its time when it may not take more.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=500000>)
  # A local name may hide another file's; a class that one file alone knows may have its own file's types as members.
  set(needless "#pragma GCC diagnostic ignored \"-Wshadow\"")
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)  # clang has no such warning
    string(APPEND needless "\n#pragma GCC diagnostic ignored \"-Wsubobject-linkage\"")
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP UNITY_BUILD_CODE_BEFORE_INCLUDE "${needless}")
endfunction()
