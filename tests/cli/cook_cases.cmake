# What `coif cook` takes, refuses and says.
coif_cli_case(cook_absent EXIT 2 STDERR "coif cook: error: nope.glb: cannot open: No such file or directory"
  ARGS cook nope.glb -o out.coif)
coif_cli_case(cook_folder EXIT 2 STDERR "coif cook: error: [.]: cannot open: Is a directory" ARGS cook . -o out.coif)
coif_cli_case(cook_unknown_format EXIT 5 STDERR "coif cook: error: notes.txt: "
  TEXT notes.txt "hair notes" ARGS cook notes.txt -o out.coif)
coif_cli_case(cook_malformed EXIT 3 STDERR "coif cook: error: braid.glb: "
  TEXT braid.glb "not a glTF at all" ARGS cook braid.glb -o out.coif)
coif_cli_case(cook_absent_folder EXIT 2 STDERR "none/out.coif: cannot write: no folder 'none'; create it first"
  ARGS cook ${sample} -o none/out.coif)
coif_cli_case(cook_over_its_source EXIT 1 STDERR "braid.obj: is also an input; choose another output"
  TEXT braid.obj "v 0 0 0\n" ARGS cook braid.obj -o braid.obj)
coif_cli_case(cook_report_over_asset EXIT 1 STDERR "--report and --output name the same file"
  ARGS cook ${sample} -o out.coif --report out.coif)
coif_cli_case(cook_depfile_over_asset EXIT 1 STDERR "--depfile and --output name the same file"
  ARGS cook ${sample} -o out.coif --depfile out.coif)
coif_cli_case(cook_depfile_over_report EXIT 1 STDERR "--report and --depfile name the same file"
  ARGS cook ${sample} -o out.coif --depfile out.d --report out.d)
coif_cli_case(cook_several_into_a_file EXIT 1 STDERR "out.coif: several sources need a folder that exists; create it first"
  ARGS cook ${sample} other.glb -o out.coif)
coif_cli_case(cook_several_of_one_name EXIT 1 STDERR "bob.glb and bob.obj would both become [.]/bob.coif"
  ARGS cook ${sample} bob.obj -o .)
coif_cli_case(cook_several_with_a_depfile EXIT 1 STDERR "--depfile goes with one SOURCE" ARGS cook a.obj b.obj -o . --depfile d)
coif_cli_case(cook_several_without_a_folder EXIT 1 STDERR "needs -o FOLDER for several sources" ARGS cook a.obj b.obj)

coif_cli_case(cook_absent_recipe EXIT 2 STDERR "coif cook: error: r.json: "
  ARGS cook ${sample} --recipe r.json -o out.coif)
coif_cli_case(cook_misspelt_recipe_key EXIT 3 STDERR "r.json: .*did you mean"
  TEXT r.json "{\"dynamics\": {\"fricton\": 1}}" ARGS cook ${sample} --recipe r.json -o out.coif)
coif_cli_case(cook_opacity_of_no_channel EXIT 3
  STDERR "r.json: \"textures.opacity\" wants a path, or {\"file\": \"hair.png\", \"channel\": .*}, found {\"channel\":\"q\",\"file\":\"a.png\"}"
  TEXT r.json "{\"textures\": {\"opacity\": {\"file\": \"a.png\", \"channel\": \"q\"}}}"
  ARGS cook ${sample} --recipe r.json -o out.coif)
coif_cli_case(cook_opacity_that_is_not_there EXIT 3 STDERR "a.png: recipe key \"textures.opacity\": no such file"
  TEXT r.json "{\"textures\": {\"opacity\": {\"file\": \"a.png\", \"channel\": \"r\"}}}"
  ARGS cook ${sample} --recipe r.json -o out.coif)
coif_cli_case(cook_opacity_of_a_kind_that_is_not_read EXIT 3
  STDERR "a.png: recipe key \"textures.opacity\": a GIF image, which is not read; make a PNG of it: convert hair.gif hair.png"
  TEXT r.json "{\"textures\": {\"opacity\": \"a.png\"}}" a.png "GIF89a"
  ARGS cook ${sample} --recipe r.json -o out.coif)
coif_cli_case(cook_names_body_bones_that_are_not_there EXIT 3
  STDERR "\"body.colliders\" \\[0\\]: no bone is called 'LeftSholder'; "
  TEXT r.json "{\"body\": {\"colliders\": [{\"bone\": \"LeftSholder\", \"radius\": 0.1}]}}"
  ARGS cook ${sample} --recipe r.json -o out.coif)
coif_cli_case(cook_names_limits_of_no_bone EXIT 3
  STDERR "\"dynamics.limits\" \\[0\\]: no bone that moves is called tail_x; there are "
  TEXT r.json "{\"dynamics\": {\"limits\": [{\"bones\": \"tail_x\", \"kind\": \"cone\", \"angle\": 9}]}}"
  ARGS cook ${sample} --recipe r.json -o out.coif)
coif_cli_case(cook_links_no_such_bone EXIT 3
  STDERR "bob.glb: \"dynamics.links\" \\[0\\]: no bone that moves is called tail_x; chains begin with "
  TEXT r.json "{\"dynamics\": {\"links\": [[\"tail_x\", \"*\"]]}}"
  ARGS cook ${sample} --recipe r.json -o out.coif)
coif_cli_case(cook_links_by_another_word EXIT 3
  STDERR "r.json: \"dynamics.links\" wants \"none\", \"shared_strips\" or a list of .*, found \"all\""
  TEXT r.json "{\"dynamics\": {\"links\": \"all\"}}"
  ARGS cook ${sample} --recipe r.json -o out.coif)
coif_cli_case(cook_finds_recipe_beside EXIT 3
  STDERR "note: braid.recipe.json: used, as it lies beside the source.*error: braid.recipe.json: "
  TEXT braid.obj "v 0 0 0\n" braid.recipe.json "{" ARGS cook braid.obj -o out.coif)
coif_cli_case(print_recipe EXIT 0 STDOUT "\"dynamics\".*friction.*//|//.*\"dynamics\".*friction" ARGS cook --print-recipe)
coif_cli_case(print_recipe_has_solver_keys EXIT 0
  STDOUT "\"preset\": \"natural\".*\"model\": \"auto\".*\"sags\": false.*\"damping_ratio\": null.*\"conditioning\": \"auto\".*\"torsion\": .*\"angle_limit\": 180.*\"links\": \"none\".*\"link_stretch\": 0.1.*\"link_shrink\": 0.5.*\"parent_share\": 1.*\"budget\".*\"error\": 0.*\"error_mm\": 0.*\"ns_per_frame\": 0.*\"slowest_rate\": 30.*\"fastest_rate\": 120"
  ARGS cook --print-recipe)
coif_cli_case(cook_over_budget EXIT 4 TIMEOUT 120
  STDERR "bob.glb: \"budget\": an error of 1e-05 % .* was asked for and [0-9.]+ % reached, where 2000 ns .*allowed, with [1-9][0-9]* ns"
  TEXT r.json "{\"budget\": {\"error\": 1e-5, \"ns_per_frame\": 2000}}"
  WRITES report.json
  ARGS cook ${sample} --recipe r.json -o out.coif --report report.json)

# The search for draw orders takes most of a cook's time and says nothing here.
set(head_order "\"order\": {\"method\": \"head\"}")
coif_cli_case(cook_text EXIT 0 WRITES out.coif
  STDOUT "^out.coif: [1-9][0-9]* triangles in .* simulated.*\n  9 bones move as natural hair: what is longer than 80 mm hangs.*[0-9.]+ ms  import\n.*[0-9.]+ ms  write\n.*next: coif render out.coif"
  TEXT r.json "{${head_order}}" ARGS cook ${sample} --recipe r.json -o out.coif -v)
coif_cli_case(cook_json EXIT 0 WRITES out.coif report.json
  JSON passes,0,name passes,0,ms warnings triangles patches patches_by_index patches_by_position chains bones
       simulated_bones draw_order,orders draw_order,worst_psnr_db draw_order,cuts draw_order,triangles_added
       left_out,0,what left_out,0,why left_out,0,bytes left_out,0,bytes_per_head left_out,0,ns_per_frame
  TEXT r.json "{${head_order}}" ARGS cook ${sample} --recipe r.json -o out.coif --report report.json --format json)
coif_cli_case(cook_cuts_out_of_range EXIT 3 STDERR "order.cut_budget.* wants a number from 0 to 1, found 2"
  TEXT r.json "{\"order\": {\"cut_budget\": 2}}" ARGS cook ${sample} --recipe r.json -o out.coif)
coif_cli_case(cook_for_a_scene EXIT 0 WRITES out.coif
  STDOUT "left out: 12 bones, 9 of them simulated: \"scene.simulate\" is false [(][0-9]+ bytes, [0-9]+ ns a frame[)].*left out: bone names: \"scene.names\" is false [(][0-9]+ bytes[)]"
  TEXT r.json "{\"scene\": {\"simulate\": false, \"names\": false}, ${head_order}}" ARGS cook ${sample} --recipe r.json -o out.coif --verbose)
coif_cli_case(cook_one_flat_card EXIT 0 STDOUT "^card.coif: 1 triangle in 1 patch " WRITES card.coif
  TEXT card.obj "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n" ARGS cook card.obj -o card.coif)
coif_cli_case(cook_list EXIT 0 STDOUT "meshes\n.*materials\n.*nodes\n.*[(]bone[)]" ARGS cook ${sample} --list)
coif_cli_case(cook_list_json EXIT 0 JSON meshes,0,name materials,0,name nodes,0,name
  ARGS cook ${sample} --list --format json)

coif_cli_case(cook_draft EXIT 0 WRITES out.coif STDOUT "\n  a draft, to look at: cook without --draft before it goes into a game\n"
  ARGS cook ${sample} -o out.coif --draft)
coif_cli_case(cook_draft_json EXIT 0 WRITES out.coif JSON draft passes,0,name ARGS cook ${sample} -o out.coif --draft --format json)

coif_cli_case(cook_list_candidates EXIT 0 WRITES parts.png
  STDOUT "that may be hair, likeliest first.* %  mesh '.*\"hair\": {\"meshes\": " ARGS cook ${sample} --list candidates -o parts.png)
coif_cli_case(cook_list_candidates_json EXIT 0 JSON sees_head candidates,0,probability candidates,0,features,crown candidates,0,recipe
  ARGS cook ${sample} --list candidates --format json)
coif_cli_case(cook_list_candidates_as_an_asset EXIT 1 STDERR "[.]png" ARGS cook ${sample} --list candidates -o parts.coif)
coif_cli_case(cook_list_of_a_source_behind_it EXIT 0 STDOUT "meshes\n" ARGS cook --list ${sample})
coif_cli_case(cook_list_patches EXIT 0 STDOUT "patches, [0-9]+ unsure where the root is [(][?][)]\n *index .*\n +0 +[1-9]" ARGS cook ${sample} --list patches)
coif_cli_case(cook_list_patches_json EXIT 0 WRITES p.png TIMEOUT 120
  JSON patches,0,index patches,0,island patches,0,middle,2 patches,0,size,2 patches,0,root patches,0,unsure patches,0,chain
       patches,0,mesh patches,0,material patches,0,triangles patches,0,kept path
  ARGS cook ${sample} --list patches -o p.png --format json)
coif_cli_case(cook_list_patches_elsewhere EXIT 1 STDERR "p.coif: the suffix must be .png" ARGS cook ${sample} --list patches -o p.coif)
coif_cli_case(cook_override_of_nothing EXIT 3
  STDERR "bob.glb: recipe key \"patches.overrides\" \\[1\\] selects none of the [0-9]+ patches; 'coif cook .* --list patches' lists them"
  TEXT r.json "{\"patches\": [{\"select\": {\"index\": 0}, \"root\": \"auto\"}, {\"select\": {\"mesh\": \"nobody\"}, \"keep\": false}]}"
  ARGS cook ${sample} --recipe r.json -o out.coif)

# What a checkout without Git LFS holds.
set(pointer "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a2146a0a7\nsize 396190\n")
coif_cli_case(cook_lfs_pointer EXIT 3 STDERR "coif cook: error: wig.fbx: Git LFS has not fetched what is in this file; run 'git lfs pull'"
  TEXT wig.fbx "${pointer}" ARGS cook wig.fbx -o wig.coif)
coif_cli_case(cook_lfs_texture EXIT 0 WRITES card.coif STDERR "card.png: Git LFS has not fetched what is in this file; run 'git lfs pull'; it is cooked without"
  TEXT card.obj "mtllib card.mtl\nv 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nusemtl hair\nf 1 2 3\n" card.mtl "newmtl hair\nmap_Kd card.png\n" card.png "${pointer}"
  ARGS cook card.obj -o card.coif)

# Said where it is wanted. A machine without a sandbox for readers of models says so, whatever it is told.
set(said_nothing "^(coif cook: warning: models are read without a full sandbox[^\n]*\n)?$")
coif_cli_case(cook_says_five_lines EXIT 0 WRITES card.coif
  STDOUT "^card.coif: 1 triangle [^\n]*\n[^\n]*simulated\n[^\n]*warnings?\n  [1-9][0-9]* notes, [0-9]+ things? left out: -v tells them\n  next: [^\n]*\n$"
  TEXT card.obj "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n" ARGS cook card.obj -o card.coif)
coif_cli_case(cook_names_files_that_it_read EXIT 0 WRITES card.coif
  STDOUT "\n  read: card.mtl\n.*  looked for in vain: lost.mtl\n" STDERR "'lost.mtl' is named for the materials and was not read: there is no"
  TEXT card.obj "mtllib lost.mtl\nmtllib card.mtl\nv 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nusemtl hair\nf 1 2 3\n" card.mtl "newmtl hair\nKd 1 0 0\n"
  ARGS cook card.obj -o card.coif -v)
coif_cli_case(cook_max_pass_seconds EXIT 3 TIMEOUT 120
  STDERR "coif cook: error: .*bob.glb: the pass '[a-z ]+' exceeded 1 s; use fewer triangles or strands, or allow more with --max-pass-seconds"
  TEXT R.json "{\"order\": {\"max_orders\": 32}}" ARGS cook ${sample} --recipe R.json -o out.coif --threads 1 --max-pass-seconds 1)
coif_cli_case(cook_quiet_and_verbose EXIT 1 STDERR "--quiet.*--verbose|--verbose.*--quiet" ARGS cook a.obj -o a.coif -q -v)
coif_cli_case(cook_absent_root EXIT 1 STDERR "--root: Directory does not exist: nowhere" ARGS cook a.obj -o a.coif --root nowhere)
coif_cli_case(cook_durable EXIT 0 WRITES card.coif report.json
  TEXT card.obj "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n" ARGS cook card.obj -o card.coif --report report.json --durable -q)
coif_cli_case(cook_quiet EXIT 0 WRITES out.coif STDERR "${said_nothing}" STDOUT "^$"
  TEXT R.json "{\"scene\": {\"draw\": false}}" ARGS cook ${sample} --recipe R.json -o out.coif --quiet)
coif_cli_case(cook_quiet_json EXIT 0 WRITES out.coif STDERR "${said_nothing}" JSON output bytes passes
  TEXT R.json "{\"scene\": {\"draw\": false}}" ARGS cook ${sample} --recipe R.json -o out.coif --quiet --format json)
coif_cli_case(cook_lost_materials EXIT 3
  STDERR "braid.obj: 'braid.mtl' is named for the materials and was not read.*warnings?, and --warnings-as-errors; nothing was written"
  TEXT braid.obj "mtllib braid.mtl\nv 0 1.7 0\nv 0.1 1.7 0\nv 0 1.5 0\nusemtl hair\nf 1 3 2\n" ARGS cook braid.obj -o out.coif --quiet --warnings-as-errors)

coif_cli_case(list_presets EXIT 0 STDOUT "realistic .*anime .*stylised .*ponytail .*curly .*short .*--print-recipe"
  ARGS cook --list-presets)
coif_cli_case(print_recipe_of_a_preset EXIT 0 STDOUT "\"preset\": \"curly\".*\"style\": \"curly\""
  ARGS cook --preset curly --print-recipe)
coif_cli_case(cook_by_an_unknown_preset EXIT 1 STDERR "--preset.*frizzy.*realistic"
  ARGS cook ${sample} --preset frizzy -o out.coif)
# Hair of 3 km is no hair: one number of the file is damaged.
coif_cli_case(cook_hair_of_kilometres EXIT 3 STDERR "far.obj: the hair is 3[.]0 km from end to end, .*export it again, or set \"source.metres_per_unit\""
  TEXT far.obj "o hair\nv 0 1.7 0\nv 0.1 1.7 0\nv 0 -3000 0\nv 0.1 1.4 0\nf 1 2 3\nf 2 4 3\n" ARGS cook far.obj -o far.coif)
