# What `coif validate` takes, refuses and says.
coif_cli_case(validate_absent EXIT 2 STDERR "coif validate: error: nope.coif: cannot open: No such file or directory"
  STDOUT "nope.coif: unreadable" ARGS validate nope.coif)
coif_cli_case(validate_text EXIT 3 STDERR "notes.coif: not a cooked hair asset \\[A103\\]" STDOUT "notes.coif: invalid"
  TEXT notes.coif "this text is long enough for a header" ARGS validate notes.coif)
coif_cli_case(validate_source EXIT 0 STDOUT "bob.glb: valid" ARGS validate ${sample})
coif_cli_case(validate_bad_source EXIT 3 STDERR "coif validate: error: braid.glb: .*S101" STDOUT "braid.glb: invalid"
  TEXT braid.glb "not a glTF at all" ARGS validate braid.glb)
coif_cli_case(validate_bald_source EXIT 3 STDERR "coif validate: error: .*R.json.*S104" STDOUT "bob.glb: invalid"
  TEXT R.json "{\"hair\": {\"meshes\": [\"R.json\"]}}" ARGS validate ${sample} --recipe R.json)
coif_cli_case(validate_bad_recipe EXIT 3 STDERR "bob.glb: recipe: R.json: .*hair.mash.*S103" STDOUT "bob.glb: invalid"
  TEXT R.json "{\"hair\": {\"mash\": []}}" ARGS validate ${sample} --recipe R.json)
coif_cli_case(validate_asset EXIT 0 SAMPLE STDOUT "bob.coif: valid" ARGS validate ${COIF_COOKED_SAMPLE})
coif_cli_case(validate_json EXIT 2 SAMPLE JSON files,0,path files,0,valid files,0,issues files,0,folded files,1,errors
       files,1,warnings files,1,infos files,1,issues,0,code files,1,issues,0,severity files,1,issues,0,message
       files,1,issues,0,where
  ARGS validate --format json ${COIF_COOKED_SAMPLE} nope.coif)

coif_cli_case(validate_nothing EXIT 1 STDERR "coif validate: error: FILE is required; see 'coif validate --help'"
  ARGS validate)
coif_cli_case(validate_codes EXIT 0 STDOUT "## container.*A107.* error: .*## source" ARGS validate --list-codes)
coif_cli_case(validate_codes_json EXIT 0
  JSON codes,0,code codes,0,group codes,0,severity codes,0,title codes,0,meaning codes,0,cure
  ARGS validate --list-codes --format json)
coif_cli_case(validate_unknown_severity EXIT 1 STDERR "--severity: 'fatal' is not one of error, warning, info"
  ARGS validate a.coif --severity fatal)
coif_cli_case(validate_ignored_error EXIT 1 STDERR "--ignore: 'A107' is no warning or note; .* --list-codes"
  ARGS validate a.coif --ignore A107)
coif_cli_case(validate_ignored_nonsense EXIT 1 STDERR "--ignore: 'A2' is no warning or note"
  ARGS validate --ignore A204 --ignore A2 a.coif)
coif_cli_case(validate_no_issues EXIT 1 STDERR "coif validate: error: --max-issues" ARGS validate a.coif --max-issues 0)
coif_cli_case(validate_two_origins EXIT 1 STDERR "coif validate: error: --source is for one asset at a time"
  ARGS validate a.coif b.coif --source a.glb)
coif_cli_case(validate_recook_of_nothing EXIT 1 STDERR "coif validate: error: --recook requires --source"
  ARGS validate a.coif --recook)

coif_cli_case(validate_same_origin EXIT 0 SAMPLE STDOUT "bob.coif: valid"
  ARGS validate ${COIF_COOKED_SAMPLE} --source ${sample} --warnings-as-errors)
coif_cli_case(validate_new_cook EXIT 0 SAMPLE STDOUT "bob.coif: valid" TIMEOUT 300
  ARGS validate ${COIF_COOKED_SAMPLE} --source ${sample} --recook)
coif_cli_case(validate_other_recipe EXIT 3 SAMPLE STDOUT "bob.coif: invalid"
  STDERR "bob.coif: chunk PROV: cooked from a recipe with the hash [0-9a-f]+; it now is [0-9a-f]+: cook again \\[R102\\]"
  TEXT R.json "{\"dynamics\": {\"friction\": 3}}" ARGS validate ${COIF_COOKED_SAMPLE} --source ${sample} --recipe R.json)
coif_cli_case(validate_absent_origin EXIT 2 SAMPLE STDERR "coif validate: error: nope.glb: cannot open"
  ARGS validate ${COIF_COOKED_SAMPLE} --source nope.glb)
coif_cli_script(validate_keeps_to_its_policy SAMPLE DEFINE ASSET=${COIF_COOKED_SAMPLE} SOURCE=${sample})

coif_cli_case(validate_page_suffix EXIT 1 STDERR "coif validate: error: out.pdf: the suffix must be .html"
  ARGS validate a.coif --report out.pdf)
coif_cli_case(validate_page_folder EXIT 2 STDERR "coif validate: error: no/out.html: cannot write: no folder 'no'"
  ARGS validate a.coif --report no/out.html)
coif_cli_case(validate_page_of_bad EXIT 3 WRITES out.html STDOUT "notes.coif: invalid"
  TEXT notes.coif "this text is long enough for a header" ARGS validate notes.coif --report out.html)
coif_cli_script(validate_draws_patches)
coif_cli_script(size_is_judged TIMEOUT 120)

# A warning has its code in both verbs, and is acknowledged by it, on the command line or in the recipe.
coif_cli_script(warnings_are_acknowledged TIMEOUT 180)
# A head without hair.
coif_cli_case(cook_bare_head EXIT 3 STDERR "coif cook: error: .*portrait.glb: there is no hair, only what looks like a body: mesh 'skin' .*Object > Convert > Mesh"
  ARGS cook ${PROJECT_SOURCE_DIR}/sample_assets/portrait/portrait.glb -o bald.coif)
coif_cli_case(validate_bare_head EXIT 3 STDERR "there is no hair.*\\[S104\\]" STDOUT "portrait.glb: invalid"
  ARGS validate ${PROJECT_SOURCE_DIR}/sample_assets/portrait/portrait.glb)
