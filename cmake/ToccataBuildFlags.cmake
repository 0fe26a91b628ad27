# Flags for everything this project compiles; not passed on to users of the library.
add_library(toccata_build_flags INTERFACE)

# The truth is arithmetic without fused multiply-add: g++ contracts by default.
target_compile_options(toccata_build_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                       -Wnon-virtual-dtor -Wold-style-cast)
if(TOCCATA_WARNINGS_AS_ERRORS)
  target_compile_options(toccata_build_flags INTERFACE -Werror)
endif()
if(TOCCATA_SANITIZE)
  target_compile_options(toccata_build_flags INTERFACE -fsanitize=${TOCCATA_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(toccata_build_flags INTERFACE -fsanitize=${TOCCATA_SANITIZE})
endif()
