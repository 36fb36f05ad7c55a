# The package as a game sees it; the guards measure what these tests leave. Not under sanitizers: a game that links such an archive must be built with them too.
function(coif_consumer_test name)
  add_test(NAME consumer.${name}
    COMMAND ${CMAKE_COMMAND} -D WORK=${CMAKE_BINARY_DIR}/consumer/${name} ${ARGN}
            -P ${PROJECT_SOURCE_DIR}/tests/consumer/consume.cmake)
  set_tests_properties(consumer.${name} PROPERTIES TIMEOUT 900)
endfunction()

coif_consumer_test(sim_only -D SOURCE=${PROJECT_SOURCE_DIR})
set_tests_properties(consumer.sim_only PROPERTIES FIXTURES_SETUP COIF_SIM_ONLY_PACKAGE)
coif_consumer_test(embedded -D EMBED=${PROJECT_SOURCE_DIR})
if(TARGET coif_cli)
  coif_consumer_test(shared -D SHARE=${PROJECT_SOURCE_DIR} -D GL=${COIF_GL} -D SIMD=${COIF_SIMD}
    -D ASSET=${CMAKE_BINARY_DIR}/sample/bob.coif)
  set_tests_properties(consumer.shared PROPERTIES FIXTURES_REQUIRED COIF_COOKED_SAMPLE)
else()
  coif_consumer_test(shared -D SHARE=${PROJECT_SOURCE_DIR} -D GL=${COIF_GL} -D SIMD=${COIF_SIMD})
endif()
set_tests_properties(consumer.shared PROPERTIES FIXTURES_SETUP COIF_SHARED_PACKAGE)
if(TARGET coif_cli)
  coif_consumer_test(installed
    -D BUILD=${CMAKE_BINARY_DIR} -D SIMD=${COIF_SIMD} -D SHARED=${BUILD_SHARED_LIBS} -D ASSET=${CMAKE_BINARY_DIR}/sample/bob.coif)
  set_tests_properties(consumer.installed PROPERTIES
    FIXTURES_REQUIRED COIF_COOKED_SAMPLE FIXTURES_SETUP COIF_WHOLE_PACKAGE)
  coif_consumer_test(deb_package -D PACK=${CMAKE_BINARY_DIR}
    -D CMAKE_CPACK_COMMAND=${CMAKE_CPACK_COMMAND} -D ASSET=${CMAKE_BINARY_DIR}/sample/bob.coif)
  set_tests_properties(consumer.deb_package PROPERTIES FIXTURES_REQUIRED COIF_COOKED_SAMPLE)
endif()
if(TARGET coif_cli)
  add_test(NAME consumer.recook
    COMMAND ${CMAKE_COMMAND} -D PREFIX=${CMAKE_BINARY_DIR}/consumer/installed/installed -D PROJECT=${PROJECT_SOURCE_DIR}
            -D WORK=${CMAKE_BINARY_DIR}/consumer/recook -P ${PROJECT_SOURCE_DIR}/tests/consumer/recook.cmake)
  set_tests_properties(consumer.recook PROPERTIES FIXTURES_REQUIRED COIF_WHOLE_PACKAGE TIMEOUT 900)
endif()
