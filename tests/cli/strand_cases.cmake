# Strands instead of strips.
foreach(case every_format_gives_the_same_hair maps_of_strands_are_as_wide_as_colours the_budget_is_kept_and_cooks_repeat bad_files_are_refused_and_leave_what_was_there)
  add_test(NAME cli.cook_strands.${case}
    COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/cook_strands.py ${case} $<TARGET_FILE:coif_cli>
            ${CMAKE_CURRENT_BINARY_DIR}/cook_strands_${case})
  set_tests_properties(cli.cook_strands.${case} PROPERTIES TIMEOUT 180)
endforeach()

# Strands that a recipe grows.
foreach(case strands_are_written_and_cooked a_recipe_is_a_source_and_names_its_body what_cannot_grow_is_refused)
  add_test(NAME cli.grow_hair.${case}
    COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/grow_hair.py ${case} $<TARGET_FILE:coif_cli>
            ${CMAKE_CURRENT_BINARY_DIR}/grow_hair_${case})
  set_tests_properties(cli.grow_hair.${case} PROPERTIES TIMEOUT 180)
endforeach()

# How far cards are from them.
add_test(NAME cli.report_cards
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/report_cards.py $<TARGET_FILE:coif_cli> ${CMAKE_CURRENT_BINARY_DIR}/report_cards)
set_tests_properties(cli.report_cards PROPERTIES TIMEOUT 600)
add_test(NAME cli.report_pictures
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/report_pictures.py $<TARGET_FILE:coif_cli> ${COIF_COOKED_SAMPLE} ${CMAKE_CURRENT_BINARY_DIR}/report_pictures)
set_tests_properties(cli.report_pictures PROPERTIES TIMEOUT 120 FIXTURES_REQUIRED COIF_COOKED_SAMPLE)
