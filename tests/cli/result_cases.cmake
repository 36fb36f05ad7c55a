# What the other verbs print and write.
coif_cli_case(info_text EXIT 0 SAMPLE STDOUT "bob.coif: format 1.0, .*triangles .*settings.*friction.*chunks.*SKEL"
  ARGS info ${COIF_COOKED_SAMPLE})
coif_cli_case(info_json EXIT 0 SAMPLE
  JSON format,major format,minor bytes chunks,0,id chunks,0,bytes triangles vertices patches chains bones
       simulated_bones twisting_bones settings collider_shapes colliding_bones lods textures,0,format sides shading
  ARGS info ${COIF_COOKED_SAMPLE} --format json)
coif_cli_case(info_text_shows_tuning EXIT 0 SAMPLE
  STDOUT "stiffness.*damping.*torsion.*angle_limit .*180 [.][.] 180.*parent_share.*tuning [(]met[)].*30 [.][.] 120 .*Hz.*asked: 2 %.*ns per head.*quality .*worst motion\n +30 .* +[1-9][0-9]*  [a-z]+\n +"
  ARGS info ${COIF_COOKED_SAMPLE})
coif_cli_case(info_json_shows_tuning EXIT 0 SAMPLE
  JSON settings,resistance,1 settings,stiffness,1 settings,damping,1 settings,torsion,1 settings,angle_limit,1
       settings,parent_share,1 settings,tuning,substep_rate settings,tuning,asked_error_pct
       settings,tuning,reached_error_pct settings,tuning,asked_ns settings,tuning,nominal_ns
       settings,tuning,slowest_rate settings,tuning,fastest_rate settings,tuning,met
       quality,0,frame_rate quality,0,substeps quality,0,rms_error_pct quality,0,max_error_pct quality,0,stretch_pct
       quality,0,penetration_pct quality,0,nominal_ns quality,0,worst_motion quality,2,frame_rate
  ARGS info ${COIF_COOKED_SAMPLE} --format json)
coif_cli_case(info_of_an_older_asset EXIT 0 STDOUT "worst motion\n +[0-9]+ .*  (still|nod|turn|charge|run|jump|tumble|teleport|bow|lie)\n"
  ARGS info ${PROJECT_SOURCE_DIR}/sample_assets/versions/1.0.coif)
coif_cli_case(simulate_jog EXIT 0 SAMPLE WRITES jog.csv STDOUT "jog.csv: motion jog, 61 frames of [0-9]+ bones at 30 per second"
  ARGS simulate ${COIF_COOKED_SAMPLE} --motion jog --fps 30 --seconds 2 -o jog.csv)
coif_cli_case(info_text_file EXIT 3 STDERR "coif info: error: notes.coif: not a cooked hair asset; give a file written by"
  TEXT notes.coif "this text is long enough for a header" ARGS info notes.coif)

coif_cli_case(simulate_csv EXIT 0 SAMPLE WRITES turn.csv
  STDOUT "turn.csv: motion turn, 31 frames of [0-9]+ bones at 30 per second.*worst stretch"
  ARGS simulate ${COIF_COOKED_SAMPLE} --motion turn --fps 30 --seconds 1 -o turn.csv)
coif_cli_case(simulate_glb EXIT 0 SAMPLE WRITES nod.GLB
  JSON output motion fps frames bones scale stretch_max_pct penetration_max_pct from_rest_pct last_speed_m_s
  ARGS simulate ${COIF_COOKED_SAMPLE} --motion nod --seconds 1 -o nod.GLB --format json)
coif_cli_case(simulate_uneven_frames EXIT 0 SAMPLE WRITES uneven.csv
  STDOUT "uneven.csv: motion attitude 1,0,-1, 5 frames of [0-9]+ bones at 0.3, 0.2 seconds by turns"
  ARGS simulate ${COIF_COOKED_SAMPLE} --attitude 1,0,-1 --frame-lengths 0.3,0.2 --seconds 1 -o uneven.csv)
coif_cli_case(simulate_jittered_frames EXIT 0 SAMPLE WRITES jitter.csv JSON pace scale
  ARGS simulate ${COIF_COOKED_SAMPLE} --motion nod --jitter 0.3,7 --seconds 1 --scale 0.5 -o jitter.csv --format json)
coif_cli_case(simulate_text_file EXIT 3 STDERR "coif simulate: error: notes.coif: not a cooked hair asset"
  TEXT notes.coif "this text is long enough for a header" ARGS simulate notes.coif --motion nod -o nod.csv)

coif_cli_case(render_text EXIT 0 SAMPLE WRITES bob.png STDOUT "bob.png: 320x240, 1 head .*device: "
  ARGS render ${COIF_COOKED_SAMPLE} --size 320x240 -o bob.png)
coif_cli_case(render_json EXIT 0 SAMPLE WRITES bob.png JSON output width height heads triangles draw_ms device
  ARGS render ${COIF_COOKED_SAMPLE} --size 320x240 --view=-30,5 --motion nod --time 0.5 --transparency opaque
       --component specular --heads 4 -o bob.png --format json)
coif_cli_case(look_asset EXIT 0 SAMPLE WRITES look.png TIMEOUT 120 STDOUT "look.png: 368x[0-9]+, 20 pictures\n  device: "
  ARGS look ${COIF_COOKED_SAMPLE} --size 64x64 -o look.png)
coif_cli_case(look_source EXIT 0 WRITES look.png TIMEOUT 120 JSON output width height pictures device
  ARGS look ${PROJECT_SOURCE_DIR}/sample_assets/bob/bob.glb --size 64x64 -o look.png --format json)
coif_cli_case(look_small_pictures EXIT 1 SAMPLE
  STDERR "coif look: error: .*bob.coif: a picture of a sheet has 64 to 1024 pixels each way, not 32 x 64"
  ARGS look ${COIF_COOKED_SAMPLE} --size 32x64 -o look.png)
coif_cli_case(look_text_file EXIT 3 STDERR "coif look: error: notes.coif: not a cooked hair asset"
  TEXT notes.coif "this text is long enough for a header" ARGS look notes.coif -o look.png)
coif_cli_case(look_no_png EXIT 1 SAMPLE STDERR "coif look: error: look.jpg: the suffix must be .png"
  ARGS look ${COIF_COOKED_SAMPLE} -o look.jpg)

coif_cli_case(gallery_text EXIT 0 SAMPLE WRITES sheet.png TIMEOUT 120
  STDOUT "sheet.png: 440x[0-9]+, 96 pictures, drawn in [0-9.]+ ms\n  device: "
  ARGS gallery ${COIF_COOKED_SAMPLE} --size 64x64 -o sheet.png)
coif_cli_case(gallery_json EXIT 0 SAMPLE WRITES sheet.png JSON output width height pictures draw_ms device
  ARGS gallery ${COIF_COOKED_SAMPLE} --only 4 --size 64x80 -o sheet.png --format json)
coif_cli_case(gallery_small_pictures EXIT 1 SAMPLE
  STDERR "coif gallery: error: .*bob.coif: a picture of a sheet has 64 to 1024 pixels each way, not 32 x 64"
  ARGS gallery ${COIF_COOKED_SAMPLE} --size 32x64 -o sheet.png)
coif_cli_case(gallery_text_file EXIT 3 STDERR "coif gallery: error: notes.coif: not a cooked hair asset"
  TEXT notes.coif "this text is long enough for a header" ARGS gallery notes.coif -o sheet.png)
coif_cli_case(gallery_no_folder EXIT 2 SAMPLE STDERR "coif gallery: error: .*nowhere"
  ARGS gallery ${COIF_COOKED_SAMPLE} --only 1 -o nowhere/sheet.png)
coif_cli_case(render_gusts EXIT 0 SAMPLE WRITES bob.png STDOUT "bob.png: 320x240, 1 head "
  ARGS render ${COIF_COOKED_SAMPLE} --size 320x240 --motion still --time 0.5 --wind 3,0,0 --gusts 4,1,3 -o bob.png)
coif_cli_case(render_direction EXIT 0 SAMPLE WRITES bob.png
  ARGS render ${COIF_COOKED_SAMPLE} --size 320x240 --component direction -o bob.png)
coif_cli_case(render_patches EXIT 0 SAMPLE WRITES bob.png
  ARGS render ${COIF_COOKED_SAMPLE} --size 320x240 --component patches --lod 0 -o bob.png)
coif_cli_case(render_colliders EXIT 0 SAMPLE WRITES bob.png
  ARGS render ${COIF_COOKED_SAMPLE} --size 320x240 --component colliders -o bob.png)
coif_cli_case(render_debug EXIT 0 SAMPLE WRITES bob.png
  ARGS render ${COIF_COOKED_SAMPLE} --size 64x48 --samples 1 --debug bones,colliders,contacts,limits,motion -o bob.png)
foreach(shading thesis kajiya-kay marschner volume)
  coif_cli_case(render_${shading} EXIT 0 SAMPLE WRITES bob.png
    ARGS render ${COIF_COOKED_SAMPLE} --size 320x240 --shading ${shading} -o bob.png)
endforeach()
foreach(shadows none plain opacity deep deep-shadow)
  coif_cli_case(render_shadows_${shadows} EXIT 0 SAMPLE WRITES bob.png
    ARGS render ${COIF_COOKED_SAMPLE} --size 320x240 --shadows ${shadows} --heads 2 -o bob.png)
endforeach()
foreach(way checkerboard bayer proportional jittered)
  coif_cli_case(render_${way} EXIT 0 SAMPLE WRITES bob.png
    ARGS render ${COIF_COOKED_SAMPLE} --size 64x48 --samples 1 --transparency ${way} -o bob.png)
endforeach()
coif_cli_case(render_by_bones EXIT 0 SAMPLE WRITES bob.png
  ARGS render ${COIF_COOKED_SAMPLE} --size 64x48 --samples 1 --order bones --motion turn --time 0.3 -o bob.png)
coif_cli_case(render_no_such_lod EXIT 1 SAMPLE STDERR "bob.coif: there is no level of detail 9; the asset has [0-9], counted"
  ARGS render ${COIF_COOKED_SAMPLE} --size 320x240 --lod 9 -o bob.png)
coif_cli_case(render_body EXIT 0 SAMPLE WRITES bob.png
  ARGS render ${COIF_COOKED_SAMPLE} --size 320x240 --body ${sample} -o bob.png)
coif_cli_case(render_body_without_hair EXIT 0 SAMPLE WRITES bob.png
  ARGS render ${COIF_COOKED_SAMPLE} --size 64x48 --samples 1 --body ${PROJECT_SOURCE_DIR}/sample_assets/portrait/portrait.glb -o bob.png)
foreach(lights studio sun rim plain)
  coif_cli_case(render_lights_${lights} EXIT 0 SAMPLE WRITES bob.png
    ARGS render ${COIF_COOKED_SAMPLE} --size 64x48 --samples 1 --lights ${lights} --backdrop clear -o bob.png)
endforeach()
coif_cli_case(render_more_samples_than_there_are EXIT 0 SAMPLE WRITES bob.png
  ARGS render ${COIF_COOKED_SAMPLE} --size 64x48 --samples 64 -o bob.png)
coif_cli_case(render_no_such_body_mesh EXIT 3 SAMPLE STDERR "no mesh is left for the body; give --body-mesh one of '"
  ARGS render ${COIF_COOKED_SAMPLE} --size 320x240 --body ${sample} --body-mesh nothing -o bob.png)
