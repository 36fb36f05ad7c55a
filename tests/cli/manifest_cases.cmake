# Lists of sources, and shares of them.
coif_cli_case(cook_absent_manifest EXIT 2 STDERR "coif cook: error: m.json: cannot open: No such file or directory"
  ARGS cook --manifest m.json -o .)
coif_cli_case(cook_bad_manifest EXIT 3 STDERR "coif cook: error: m.json: assets\\[1\\]: \"recepi\" is none of source, recipe, output"
  TEXT m.json "{\"assets\": [\"a.obj\", {\"source\": \"b.obj\", \"recepi\": \"r.json\"}]}" ARGS cook --manifest m.json -o .)
coif_cli_case(cook_manifest_and_source EXIT 1 STDERR "--manifest names the sources; leave SOURCE out"
  ARGS cook a.obj --manifest m.json -o .)
coif_cli_case(cook_manifest_and_recipe EXIT 1 STDERR "--manifest names recipes for each source; leave --recipe out"
  ARGS cook --manifest m.json --recipe r.json -o .)
coif_cli_case(cook_batch_of_nothing EXIT 1 STDERR "coif cook: error: --batch.*--manifest" ARGS cook a.obj -o a.coif --batch 1/2)
foreach(share "0/2" "3/2" "1/0" "2" "1/2/3" "-1/2" "a/b" "1/99999999999999999999999")
  string(MAKE_C_IDENTIFIER "cook_batch_${share}" name)
  coif_cli_case(${name} EXIT 1 STDERR "coif cook: error: --batch: '${share}' is not K/N with K from 1 to N, as in 3/40"
    ARGS cook --manifest m.json -o . --batch=${share})
endforeach()
coif_cli_case(cook_share_without_assets EXIT 0 STDOUT "0 asked, 0 cooked [(]0 from the cache[)], 0 failed\n$"
  TEXT m.json "{\"assets\": [\"a.obj\"]}" ARGS cook --manifest m.json -o . --batch 2/2)
coif_cli_case(cook_page_of_one EXIT 1 STDERR "--report OUT.html is for several sources, or a --manifest"
  ARGS cook a.obj -o a.coif --report page.html)
coif_cli_case(cook_report_over_manifest EXIT 1 STDERR "m.json: is also an input; choose another output"
  TEXT m.json "{}" ARGS cook --manifest m.json -o . --report m.json)
coif_cli_case(cook_too_large EXIT 3 STDERR "long.glb: [0-9]+ bytes, and the limit is 1048576; "
  ARGS cook ${PROJECT_SOURCE_DIR}/sample_assets/long/long.glb -o out.coif --max-source-mb 1)
coif_cli_case(cook_takes_too_long EXIT 3 STDERR "long.glb: the (importer|cook) exceeded 1 s"
  ARGS cook ${PROJECT_SOURCE_DIR}/sample_assets/long/long.glb -o out.coif --max-seconds 1 --threads 1)
