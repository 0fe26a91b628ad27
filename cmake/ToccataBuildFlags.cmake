# Flags for everything this project compiles; not passed on to users of the library.
add_library(toccata_build_flags INTERFACE)

# The truth is arithmetic without fused multiply-add: g++ contracts by default.
target_compile_options(toccata_build_flags INTERFACE -ffp-contract=off)
# A tenth of the time of g++ goes into warnings. Who only wants the command does without; all builds of developers and of
# the tests but one have them.
if(TOCCATA_WARNINGS)
  target_compile_options(toccata_build_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast)
else()
  target_compile_options(toccata_build_flags INTERFACE -w)
endif()
if(TOCCATA_WARNINGS AND TOCCATA_WARNINGS_AS_ERRORS)
  target_compile_options(toccata_build_flags INTERFACE -Werror)
endif()
# Of the folder, thus in front of a target's own options, so that these may take checks back.
if(TOCCATA_SANITIZE)
  add_compile_options(-fsanitize=${TOCCATA_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  if(TOCCATA_NO_SANITIZE)
    add_compile_options(-fno-sanitize=${TOCCATA_NO_SANITIZE})
  endif()
  # What the checks put in between makes g++ doubt values that it knows to be set where it optimises for real.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(toccata_build_flags INTERFACE -Wno-maybe-uninitialized)
  endif()
  add_link_options(-fsanitize=${TOCCATA_SANITIZE})
endif()
