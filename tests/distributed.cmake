find_package(Python3 REQUIRED COMPONENTS Interpreter)

# The room `distributed` is tested by programs that mpirun starts several times, more often than there are cores too.
file(GLOB RANK_TESTS CONFIGURE_DEPENDS distributed/*.cpp)
add_library(tests_distributed OBJECT ${RANK_TESTS})
target_include_directories(tests_distributed PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(tests_distributed PUBLIC toccata_test_support MPI::MPI_CXX)
target_compile_options(tests_distributed PRIVATE ${TOCCATA_TEST_OPTIONS})
if(TOCCATA_UNITE)
  toccata_unite(tests_distributed ${RANK_TESTS})
  target_precompile_headers(tests_distributed REUSE_FROM toccata_test_main)
  target_compile_options(tests_distributed PRIVATE $<$<CXX_COMPILER_ID:GNU>:${OPTIMISER_WARNINGS}>)
endif()

# Root may run it (as in a container), ranks may share cores, and do not keep them busy while they wait.
set(MPI_SETTINGS OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
                 OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_btl_vader_single_copy_mechanism=none)

# toccata_rank_tests(PROGRAM NAME RANKS…)
function(toccata_rank_tests program name)
  foreach(ranks IN LISTS ARGN)
    add_test(NAME distributed/${name}${ranks} COMMAND ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks} $<TARGET_FILE:${program}> --gtest_brief=1)
    # Open MPI keeps what it allocates once; the leaks of the library are found by the other rooms' tests.
    set_tests_properties(distributed/${name}${ranks} PROPERTIES ENVIRONMENT "${MPI_SETTINGS};ASAN_OPTIONS=detect_leaks=0" PROCESSORS 2 COST 300 TIMEOUT 1200)
  endforeach()
endfunction()

set(TOCCATA_TEST_RANKS 1 2 3 5 8 CACHE STRING "On how many ranks the tests of the room distributed are run")
add_executable(test_distributed)
target_link_libraries(test_distributed PRIVATE tests_distributed toccata_test_support Toccata::distributed)
toccata_rank_tests(test_distributed ranks- ${TOCCATA_TEST_RANKS})
if(TOCCATA_TEST_SANITIZED AND TOCCATA_TEST_RANKS_SANITIZED)
  add_executable(test_distributed_sanitized)
  target_link_libraries(test_distributed_sanitized PRIVATE tests_distributed toccata_test_support toccata_distributed_sanitized)
  target_link_options(test_distributed_sanitized PRIVATE ${TOCCATA_QUICK_CHECKS})
  toccata_rank_tests(test_distributed_sanitized sanitized- 2)
endif()
if(TARGET toccata_bench_ranks)
  add_test(NAME distributed/crowds COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/distributed/check_crowds.py ${MPIEXEC_EXECUTABLE}
                                           $<TARGET_FILE:toccata_crowd_ranks> $<TARGET_FILE:toccata_bench_ranks> $<TARGET_FILE:toccata_command>)
  set_tests_properties(distributed/crowds PROPERTIES ENVIRONMENT "${MPI_SETTINGS}" PROCESSORS 2)
endif()
if(TARGET toccata_check_ranks)
  foreach(ranks IN LISTS TOCCATA_TEST_RANKS)
    add_test(NAME distributed/check-${ranks} COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/distributed/check_ranks.py ${MPIEXEC_EXECUTABLE} ${ranks}
                                                     $<TARGET_FILE:toccata_command> $<TARGET_FILE:toccata_check_ranks>)
    set_tests_properties(distributed/check-${ranks} PROPERTIES ENVIRONMENT "${MPI_SETTINGS}" PROCESSORS 2)
  endforeach()
endif()
