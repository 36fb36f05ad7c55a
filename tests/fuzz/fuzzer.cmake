# One program of libFuzzer for all targets, and of the tools no more than they read with: the importer library and what
# cooks would take many times as long.
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tl-expected REQUIRED)

set(tools ${PROJECT_SOURCE_DIR}/tools)
file(GLOB readers CONFIGURE_DEPENDS ${tools}/base/*.cpp ${tools}/cook/recipe/*.cpp ${tools}/import/clip*.cpp
  ${tools}/groom/groom*.cpp ${tools}/groom/*_file.cpp ${tools}/groom/*_lines.cpp ${tools}/import/gltf*.cpp ${tools}/import/model_stream.cpp ${tools}/import/source_*.cpp ${tools}/import/vrm*.cpp)
add_executable(fuzz_readers libfuzzer_main.cpp ${targets} ${readers} ${tools}/cache/cache_entry.cpp
  ${tools}/cache/manifest.cpp)
target_compile_options(fuzz_readers PRIVATE ${COIF_WARNINGS})
target_include_directories(fuzz_readers PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/runtime
                                                ${PROJECT_SOURCE_DIR}/formats ${tools})
target_link_libraries(fuzz_readers PRIVATE coif_formats_write coif::sim coif::skinning coif::drawing Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json
                                           tl::expected)
target_link_options(fuzz_readers PRIVATE -fsanitize=fuzzer)

# The readers of strands by themselves: what they read with is compiled in a minute, the whole in a quarter of an hour.
file(GLOB strand_readers CONFIGURE_DEPENDS ${tools}/groom/groom*.cpp ${tools}/groom/*_file.cpp ${tools}/groom/*_lines.cpp
  ${tools}/import/gltf_buffers.cpp ${tools}/import/gltf_document.cpp ${tools}/import/source_file.cpp ${tools}/import/source_model.cpp)
add_executable(fuzz_strands libfuzzer_strands.cpp strand_table.cpp promises.cpp groom_targets.cpp ${strand_readers}
  ${tools}/base/encodings.cpp ${tools}/base/files.cpp ${tools}/base/glb_file.cpp ${tools}/base/json.cpp ${tools}/base/text.cpp)
target_compile_options(fuzz_strands PRIVATE ${COIF_WARNINGS})
target_include_directories(fuzz_strands PRIVATE ${PROJECT_SOURCE_DIR}/tests ${tools})
target_link_libraries(fuzz_strands PRIVATE coif_formats Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json tl::expected)
target_link_options(fuzz_strands PRIVATE -fsanitize=fuzzer)

set(COIF_FUZZ_SECONDS 10 CACHE STRING "Seconds that each target takes as a test")
set(work ${CMAKE_CURRENT_BINARY_DIR}/work)
foreach(target ${COIF_FUZZ_TARGETS})
  add_test(NAME fuzz.${target}
    COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/fuzz_one.sh $<TARGET_FILE:fuzz_readers> ${target} ${COIF_FUZZ_SECONDS} ${work})
endforeach()
add_test(NAME fuzz.can_fail
  COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/can_fail.sh $<TARGET_FILE:fuzz_readers> ${work})

# What is written out for all lanes comes to functions that clang 14 takes many minutes to optimize once they are watched.
foreach(file coif_rows head_paths passive_rows thesis_rows)
  set_source_files_properties(${PROJECT_SOURCE_DIR}/runtime/sim/lanes/${file}.cpp
    TARGET_DIRECTORY coif_sim PROPERTIES COMPILE_OPTIONS -O0)
endforeach()
