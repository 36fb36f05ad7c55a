# What `coif report` takes, refuses and says.
coif_cli_case(report_absent EXIT 2 STDERR "coif report: error: nope.coif: cannot open: No such file or directory"
  ARGS report nope.coif accuracy)
coif_cli_case(report_text_file EXIT 3 STDERR "coif report: error: notes.coif: not a cooked hair asset"
  TEXT notes.coif "this text is long enough for a header" ARGS report notes.coif stability)
coif_cli_case(report_no_file EXIT 1 STDERR "coif report: error: FILE is required" ARGS report)
coif_cli_case(report_unknown_subject EXIT 1
  STDERR "coif report: error: SUBJECT: 'speed' is not one of accuracy, stability, order, shadows, cost, cards, picture" ARGS report a.coif speed)
coif_cli_case(report_unknown_suffix EXIT 1 STDERR "coif report: error: out.pdf: the suffix must be .html or .json"
  ARGS report a.coif accuracy -o out.pdf)
coif_cli_case(report_unknown_solver EXIT 1 STDERR "coif report: error: --solver: 'magic' is not one of .*thesis"
  ARGS report a.coif accuracy --solver thesis,magic)
coif_cli_case(report_unknown_motion EXIT 1
  STDERR "coif report: error: --motion: 'walk' is neither a motion nor a file; see --help"
  ARGS report a.coif accuracy --motion nod --motion walk)
coif_cli_case(report_two_clips EXIT 1 STDERR "coif report: error: --motion: 'b.glb:head': one clip at a time"
  ARGS report a.coif accuracy --motion a.glb --motion b.glb:head)
coif_cli_case(report_slow_rate EXIT 1 STDERR "coif report: error: --fps" ARGS report a.coif accuracy --fps 60,5)
coif_cli_case(report_no_substeps EXIT 1 STDERR "coif report: error: --substeps"
  ARGS report a.coif accuracy --substeps 0)
coif_cli_case(report_no_budget EXIT 1 STDERR "coif report: error: --budget" ARGS report a.coif accuracy --budget 0)
coif_cli_case(report_rates_for_stability EXIT 1
  STDERR "coif report: error: --fps is for 'coif report FILE.coif accuracy' only; leave it out"
  ARGS report a.coif stability --fps 30)
coif_cli_case(report_absent_folder EXIT 2 SAMPLE STDERR "coif report: error: no/out.html: cannot write: no folder 'no'"
  ARGS report ${COIF_COOKED_SAMPLE} stability -o no/out.html)

set(short --motion nod --fps 30,60 --substeps 1 --seconds 0.5 --solver thesis)
coif_cli_case(report_accuracy_page EXIT 0 SAMPLE WRITES out.HTML
  STDOUT "bob.coif: [0-9]+ bones, .*\n  thesis +1 .*at 60 per second, over 1 motion;.*out.HTML: written"
  TIMEOUT 300 ARGS report ${COIF_COOKED_SAMPLE} accuracy ${short} -o out.HTML)
coif_cli_case(report_accuracy_json EXIT 0 SAMPLE WRITES out.json TIMEOUT 300
  JSON asset bones chains chain_length_m,median machine seconds_taken rows,1,motion rows,1,solver rows,1,fps
       rows,1,substeps rows,1,ns_per_bone_frame rows,1,rms_error_pct rows,1,max_error_pct rows,1,stretch_max_pct
       rows,1,penetration_max_pct rows,1,pareto rows,1,cost_falls spread,0,frame_rate_spread_pct reference,0,motion
       reference,0,self_difference_pct settle,0,settle_error_pct chosen
  ARGS report ${COIF_COOKED_SAMPLE} ${short} -o out.json --format json)
coif_cli_case(report_accuracy_of_told_velocities EXIT 0 SAMPLE TIMEOUT 300
  STDOUT "bob.coif: .*told how fast the head arrives" ARGS report ${COIF_COOKED_SAMPLE} accuracy ${short} --velocities)
coif_cli_case(report_velocities_for_cost EXIT 1
  STDERR "coif report: error: --velocities is for 'coif report FILE.coif accuracy' only; leave it out"
  ARGS report a.coif cost --velocities)
coif_cli_case(report_stability_page EXIT 0 SAMPLE WRITES out.html TIMEOUT 300
  STDOUT "bob.coif: [0-9]+ bones, .*\n  thesis +[0-9]+ .*cases of stress.*out.html: written"
  ARGS report ${COIF_COOKED_SAMPLE} stability --solver thesis -o out.html)
coif_cli_case(report_stability_json EXIT 0 SAMPLE TIMEOUT 300
  JSON asset cases,0,case cases,0,solver cases,0,outcome cases,0,stretch_max_pct cases,0,penetration_max_pct cases,0,limit_max_rad
       cases,0,max_speed cases,0,settle_error_pct descriptions,0,description
  ARGS report ${COIF_COOKED_SAMPLE} stability --solver thesis --format json)

set(quick_cost --heads 1,10 --time 0.3 --size 32x24)
coif_cli_case(report_cost_page EXIT 0 SAMPLE WRITES out.html TIMEOUT 300
  STDOUT "bob.coif: [0-9]+ bones, .*\n  coif +[0-9]+ +1 .*\n  as-cooked .*Simulating one head takes .*out.html: written"
  ARGS report ${COIF_COOKED_SAMPLE} cost ${quick_cost} -o out.html)
coif_cli_case(report_cost_json EXIT 0 SAMPLE TIMEOUT 300
  JSON asset machine instruction_set simulation,1,heads simulation,1,solver simulation,1,us_per_frame
       simulation,1,ns_per_bone_frame simulation,1,spread_pct simulation,1,bytes_per_head features,0,feature
       features,1,change_pct memory,bytes_per_head file,bytes file,chunks,0,bytes rendering distances table_1
       table_1_ratios rendering_note
  ARGS report ${COIF_COOKED_SAMPLE} cost ${quick_cost} --format json)
# Four crowds in four ways, where there is something to draw with.
coif_cli_case(report_cost_table1 EXIT 0 SAMPLE TIMEOUT 600
  JSON table_1,15,heads table_1,15,transparency table_1,15,simulation table_1,15,ms_per_frame table_1,15,step_ms table_1,15,gpu_ms_per_frame
       table_1,15,fps table_1,15,thesis_fps table_1,15,device table_1_ratios,3,transparency_on_off
       table_1_ratios,3,simulation_on_off distances,0,screen_share distances,0,covered_pixels_per_head
  ARGS report ${COIF_COOKED_SAMPLE} cost ${quick_cost} --table1 --format json)
coif_cli_case(report_table1_not_drawn EXIT 1 STDERR "coif report: error: --no-drawing excludes --table1"
  ARGS report a.coif cost --table1 --no-drawing)
coif_cli_case(report_cost_not_drawn EXIT 0 SAMPLE STDOUT "\n  not drawn: drawing was not asked for\n"
  ARGS report ${COIF_COOKED_SAMPLE} cost ${quick_cost} --no-drawing)
# Where there is no EGL the numbers of the simulation are there, and a sentence says why those of drawing are not.
coif_cli_case(report_cost_without_device EXIT 0 SAMPLE STDOUT "  coif +.*\n  not drawn: no EGL display with OpenGL ES 3.0"
  ARGS report ${COIF_COOKED_SAMPLE} cost ${quick_cost})
set_tests_properties(cli.report_cost_without_device PROPERTIES ENVIRONMENT "__EGL_VENDOR_LIBRARY_FILENAMES=/none")
coif_cli_case(report_cost_of_history EXIT 1 SAMPLE
  STDERR "bob.coif: 'xpbd' is no solver that a game can run; cost is measured of coif, thesis"
  ARGS report ${COIF_COOKED_SAMPLE} cost --solver xpbd)
coif_cli_case(report_rates_for_cost EXIT 1
  STDERR "coif report: error: --fps is for 'coif report FILE.coif accuracy' only; leave it out"
  ARGS report a.coif cost --fps 30)
coif_cli_case(report_heads_for_accuracy EXIT 1
  STDERR "coif report: error: --heads is for 'coif report FILE.coif cost' only; leave it out"
  ARGS report a.coif accuracy --heads 30)
coif_cli_case(report_undrawn_stability EXIT 1
  STDERR "coif report: error: --no-drawing is for 'coif report FILE.coif cost' only; leave it out"
  ARGS report a.coif stability --no-drawing)
coif_cli_case(report_views_for_cost EXIT 1
  STDERR "coif report: error: --views is for 'coif report FILE.coif order' only; leave it out"
  ARGS report a.coif cost --views 3)
coif_cli_case(report_size_for_accuracy EXIT 1
  STDERR "coif report: error: --size is for 'coif report FILE.coif cost', 'order' or 'cards' only; leave it out"
  ARGS report a.coif accuracy --size 64x64)
coif_cli_case(report_no_views EXIT 1 STDERR "coif report: error: --views" ARGS report a.coif order --views 0)
coif_cli_case(report_long_orbit EXIT 1 STDERR "coif report: error: --orbit" ARGS report a.coif order --orbit 361)
coif_cli_case(report_table1_for_accuracy EXIT 1
  STDERR "coif report: error: --table1 is for 'coif report FILE.coif cost' only; leave it out"
  ARGS report a.coif accuracy --table1)
coif_cli_case(report_no_heads EXIT 1 STDERR "coif report: error: --heads" ARGS report a.coif cost --heads 10,0)
coif_cli_case(report_no_time EXIT 1 STDERR "coif report: error: --time" ARGS report a.coif cost --time 0)

set(quick_order --size 48x48 --views 4 --orbit 3)
coif_cli_case(report_order_page EXIT 0 SAMPLE WRITES out.html TIMEOUT 300
  STDOUT "bob.coif: [0-9]+ bones, .*\n  rest +head .*\n  rest +opaque .*own order .*out.html: written"
  ARGS report ${COIF_COOKED_SAMPLE} order ${quick_order} -o out.html)
coif_cli_case(report_order_json EXIT 0 SAMPLE TIMEOUT 300
  JSON asset device solver width views orders orbit_frames rows,3,order rows,3,pose rows,3,faces rows,3,psnr_db rows,3,rmse
       rows,3,worst_psnr_db rows,3,bad_pixels_pct rows,3,popping rows,3,median_psnr_db rows,3,ms_per_frame rows,3,sorting_ns rows,3,bytes
       modes,1,transparency modes,1,psnr_db gain_over_head_db,rest gain_over_head_db,turn gain_over_head_db,charge gain_over_head_db,tumble
       thresholds,1,opaque_threshold distance,1,pixels distance,1,coverage_pct reference,0,max_difference worst,0,yaw
       left_out
  ARGS report ${COIF_COOKED_SAMPLE} order ${quick_order} --format json)
coif_cli_case(report_order_alone EXIT 0 SAMPLE STDOUT "\n  tumble +triangles " TIMEOUT 300
  ARGS report ${COIF_COOKED_SAMPLE} order ${quick_order} --no-modes)
coif_cli_case(report_order_too_large EXIT 1 SAMPLE
  STDERR "bob.coif: pictures that are compared have 16 to 1024 pixels each way"
  ARGS report ${COIF_COOKED_SAMPLE} order --size 2000x64)
coif_cli_case(report_order_without_device EXIT 5 SAMPLE STDERR "bob.coif: no EGL display with OpenGL ES 3.0"
  ARGS report ${COIF_COOKED_SAMPLE} order ${quick_order})
set_tests_properties(cli.report_order_without_device PROPERTIES ENVIRONMENT "__EGL_VENDOR_LIBRARY_FILENAMES=/none")
coif_cli_case(report_order_of_thesis EXIT 0 SAMPLE STDOUT "\n  charge +bones .*\n" TIMEOUT 300
  ARGS report ${COIF_COOKED_SAMPLE} order ${quick_order} --no-modes --solver thesis)
coif_cli_case(report_order_of_history EXIT 1 SAMPLE
  STDERR "bob.coif: 'xpbd' is no solver that a game can run; orders are measured with coif, cascade, passive, thesis"
  ARGS report ${COIF_COOKED_SAMPLE} order --solver xpbd)
coif_cli_case(report_order_of_two_solvers EXIT 1
  STDERR "coif report: error: --solver: draw orders are measured with one at a time"
  ARGS report a.coif order --solver coif,thesis)
set(quick_shadows --map-size 128 --spacing 0.01)
coif_cli_case(report_shadows_page EXIT 0 SAMPLE WRITES out.html TIMEOUT 300
  STDOUT "bob.coif: [0-9]+ bones, .*\n  none .*\n  plain, 128 .*\n  deep, 8 layers, 128 .*Nearest to the truth.*out.html: written"
  ARGS report ${COIF_COOKED_SAMPLE} shadows ${quick_shadows} -o out.html)
coif_cli_case(report_shadows_json EXIT 0 SAMPLE TIMEOUT 300
  JSON asset device spacing hair_points head_points lights,4,light rows,39,technique rows,39,layers rows,39,size
       rows,39,light rows,39,pose rows,39,rmse rows,39,bias rows,39,head_rmse rows,39,head_bias rows,39,ms
       totals,3,technique totals,3,worst_light totals,3,worst_pose totals,3,worst_rmse totals,3,bytes
  ARGS report ${COIF_COOKED_SAMPLE} shadows ${quick_shadows} --format json)
coif_cli_case(report_map_size_for_cost EXIT 1
  STDERR "coif report: error: --map-size is for 'coif report FILE.coif shadows' only; leave it out"
  ARGS report a.coif cost --map-size 64)
coif_cli_case(report_small_map EXIT 1 STDERR "coif report: error: --map-size" ARGS report a.coif shadows --map-size 15)
coif_cli_case(report_shadows_without_device EXIT 5 SAMPLE STDERR "bob.coif: no EGL display with OpenGL ES 3.0"
  ARGS report ${COIF_COOKED_SAMPLE} shadows ${quick_shadows})
set_tests_properties(cli.report_shadows_without_device PROPERTIES ENVIRONMENT "__EGL_VENDOR_LIBRARY_FILENAMES=/none")
coif_cli_script(report_order_needs_a_mesh SAMPLE DEFINE ASSET=${COIF_COOKED_SAMPLE})

# Pictures beside true ones: tests/cli/report_pictures.py measures.
set(picture report ${COIF_COOKED_SAMPLE} picture)
coif_cli_case(report_picture_without_truth EXIT 1
  STDERR "coif report: error: pictures are compared with true ones; name their folder: --truth FOLDER" ARGS report a.coif picture)
coif_cli_case(report_truth_of_others EXIT 1 SAMPLE
  STDERR "coif report: error: --truth is for 'coif report FILE.coif picture' only; leave it out" ARGS report ${COIF_COOKED_SAMPLE} --truth .)
coif_cli_case(report_picture_of_no_folder EXIT 2 SAMPLE STDERR "truth.json: cannot open" ARGS ${picture} --truth absent)
coif_cli_case(report_picture_of_an_empty_list EXIT 3 SAMPLE TEXT truth.json "{}"
  STDERR "truth.json: it lists no 'scenes'" ARGS ${picture} --truth .)
coif_cli_case(report_picture_of_half_a_scene EXIT 3 SAMPLE TEXT truth.json "{\"scenes\": [{\"view\": \"front\"}]}"
  STDERR "truth.json: scene 0: it has no text 'color'" ARGS ${picture} --truth .)
coif_cli_case(render_no_such_camera EXIT 2 SAMPLE STDERR "absent.json: cannot open"
  ARGS render ${COIF_COOKED_SAMPLE} --camera absent.json -o a.png)
coif_cli_case(render_bad_camera EXIT 3 SAMPLE TEXT camera.json "{\"eye\": [0, 0]}" STDERR "camera.json: its camera has no three numbers 'eye'"
  ARGS render ${COIF_COOKED_SAMPLE} --camera camera.json -o a.png)
coif_cli_case(render_light EXIT 0 SAMPLE WRITES a.exr ARGS render ${COIF_COOKED_SAMPLE} --size 64x48 --samples 1 -o a.exr)

# Cards beside their strands: tests/cli/report_cards.py measures.
set(cards report ${COIF_COOKED_SAMPLE} cards)
set(lines "v 8 0 0\nv 8 -1 0\nv 8.1 0 0\nv 8.1 -1 0.1\nl 1 2\nl 3 4\n")
coif_cli_case(report_cards_without_strands EXIT 1
  STDERR "coif report: error: cards are compared with strands; name those that the asset was cooked from: --source GROOM"
  ARGS report a.coif cards)
coif_cli_case(report_cards_of_text EXIT 1 SAMPLE TEXT notes.txt "no strands"
  STDERR "--source: notes.txt is no file of strands; name one that is: .hair, .tfx, .obj" ARGS ${cards} --source notes.txt)
coif_cli_case(report_cards_of_absent_strands EXIT 2 SAMPLE STDERR "absent.tfx: cannot open" ARGS ${cards} --source absent.tfx)
coif_cli_case(report_cards_of_strips EXIT 3 SAMPLE TEXT strips.obj "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
  STDERR "strips.obj: cannot be read as lines of a Wavefront OBJ: .*export curves as polylines" ARGS ${cards} --source strips.obj)
coif_cli_case(report_cards_of_other_strands EXIT 3 SAMPLE TEXT other.obj ${lines}
  STDERR "bob.coif: was cooked from other strands than those of other.obj: its hair is .*; name the file that it was cooked from"
  ARGS ${cards} --source other.obj)
coif_cli_case(report_cards_not_square EXIT 1 SAMPLE TEXT other.obj ${lines}
  STDERR "--size: pictures of cards are as wide as high" ARGS ${cards} --source other.obj --size 64x48)
coif_cli_case(report_cards_too_large EXIT 1 SAMPLE TEXT other.obj ${lines}
  STDERR "bob.coif: .*in pictures of 16 to 512 pixels each way" ARGS ${cards} --source other.obj --size 2000x2000)
coif_cli_case(report_cards_of_one_triangle EXIT 1 STDERR "coif report: error: --budgets"
  ARGS report a.coif cards --source a.tfx --budgets 1)
coif_cli_case(report_source_for_cost EXIT 1
  STDERR "coif report: error: --source is for 'coif report FILE.coif cards' only; leave it out"
  ARGS report a.coif cost --source a.tfx)
