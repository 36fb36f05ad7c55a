# One program of libFuzzer for each target, and of the tools no more than the targets read with: the whole tree would take
# many times as long.
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tl-expected REQUIRED)
set(tools ${PROJECT_SOURCE_DIR}/tools)

# fuzzer(NAME SOURCES... LIBRARIES...)
function(fuzzer name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(fuzz_${name} libfuzzer_entry.cpp ${ARG_SOURCES})
  target_compile_options(fuzz_${name} PRIVATE ${COIF_WARNINGS})
  target_compile_definitions(fuzz_${name} PRIVATE COIF_FUZZ_TARGET=try_${name})
  target_include_directories(fuzz_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/runtime
                                                       ${PROJECT_SOURCE_DIR}/formats ${tools})
  target_link_libraries(fuzz_${name} PRIVATE tl::expected ${ARG_LIBRARIES})
  target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
endfunction()

# What several targets read with.
coif_tool_library(fuzz_gltf
  lone_file.cpp
  ${tools}/import/gltf_json.cpp
  ${tools}/import/json_values.cpp
  ${tools}/import/printable_text.cpp
  ${tools}/import/source_model_check.cpp)
target_include_directories(fuzz_gltf PRIVATE ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(fuzz_gltf PUBLIC Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json tl::expected)

set(write ${PROJECT_SOURCE_DIR}/formats/write)
fuzzer(asset
  SOURCES ${COIF_FUZZ_ASSET_SOURCES} asset_mutator.cpp ${write}/chunk_file.cpp ${write}/strip_asset.cpp
  LIBRARIES coif::sim coif::skinning coif::drawing)
fuzzer(cache_entry
  SOURCES cache_entry_target.cpp cache_entry_mutator.cpp ${tools}/pipeline/cache_entry.cpp
  LIBRARIES coif::formats Eigen3::Eigen nlohmann_json::nlohmann_json)
fuzzer(can_fail SOURCES can_fail_target.cpp)
fuzzer(clip
  SOURCES clip_target.cpp ${tools}/import/clip_file.cpp ${tools}/import/clip_node.cpp ${tools}/import/clip_track.cpp
          ${tools}/import/gltf_buffers.cpp ${tools}/import/gltf_numbers.cpp ${tools}/import/gltf_tree.cpp
          ${tools}/import/readable_file.cpp ${tools}/import/source_format.cpp
  LIBRARIES fuzz_gltf)
fuzzer(manifest
  SOURCES manifest_target.cpp ${tools}/pipeline/manifest.cpp ${tools}/files/file_bytes.cpp
  LIBRARIES fuzz_gltf)
fuzzer(model_stream SOURCES model_stream_target.cpp ${tools}/import/model_stream.cpp LIBRARIES fuzz_gltf)
fuzzer(recipe
  SOURCES recipe_target.cpp ${tools}/cook/nearest_word.cpp ${tools}/cook/recipe.cpp ${tools}/cook/recipe_keys.cpp
          ${tools}/cook/recipe_values.cpp
  LIBRARIES fmt::fmt nlohmann_json::nlohmann_json)
fuzzer(vrm
  SOURCES vrm_target.cpp ${tools}/import/gltf_nodes.cpp ${tools}/import/spring_sink.cpp ${tools}/import/vrm0_springs.cpp
          ${tools}/import/vrm1_springs.cpp ${tools}/import/vrm_springs.cpp
  LIBRARIES fuzz_gltf)

set(programs ${COIF_FUZZ_TARGETS} can_fail)
list(TRANSFORM programs PREPEND fuzz_)
add_custom_target(fuzzers DEPENDS ${programs})

set(COIF_FUZZ_SECONDS 10 CACHE STRING "Seconds that each target takes as a test")
set(work ${CMAKE_CURRENT_BINARY_DIR}/work)
foreach(target ${COIF_FUZZ_TARGETS})
  add_test(NAME fuzz.${target}
    COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/fuzz_one.sh $<TARGET_FILE:fuzz_${target}> ${COIF_FUZZ_SECONDS} ${work})
endforeach()
add_test(NAME fuzz.can_fail
  COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/can_fail.sh $<TARGET_FILE:fuzz_can_fail> ${work})

# What is written out for all lanes comes to functions that clang 14 takes many minutes to optimize once they are watched.
foreach(file coif_rows head_paths thesis_rows)
  set_source_files_properties(${PROJECT_SOURCE_DIR}/runtime/sim/lanes/${file}.cpp
    TARGET_DIRECTORY coif_sim PROPERTIES COMPILE_OPTIONS -O0)
endforeach()
