# Pages of an asset, most of a page made up here: what the real one shows is tested in tests/web/view.
set(empty_page "<b title='@NAME@'>@ASSET@</b>")
coif_cli_case(view_help EXIT 0 STDOUT "WebGL 2.*one web page.*recipe.*--output.*PAGE.html.*--page.*Exit codes: 0 ok" ARGS view --help)
coif_cli_case(view_text EXIT 0 SAMPLE WRITES bob.html STDOUT "bob.html: [0-9]+ KB with all that it needs; open it in a browser"
  TEXT empty.html ${empty_page} ARGS view ${COIF_COOKED_SAMPLE} --page empty.html)
coif_cli_case(view_json EXIT 0 SAMPLE WRITES page.html JSON output bytes
  TEXT empty.html ${empty_page} ARGS view ${COIF_COOKED_SAMPLE} -o page.html --page empty.html --format json)
coif_cli_case(view_without_page_option EXIT 0 SAMPLE WRITES bob.html STDOUT "bob.html: [0-9]+ KB with all that it needs"
  ARGS view ${COIF_COOKED_SAMPLE})
coif_cli_case(view_unknown_suffix EXIT 1 STDERR "coif view: error: page.png: the suffix must be .html" ARGS view a.coif -o page.png)
coif_cli_case(view_absent EXIT 2 STDERR "coif view: error: nope.coif: cannot open" ARGS view nope.coif)
coif_cli_case(view_source EXIT 3 STDERR "not a cooked hair asset; cook it first: coif cook .*bob.glb -o hair.coif"
  ARGS view ${sample} -o page.html)
coif_cli_case(view_recipe EXIT 3 STDERR "coif view: error: a.json: not a cooked hair asset; cook it first"
  TEXT a.json "{\"material\": {}} and so on" ARGS view a.json -o page.html)
coif_cli_case(view_other_page EXIT 3 SAMPLE STDERR "coif view: error: notes.html: not the page of coif view"
  TEXT notes.html "notes" ARGS view ${COIF_COOKED_SAMPLE} -o page.html --page notes.html)
coif_cli_case(view_absent_page EXIT 2 SAMPLE STDERR "coif view: error: nope.html: cannot open"
  ARGS view ${COIF_COOKED_SAMPLE} -o page.html --page nope.html)
coif_cli_case(view_over_its_page EXIT 1 SAMPLE STDERR "coif view: error: empty.html: is also an input"
  TEXT empty.html ${empty_page} ARGS view ${COIF_COOKED_SAMPLE} -o empty.html --page empty.html)
coif_cli_case(view_motion EXIT 0 SAMPLE WRITES bob.html TEXT empty.html "${empty_page}@MOTION@"
  ARGS view ${COIF_COOKED_SAMPLE} --page empty.html --motion nod)
coif_cli_case(view_no_motion EXIT 1 STDERR "coif view: error: --motion: 'hop' is not one of still, nod.* and no file"
  ARGS view a.coif --motion hop)
coif_cli_case(view_page_without_motions EXIT 3 SAMPLE STDERR "coif view: error: empty.html: not the page of coif view that knows motions"
  TEXT empty.html ${empty_page} ARGS view ${COIF_COOKED_SAMPLE} --page empty.html --motion nod)
coif_cli_case(view_body EXIT 0 SAMPLE WRITES bob.html STDOUT "bob.html: [0-9]+ KB" TEXT empty.html "${empty_page}@BODY@"
  ARGS view ${COIF_COOKED_SAMPLE} --page empty.html --body ${PROJECT_SOURCE_DIR}/sample_assets/portrait/portrait.glb)
coif_cli_case(view_page_without_bodies EXIT 3 SAMPLE STDERR "coif view: error: empty.html: not the page of coif view that knows bodies"
  TEXT empty.html ${empty_page} ARGS view ${COIF_COOKED_SAMPLE} --page empty.html --body ${sample})
coif_cli_case(view_absent_body EXIT 2 SAMPLE STDERR "coif view: error: nope.glb: cannot open"
  TEXT empty.html "${empty_page}@BODY@" ARGS view ${COIF_COOKED_SAMPLE} --page empty.html --body nope.glb)
coif_cli_case(view_body_mesh_alone EXIT 1 STDERR "--body-mesh requires --body" ARGS view a.coif --body-mesh skin)
coif_cli_case(view_clip_of_a_source EXIT 2 STDERR "coif view: error: absent.glb: cannot open"
  TEXT empty.html "${empty_page}@MOTION@" ARGS view ${sample} --page empty.html --motion absent.glb)

# The galleries as such a page.
set(sheet_page "<b title='@NAME@'>@ASSET@</b><i>@SHEET@</i>")
coif_cli_case(gallery_page_text EXIT 0 SAMPLE WRITES sheet.HTML
  STDOUT "sheet.HTML: [0-9]+ tiles, [0-9]+ KB with all that it needs.*Left out.*a hand through hair"
  TEXT empty.html ${sheet_page} ARGS gallery ${COIF_COOKED_SAMPLE} -o sheet.HTML --page empty.html)
coif_cli_case(gallery_page_json EXIT 0 SAMPLE WRITES sheet.html JSON output width height tiles pictures_left_out bytes
  TEXT empty.html ${sheet_page} ARGS gallery ${COIF_COOKED_SAMPLE} --only 2 -o sheet.html --page empty.html --format json)
coif_cli_case(gallery_small_tiles EXIT 1 SAMPLE
  STDERR "coif gallery: error: .*bob.coif: a picture of a sheet has 64 to 1024 pixels each way, not 32 x 64"
  TEXT empty.html ${sheet_page} ARGS gallery ${COIF_COOKED_SAMPLE} --size 32x64 -o sheet.html --page empty.html)
coif_cli_case(gallery_page_absent EXIT 2 STDERR "coif gallery: error: nope.coif: cannot open" ARGS gallery nope.coif -o sheet.html)
coif_cli_case(gallery_absent_page EXIT 2 SAMPLE STDERR "coif gallery: error: nope.html: cannot open"
  ARGS gallery ${COIF_COOKED_SAMPLE} --only 2 -o sheet.html --page nope.html)
coif_cli_case(gallery_other_page EXIT 3 SAMPLE STDERR "coif gallery: error: empty.html: a page of coif view that knows no galleries"
  TEXT empty.html ${empty_page} ARGS gallery ${COIF_COOKED_SAMPLE} --only 2 -o sheet.html --page empty.html)
coif_cli_case(gallery_over_its_page EXIT 1 SAMPLE STDERR "coif gallery: error: empty.html: is also an input"
  TEXT empty.html ${sheet_page} ARGS gallery ${COIF_COOKED_SAMPLE} -o empty.html --page empty.html)
coif_cli_case(gallery_page_of_a_picture EXIT 1 STDERR "coif gallery: error: --page is for a sheet that is a .html"
  ARGS gallery a.coif -o sheet.png --page empty.html)

# ... and reports that link to one.
set(linked accuracy --motion nod --fps 30,60 --substeps 1 --seconds 0.5 --solver thesis --page empty.html)
coif_cli_case(report_view EXIT 0 SAMPLE WRITES out.html bob.html STDOUT "bob.html: written.*out.html: written" TIMEOUT 300
  TEXT empty.html ${empty_page} ARGS report ${COIF_COOKED_SAMPLE} ${linked} -o out.html --view bob.html)
coif_cli_case(report_view_without_page EXIT 1 SAMPLE STDERR "coif report: error: --view is for a report that is a page"
  ARGS report ${COIF_COOKED_SAMPLE} stability -o out.json --view bob.html)
coif_cli_case(report_view_suffix EXIT 1 SAMPLE STDERR "coif report: error: bob.png: the suffix must be .html"
  ARGS report ${COIF_COOKED_SAMPLE} stability -o out.html --view bob.png)
coif_cli_case(report_view_over_it EXIT 1 SAMPLE STDERR "coif report: error: --view and --output name the same file"
  ARGS report ${COIF_COOKED_SAMPLE} stability -o out.html --view ./out.html)
coif_cli_case(report_page_without_view EXIT 1 SAMPLE STDERR "coif report: error: --page is for a report with --view"
  ARGS report ${COIF_COOKED_SAMPLE} stability -o out.html --page empty.html)
coif_cli_case(report_view_absent_page EXIT 2 SAMPLE STDERR "coif report: error: nope.html: cannot open"
  ARGS report ${COIF_COOKED_SAMPLE} stability -o out.html --view bob.html --page nope.html)
