# How a folder becomes a target. One static library a folder, one test program a tested folder.

add_library(vamp_flags INTERFACE)
target_compile_features(vamp_flags INTERFACE cxx_std_20)
target_include_directories(vamp_flags INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(vamp_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  -Wno-missing-field-initializers -Werror
  # At -O3 GCC 12 takes the memory of a growing std::vector for null; the other presets keep the warning.
  $<$<NOT:$<CONFIG:Release>>:-Wnull-dereference>
  # And there it takes the empty half of a tl::expected for uninitialised.
  $<$<CONFIG:Release>:-Wno-maybe-uninitialized>
  # GCC 12 warns about overlaps inside its own std::string at -O3 (GCC bug 105329).
  -Wno-restrict
  # Same picture means same bits: no contraction into fma and no reassociation, on every machine.
  -ffp-contract=off)
target_compile_definitions(vamp_flags INTERFACE
  GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_FORCE_EXPLICIT_CTOR GLM_ENABLE_EXPERIMENTAL)

set(VAMP_SANITIZE "" CACHE STRING "Sanitizers, such as address,undefined or thread")
if(VAMP_SANITIZE)
  add_compile_options(-fsanitize=${VAMP_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${VAMP_SANITIZE})
endif()

# vamp_library(NAME SOURCES ... [LINKS ...]): the static library vamp_NAME from a folder's files.
function(vamp_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_library(vamp_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(vamp_${name} PUBLIC vamp_flags ${ARG_LINKS})
endfunction()

# vamp_test(NAME SOURCES ... [LINKS ...] [LABELS ...]): the test program test_NAME, one ctest entry per program.
# Tests run in the source folder, so that files of the repository are found by their relative path.
function(vamp_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LINKS;LABELS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 600)
  endif()
  add_executable(test_${name} ${ARG_SOURCES})
  target_link_libraries(test_${name} PRIVATE vamp_flags ${ARG_LINKS} GTest::gmock GTest::gtest GTest::gtest_main)
  add_test(NAME ${name} COMMAND test_${name} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}")
endfunction()
