# The command line itself.
coif_cli_case(no_verb EXIT 1 STDERR "coif: error: needs a verb: cook.*see 'coif --help'" ARGS)
coif_cli_case(unknown_verb EXIT 1 STDERR "coif: error: .*braid" ARGS braid)
coif_cli_case(version EXIT 0 STDOUT "^coif ${PROJECT_VERSION}\n$" ARGS --version)
coif_cli_case(licenses EXIT 0 STDOUT "MIT. It is built with these works of others.*Highway, Apache-2.0 OR BSD-3-Clause .libhwy-dev.*Eigen, MPL-2.0" ARGS --licenses)
coif_cli_case(help EXIT 0 STDOUT "cook.*validate.*info.*simulate.*render.*gallery.*view.*compare.*report.*strip.*Exit codes: 0 ok" ARGS --help)
coif_cli_case(cook_help EXIT 0 STDOUT "--recipe.*\n\nExit codes: 0 ok[^:]*$" ARGS cook --help)
coif_cli_case(unknown_option EXIT 1 STDERR "coif info: error: .*--colour.*see 'coif info --help'"
  ARGS info a.coif --colour)
coif_cli_case(unknown_format EXIT 1 STDERR "coif info: error: --format: 'xml' is not one of text, json"
  ARGS info a.coif --format xml)

coif_cli_case(cook_without_source EXIT 1 STDERR "coif cook: error: needs a SOURCE" ARGS cook)
coif_cli_case(cook_without_output EXIT 1 STDERR "coif cook: error: needs -o OUT.coif" ARGS cook braid.glb)
coif_cli_case(cook_no_threads EXIT 1 STDERR "coif cook: error: --threads" ARGS cook braid.glb -o out.coif --threads 0)

coif_cli_case(simulate_unknown_motion EXIT 1 STDERR "coif simulate: error: --motion: 'walk' is not one of still, nod"
  ARGS simulate a.coif --motion walk -o out.csv)
coif_cli_case(simulate_unknown_solver EXIT 1 STDERR "--solver: 'magic' is not one of coif, cascade, passive, thesis"
  ARGS simulate a.coif --motion nod --solver magic -o out.csv)
coif_cli_case(simulate_unknown_suffix EXIT 1 STDERR "coif simulate: error: out.fbx: the suffix must be .csv or .glb"
  ARGS simulate a.coif --motion nod -o out.fbx)
coif_cli_case(simulate_pose_too_heavy EXIT 1 STDERR "coif simulate: error: --pose: 'sway.glb:1.5': behind the colon stands a weight, 0 to 1"
  ARGS simulate a.coif --motion nod --pose sway.glb:1.5 -o out.csv)
coif_cli_case(simulate_pose_of_no_weight EXIT 1 STDERR "--pose: 'sway.glb:soft': behind the colon stands a weight, 0 to 1"
  ARGS simulate a.coif --motion nod --pose sway.glb:soft -o out.csv)
coif_cli_case(render_unknown_suffix EXIT 1 STDERR "coif render: error: out.jpg: the suffix must be .png"
  ARGS render a.coif -o out.jpg)
coif_cli_case(simulate_slow_rate EXIT 1 STDERR "coif simulate: error: --fps"
  ARGS simulate a.coif --motion nod --fps 5 -o out.csv)
coif_cli_case(simulate_no_motion EXIT 1 STDERR "coif simulate: error: needs --motion NAME or --attitude X,Y,Z"
  ARGS simulate a.coif -o out.csv)
coif_cli_case(simulate_two_motions EXIT 1 STDERR "coif simulate: error: --motion excludes --attitude"
  ARGS simulate a.coif --motion nod --attitude 1,0,0 -o out.csv)
foreach(attitude "0,0,0" "1,0" "1,0,0,0" "up" "1,0,2000" "1,,0" "nan,0,1")
  string(MAKE_C_IDENTIFIER "simulate_attitude_${attitude}" name)
  coif_cli_case(${name} EXIT 1 STDERR "coif simulate: error: --attitude: '${attitude}' is not X,Y,Z, a direction"
    ARGS simulate a.coif --attitude ${attitude} -o out.csv)
endforeach()
foreach(scale 0.049 20.1 0 -1)
  string(MAKE_C_IDENTIFIER "simulate_scale_${scale}" name)
  coif_cli_case(${name} EXIT 1 STDERR "coif simulate: error: --scale"
    ARGS simulate a.coif --motion nod --scale=${scale} -o out.csv)
endforeach()
coif_cli_case(simulate_half_a_wind EXIT 1 STDERR "coif simulate: error: --wind: '3,0' is not X,Y,Z in metres per second"
  ARGS simulate a.coif --motion nod --wind 3,0 -o out.csv)
coif_cli_case(simulate_gusts_of_four_numbers EXIT 1 STDERR "coif simulate: error: --gusts: '4,1,3,2' is not AMPLITUDE"
  ARGS simulate a.coif --motion nod --gusts 4,1,3,2 -o out.csv)
coif_cli_case(simulate_gusts_in_the_cascade EXIT 1 STDERR "coif simulate: error: --gusts: hair feels gusts with --solver coif alone"
  SAMPLE ARGS simulate ${COIF_COOKED_SAMPLE} --motion nod --gusts 4 --solver cascade -o out.csv)
foreach(lengths "0.016,0" "0.016,1.1" "0.016," "fast" "nan")
  string(MAKE_C_IDENTIFIER "simulate_frame_lengths_${lengths}" name)
  coif_cli_case(${name} EXIT 1
    STDERR "coif simulate: error: --frame-lengths: '${lengths}' is not a list of seconds, 0.001 to 1 each"
    ARGS simulate a.coif --motion nod --frame-lengths ${lengths} -o out.csv)
endforeach()
coif_cli_case(simulate_two_paces EXIT 1 STDERR "coif simulate: error: --fps excludes --frame-lengths"
  ARGS simulate a.coif --motion nod --fps 30 --frame-lengths 0.02 -o out.csv)
foreach(jitter "0.91" "-0.1" "nan" "0.1,x" "0.1,1,2")
  string(MAKE_C_IDENTIFIER "simulate_jitter_${jitter}" name)
  coif_cli_case(${name} EXIT 1 STDERR "coif simulate: error: --jitter: '${jitter}' is not SHARE.,SEED.: 0 to 0.9, and a whole number"
    ARGS simulate a.coif --motion nod --jitter=${jitter} -o out.csv)
endforeach()
coif_cli_case(simulate_help EXIT 0
  STDOUT "--attitude.*shortest way.*--scale.*--true-gravity.*--wind.*--gusts.*--frame-lengths.*--jitter.*Exit codes: 0 ok"
  ARGS simulate --help)
coif_cli_case(simulate_too_many_substeps EXIT 1 STDERR "coif simulate: error: --substeps"
  ARGS simulate a.coif --motion nod --substeps 65 -o out.csv)
coif_cli_case(gallery_help EXIT 0 STDOUT "a page of live tiles.*exponents.*SHEET.png.SHEET.html.*--only.*1 to 7.*--size.*64 to 1024.*--format.*Exit codes: 0 ok"
  ARGS gallery --help)
coif_cli_case(gallery_unknown_number EXIT 1 STDERR "coif gallery: error: --only.*8"
  ARGS gallery a.coif --only 8 -o sheet.png)
coif_cli_case(gallery_unknown_suffix EXIT 1 STDERR "coif gallery: error: sheet.jpg: the suffix must be .png or .html"
  ARGS gallery a.coif -o sheet.jpg)
coif_cli_case(gallery_without_output EXIT 1 STDERR "coif gallery: error: .*--output.*see 'coif gallery --help'" ARGS gallery a.coif)
coif_cli_case(render_bad_size EXIT 1 STDERR "--size: '4x4' is not WIDTHxHEIGHT within 16 .. 8192"
  ARGS render a.coif --size 4x4 -o out.png)
coif_cli_case(render_bad_view EXIT 1 STDERR "--view: '30' is not YAW,PITCH" ARGS render a.coif --view 30 -o out.png)
coif_cli_case(render_bad_gusts EXIT 1 STDERR "--gusts: '3,x' is not AMPLITUDE.*: 0 to 1000 m/s, 0.05 to 10000 m"
  ARGS render a.coif --gusts 3,x -o out.png)
coif_cli_case(render_gusts_too_short EXIT 1 STDERR "--gusts: '3,0.01' is not AMPLITUDE"
  ARGS render a.coif --gusts 3,0.01 -o out.png)
coif_cli_case(render_gusts_of_four_numbers EXIT 1 STDERR "--gusts: '3,1,2,4' is not AMPLITUDE"
  ARGS render a.coif --gusts 3,1,2,4 -o out.png)
coif_cli_case(render_gusts_with_another_solver EXIT 1 STDERR "coif render: error: --gusts: hair feels gusts with --solver coif alone"
  ARGS render a.coif --gusts 3 --solver thesis -o out.png)
coif_cli_case(render_bad_lights EXIT 1 STDERR "--lights: 'disco' is not one of studio, sun, rim, plain"
  ARGS render a.coif --lights disco -o out.png)
coif_cli_case(render_bad_ground EXIT 1 STDERR "--ground: 'grass' is not one of auto, shown, none"
  ARGS render a.coif --ground grass -o out.png)
coif_cli_case(render_bad_backdrop EXIT 1 STDERR "'grey' is not dark, light, clear or a colour as #rrggbb"
  ARGS render a.coif --backdrop grey -o out.png)
coif_cli_case(render_bad_samples EXIT 1 STDERR "--samples: '3' is not 1, 2, 4, 8, 16, 32 or 64"
  ARGS render a.coif --samples 3 -o out.png)
coif_cli_case(render_bad_shading EXIT 1 STDERR "--shading: 'phong' is not one of thesis, kajiya-kay, marschner, volume"
  ARGS render a.coif --shading phong -o out.png)
coif_cli_case(render_bad_order EXIT 1 STDERR "--order: 'depth' is not one of cooked, bones"
  ARGS render a.coif --order depth -o out.png)
coif_cli_case(render_bad_transparency EXIT 1
  STDERR "--transparency: 'door' is not one of blend, opaque, coverage, proportional, jittered, screendoor, checkerboard, bayer, hashed, exact"
  ARGS render a.coif --transparency door -o out.png)
coif_cli_case(render_bad_shadows EXIT 1 STDERR "--shadows: 'soft' is not one of none, plain, opacity, deep, deep-shadow"
  ARGS render a.coif --shadows soft -o out.png)
coif_cli_case(render_bad_debug EXIT 1 STDERR "--debug: 'bonez' is not one of bones, colliders, contacts, limits, motion"
  ARGS render a.coif --debug bones,bonez -o out.png)
coif_cli_case(render_time_without_motion EXIT 1 STDERR "coif render: error: .*--motion"
  ARGS render a.coif --time 1 -o out.png)

# The cases themselves notice a wrong code, a missing text, a missing key and a file left behind.
coif_cli_case(notices_wrong_code EXIT 3 ARGS --version)
coif_cli_case(notices_missing_text EXIT 0 STDOUT "no such text" ARGS --version)
coif_cli_case(notices_missing_key EXIT 0 JSON bytes ARGS --version)
coif_cli_case(notices_file_left_behind EXIT 0 TEXT card.obj "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n" ARGS cook card.obj -o left.coif)
set_tests_properties(cli.notices_wrong_code cli.notices_missing_text cli.notices_missing_key
                     cli.notices_file_left_behind PROPERTIES WILL_FAIL ON)
