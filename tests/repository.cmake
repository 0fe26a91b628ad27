# What is checked about the repository itself: each check is a test, so that the tests' summary tells of all.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

foreach(check IN ITEMS format layering ledger)
  add_test(NAME repository/${check} COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_${check}.py)
endforeach()

# That the list of the constants on which proofs rest fits the sources; ./toccata test --all makes them too small.
add_test(NAME repository/proofs COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_proofs.py --check)

add_test(NAME repository/rooms COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/draw_rooms.py --check)

# The longest of these, and one compilation.
add_test(NAME repository/names COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_names.py --compiler ${CMAKE_CXX_COMPILER})
set_tests_properties(repository/names PROPERTIES COST 900)

# That examples of what may be added touch as few files as the map of the source says; --all also builds them.
add_test(NAME repository/recipes COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_recipes.py)

add_subdirectory(package)
add_test(NAME repository/docs COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_docs.py --compiler ${CMAKE_CXX_COMPILER}
                                      --prefix ${CMAKE_CURRENT_BINARY_DIR}/package/prefix)
set_tests_properties(repository/docs PROPERTIES FIXTURES_REQUIRED installed PROCESSORS 2 COST 1000)  # begun first: it is the longest

add_test(NAME repository/examples COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_examples.py
                                          --compiler ${CMAKE_CXX_COMPILER} --prefix ${CMAKE_CURRENT_BINARY_DIR}/package/prefix)
set_tests_properties(repository/examples PROPERTIES FIXTURES_REQUIRED installed PROCESSORS 2 COST 800)

# The Python package: a wheel compiled against the installed library, installed into a fresh environment, and thin slices
# of its tests there. Skipped, saying why, where there is no package index; --all has whole tests, and other Pythons. It is
# begun early, as it takes long, and compiles on one processor, so that other tests run beside it.
option(TOCCATA_TEST_PYTHON "Also build the Python package as a wheel, install it and test it there" OFF)
if(TOCCATA_TEST_PYTHON AND TOCCATA_BUILD_COMMAND AND NOT TOCCATA_SANITIZE)
  add_test(NAME python/wheel COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_wheel.py --slice
                                     --prefix ${CMAKE_CURRENT_BINARY_DIR}/package/prefix)
  set_tests_properties(python/wheel PROPERTIES FIXTURES_REQUIRED installed SKIP_RETURN_CODE 77 COST 950 TIMEOUT 1800
                       ENVIRONMENT "TOCCATA_COMMAND=$<TARGET_FILE:toccata_command>;TOCCATA_LIBRARY=$<TARGET_FILE:toccata>")
endif()

# Every header compiles alone: a unit that includes nothing else, for each public header but those that another includes
# before all others of the house, and which are thus alone there. A private one that is included before anything else by a
# source of the library needs none where that is compiled by itself, and the others have one there too; where sources are
# united only the public headers are looked at.
file(GLOB_RECURSE HEADERS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/*.hpp)
foreach(header IN LISTS HEADERS)
  file(STRINGS ${header} first REGEX "^#include \"" LIMIT_COUNT 1)
  list(APPEND INCLUDED_FIRST ${first})
endforeach()
if(NOT TOCCATA_UNITE)
  file(GLOB LIBRARY_SOURCES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*/*.cpp ${PROJECT_SOURCE_DIR}/src/*/*/*.cpp ${PROJECT_SOURCE_DIR}/src/*/*/*/*.cpp)
  foreach(source IN LISTS LIBRARY_SOURCES)
    file(STRINGS ${source} first REGEX "^#include" LIMIT_COUNT 1)
    list(APPEND INCLUDED_FIRST ${first})
  endforeach()
  file(GLOB_RECURSE PRIVATE_HEADERS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*.hpp)
  list(APPEND HEADERS ${PRIVATE_HEADERS})
endif()
foreach(header IN LISTS HEADERS)
  string(REGEX REPLACE "^${PROJECT_SOURCE_DIR}/(include|src)/" "" name ${header})
  if("#include \"${name}\"" IN_LIST INCLUDED_FIRST)
    continue()
  endif()
  string(MAKE_C_IDENTIFIER ${name} unit)
  file(CONFIGURE OUTPUT headers/${unit}.cpp CONTENT "#include \"@name@\"\n" @ONLY)
  list(APPEND HEADER_UNITS ${CMAKE_CURRENT_BINARY_DIR}/headers/${unit}.cpp)
endforeach()
add_library(toccata_headers_alone OBJECT ${HEADER_UNITS})
target_include_directories(toccata_headers_alone PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
target_compile_options(toccata_headers_alone PRIVATE -O0)
target_link_libraries(toccata_headers_alone PRIVATE toccata_test_flags)
target_compile_features(toccata_headers_alone PRIVATE cxx_std_20)
# Most of what such a unit costs is the standard library. That none of its headers is forgotten is seen by
# tools/check_layering.py, and where sources are not united.
if(TOCCATA_UNITE)
  target_precompile_headers(toccata_headers_alone PRIVATE <algorithm> <array> <cmath> <compare> <concepts> <cstddef> <cstdint> <filesystem>
                            <functional> <initializer_list> <limits> <map> <memory> <optional> <span> <stdexcept> <string> <string_view>
                            <tuple> <type_traits> <utility> <variant> <vector>)
endif()
