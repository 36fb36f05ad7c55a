# What `coif strip` takes, refuses and says.
coif_cli_case(strip_text EXIT 0 SAMPLE WRITES out.coif
  STDOUT "^out.coif: [0-9]+ bytes, [0-9]+ saved [(][0-9]+[.][0-9] %[)]\n  removed   TEXR +80\n  removed   TEXD +[0-9]+\n$"
  ARGS strip ${COIF_COOKED_SAMPLE} -o out.coif --without textures)
coif_cli_case(strip_json EXIT 0 SAMPLE WRITES out.coif
  JSON output bytes_before bytes bytes_saved removed,0,id removed,0,bytes shortened,0,id shortened,0,bytes rewritten,0
  ARGS strip ${COIF_COOKED_SAMPLE} -o out.coif --without lods,names --format json)
coif_cli_case(strip_takes_what_needs_it EXIT 0 SAMPLE WRITES out.coif
  STDOUT "removed   PTCH .*removed   LODS .*removed   LODB .*removed   VERT .*removed   SKIN .*removed   INDX "
  ARGS strip ${COIF_COOKED_SAMPLE} -o out.coif --without Vert)
coif_cli_case(strip_says_what_it_rewrites EXIT 0 SAMPLE WRITES out.coif
  STDOUT "removed   CHAN .*removed   DYNA .*rewritten SKEL\n  rewritten BONE\n"
  ARGS strip ${COIF_COOKED_SAMPLE} -o out.coif --without motion)
coif_cli_case(strip_help_lists_groups EXIT 0 STDOUT "textures .*[(]TEXR TEXD RELR RELD[)].*mesh .*Exit codes" ARGS strip --help)

coif_cli_case(strip_needed_chunk EXIT 1 SAMPLE
  STDERR "coif strip: error: --without: no asset is without BONE: .*; leave it off the list"
  ARGS strip ${COIF_COOKED_SAMPLE} -o out.coif --without names,bone)
coif_cli_case(strip_misspelt_group EXIT 1 SAMPLE STDERR "'Textrues' is no part of an asset; did you mean 'textures'[?]"
  ARGS strip ${COIF_COOKED_SAMPLE} -o out.coif --without Textrues)
coif_cli_case(strip_misspelt_chunk EXIT 1 SAMPLE STDERR "'TEXO' is no part of an asset; did you mean 'TEX[RD]'[?]"
  ARGS strip ${COIF_COOKED_SAMPLE} -o out.coif --without TEXO)
coif_cli_case(strip_no_such_part EXIT 1 SAMPLE
  STDERR "'shoulderpads' is no part of an asset; use names, .*or a chunk's name as 'coif info' prints it"
  ARGS strip ${COIF_COOKED_SAMPLE} -o out.coif --without shoulderpads)
coif_cli_case(strip_empty_word EXIT 1 SAMPLE STDERR "'' is no part of an asset"
  ARGS strip ${COIF_COOKED_SAMPLE} -o out.coif --without names,,lods)
coif_cli_case(strip_without_list EXIT 1 STDERR "coif strip: error: --without is required"
  ARGS strip a.coif -o out.coif)
coif_cli_case(strip_without_output EXIT 1 STDERR "coif strip: error: --output is required"
  ARGS strip a.coif --without names)
coif_cli_case(strip_absent EXIT 2 STDERR "coif strip: error: nope.coif: cannot open: No such file or directory"
  ARGS strip nope.coif -o out.coif --without names)
coif_cli_case(strip_absent_folder EXIT 2 SAMPLE STDERR "none/out.coif: cannot write: no folder 'none'; create it first"
  ARGS strip ${COIF_COOKED_SAMPLE} -o none/out.coif --without names)
coif_cli_case(strip_text_file EXIT 3 STDERR "coif strip: error: notes.coif: not a cooked hair asset"
  TEXT notes.coif "this text is long enough for a header" ARGS strip notes.coif -o out.coif --without names)
