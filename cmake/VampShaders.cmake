# GLSL to SPIR-V at build time, with exact dependencies.

find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)

# vamp_shaders(TARGET PASSES a.comp ... [RAY_QUERY_PASSES a.comp ...]): compiles each pass with glslang and links the words
# into the library TARGET as `std::span<const uint32_t> vamp::spirv::NAME()` (header shaders/spirv.h, in the folder TARGET
# of the build). A pass that traces rays can be there a second time, as NAME_ray_query(), which has the device trace them: a
# capability of SPIR-V, which no constant can take away.
function(vamp_shaders target)
  cmake_parse_arguments(ARG "" "" "PASSES;RAY_QUERY_PASSES" ${ARGN})
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${target})
  file(MAKE_DIRECTORY ${out}/shaders)
  set(header "#pragma once\n// The program's kernels as SPIR-V words. Made by cmake/VampShaders.cmake.\n#include <cstdint>\n#include <span>\nnamespace vamp::spirv {\n")
  set(source "#include \"shaders/spirv.h\"\nnamespace vamp::spirv {\n")
  set(objects "")
  foreach(kind PASSES RAY_QUERY_PASSES)
    foreach(pass ${ARG_${kind}})
      get_filename_component(stem ${pass} NAME)
      string(REPLACE "." "_" stem ${stem})
      set(defines "")
      if(kind STREQUAL RAY_QUERY_PASSES)
        string(APPEND stem _ray_query)
        set(defines -DRAY_QUERY)
      endif()
      cmake_path(ABSOLUTE_PATH pass BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
      set(inc ${out}/${stem}.inc)
      add_custom_command(OUTPUT ${inc}
        COMMAND ${GLSLANG_VALIDATOR} -V --target-env vulkan1.2 --quiet -x -o ${inc} --depfile ${inc}.d
                -I${CMAKE_SOURCE_DIR} ${defines} ${pass}
        DEPENDS ${pass} DEPFILE ${inc}.d
        COMMENT "glslang ${stem}" VERBATIM)
      list(APPEND objects ${inc})
      string(APPEND header "std::span<const uint32_t> ${stem}();\n")
      string(APPEND source "static const uint32_t ${stem}_words[] = {\n#include \"${inc}\"\n};\nstd::span<const uint32_t> ${stem}() { return ${stem}_words; }\n")
    endforeach()
  endforeach()
  string(APPEND header "}  // namespace vamp::spirv\n")
  string(APPEND source "}  // namespace vamp::spirv\n")
  file(CONFIGURE OUTPUT ${out}/shaders/spirv.h CONTENT "${header}" @ONLY)
  file(CONFIGURE OUTPUT ${out}/spirv.cpp CONTENT "${source}" @ONLY)
  set_source_files_properties(${out}/spirv.cpp PROPERTIES OBJECT_DEPENDS "${objects}")
  add_library(${target} STATIC ${out}/spirv.cpp ${objects})
  target_link_libraries(${target} PUBLIC vamp_flags)
  target_include_directories(${target} PUBLIC ${out})
endfunction()
