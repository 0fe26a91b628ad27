# Flags for everything this project compiles; not passed on to users of the library. A tenth of the time of g++ goes into
# warnings: who only wants the command does without, the tests and what they check have them always.
function(toccata_flags target warnings)
  add_library(${target} INTERFACE)
  # The truth is arithmetic without fused multiply-add: g++ contracts by default.
  target_compile_options(${target} INTERFACE -ffp-contract=off)
  if(NOT warnings)
    target_compile_options(${target} INTERFACE -w)
    return()
  endif()
  target_compile_options(${target} INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast)
  if(TOCCATA_WARNINGS_AS_ERRORS)
    target_compile_options(${target} INTERFACE -Werror)
  endif()
  # What the sanitizers put in between makes g++ doubt values that it knows to be set where it optimises for real.
  if(TOCCATA_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} INTERFACE -Wno-maybe-uninitialized)
  endif()
endfunction()
toccata_flags(toccata_build_flags ${TOCCATA_WARNINGS})
toccata_flags(toccata_test_flags ON)

# These options are those of the folder, and so stand in front of a target's own options, so that these may take checks back.
if(TOCCATA_SANITIZE)
  # The assertions find what sanitizers do not: the value of an optional that has none.
  add_compile_options(-fsanitize=${TOCCATA_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -D_GLIBCXX_ASSERTIONS)
  add_link_options(-fsanitize=${TOCCATA_SANITIZE})
  # As g++ tells the sources; clang 14 does not.
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    foreach(kind IN ITEMS address thread)
      if(TOCCATA_SANITIZE MATCHES ${kind})
        string(TOUPPER ${kind} name)
        add_compile_definitions(__SANITIZE_${name}__)
      endif()
    endforeach()
  endif()
endif()

# toccata_sanitize(TARGET): this target alone, under the address sanitizer and those checks of undefined behaviour that do
# not double the time of its compilation. What watches the life of each variable takes a third of it. The others are left to
# the preset asan-ubsan, but for files that are compiled for every SIMD level.
set(TOCCATA_QUICK_CHECKS -D_GLIBCXX_ASSERTIONS -fsanitize=address,undefined -fno-sanitize=alignment,null,object-size,pointer-overflow,vptr -fno-sanitize-address-use-after-scope -fno-sanitize-recover=all)
function(toccata_sanitize target)
  target_compile_options(${target} PRIVATE -O1 -g1 ${TOCCATA_QUICK_CHECKS} -fno-omit-frame-pointer -Wno-maybe-uninitialized)
  target_link_options(${target} PRIVATE ${TOCCATA_QUICK_CHECKS})
endfunction()
