# `coif view` of a source, which runs until somebody ends it.
foreach(case sliders_cook_at_once files_are_watched a_recipe_grows_hair killed_in_mid_cook_leaves_nothing ends_soon_in_mid_cook outlives_its_cooks)
  add_test(NAME cli.live_view.${case}
    COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/live_view.py ${case} $<TARGET_FILE:coif_cli> ${sample}
            ${CMAKE_CURRENT_BINARY_DIR}/live_view_${case})
  set_tests_properties(cli.live_view.${case} PROPERTIES TIMEOUT 180)
endforeach()

coif_cli_case(live_help EXIT 0 STDOUT "Of a source, prints an address.*Ctrl-C.*--recipe.*R.json.*--quality.*draft, full.*--port.*--root" ARGS view --help)
coif_cli_case(live_absent EXIT 2 STDERR "coif view: error: nope.glb: cannot open" TEXT p.html "p" ARGS view nope.glb --page p.html)
coif_cli_case(live_absent_recipe EXIT 2 STDERR "coif view: error: nope.json: cannot open" TEXT p.html "p" ARGS view nope.json --page p.html)
coif_cli_case(live_lonely_recipe EXIT 3
  STDERR "coif view: error: a.recipe.json: no model called 'a' lies beside it; say which: coif view MODEL --recipe a.recipe.json"
  TEXT a.recipe.json "{}" p.html "p" ARGS view a.recipe.json --page p.html)
coif_cli_case(live_two_sources EXIT 3 STDERR "coif view: error: a.json: several models lie beside it: .*a.glb.*say which: coif view MODEL"
  TEXT a.json "{}" a.glb "x" a.obj "x" p.html "p" ARGS view a.json --page p.html)
coif_cli_case(live_two_recipes EXIT 1 STDERR "coif view: error: a.json is a recipe, and --recipe names another"
  TEXT a.json "{}" p.html "p" ARGS view a.json --recipe b.json --page p.html)
coif_cli_case(live_other_page EXIT 3 STDERR "coif view: error: p.html: not the page of coif view" TEXT p.html "p" ARGS view ${sample} --page p.html)
coif_cli_case(live_bad_quality EXIT 1 STDERR "--quality: 'best' is not one of draft, full" ARGS view a.glb --quality best)
coif_cli_case(live_bad_port EXIT 1 STDERR "--port" ARGS view a.glb --port 65536)
coif_cli_case(live_of_an_asset EXIT 1 STDERR "coif view: error: a.coif is cooked; --recipe, --quality, --port and --root are for a source"
  ARGS view a.coif --quality full)
