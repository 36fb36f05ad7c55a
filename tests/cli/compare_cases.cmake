# What `coif compare` takes, refuses and says.
coif_cli_case(compare_absent EXIT 2 STDERR "coif compare: error: nope.coif: cannot open: No such file or directory"
  ARGS compare nope.coif nope.coif)
coif_cli_case(compare_text EXIT 3 STDERR "coif compare: error: notes.coif: not a cooked hair asset"
  TEXT notes.coif "this text is long enough for a header" ARGS compare notes.coif notes.coif)
coif_cli_case(compare_one EXIT 1 STDERR "coif compare: error: B is required" ARGS compare a.coif)
coif_cli_case(compare_unknown_motion EXIT 1 STDERR "coif compare: error: --motion: 'walk' is not a motion; see --help"
  ARGS compare a.coif b.coif --motion walk)
coif_cli_case(compare_with_itself EXIT 0 SAMPLE
  STDOUT "at rest 0.000 mm apart.*\n  turn +0.00 +0.00 +0.00 +0.0 +[1-9][0-9.]* +0.00 +[0-9.]+\n.*0 the same motion"
  ARGS compare ${COIF_COOKED_SAMPLE} ${COIF_COOKED_SAMPLE} --motion turn --seconds 1)
coif_cli_case(compare_json EXIT 0 SAMPLE
  JSON a b fps seconds hair_size_mm rest_rms_mm rows,1,motion rows,0,rms_mm rows,0,max_mm rows,0,rms_pct rows,0,max_pct
       rows,0,moved_rms_mm rows,0,ratio rows,0,still_ratio
  ARGS compare ${COIF_COOKED_SAMPLE} ${COIF_COOKED_SAMPLE} --motion nod --motion turn --fps 30 --seconds 0.5
       --format json)
