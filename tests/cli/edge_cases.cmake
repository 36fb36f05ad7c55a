# Outputs that are inputs, streams that take nothing, limits, long names, kernels without a fence.
foreach(case inputs_are_never_written_over messages_change_no_result limits_hold_from_the_start streams_and_names_at_their_edges
             strangers_recipes_stay_in_their_folder machines_without_a_sandbox)
  add_test(NAME cli.edges.${case}
    COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/edges.py ${case} $<TARGET_FILE:coif_cli>
            ${CMAKE_CURRENT_BINARY_DIR}/edges_${case})
  set_tests_properties(cli.edges.${case} PROPERTIES TIMEOUT 180 SKIP_REGULAR_EXPRESSION "skipped:")
endforeach()
