# What is done with a cooked asset. CASE names the test; FOLDER is empty, and its own.
cmake_minimum_required(VERSION 3.24)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

# Files cut at several lengths, and one with a changed byte. ASSET: a good one.
if(CASE STREQUAL "damaged_assets_are_refused")
  function(must_refuse name message)
    set(wanted 3)
    if(ARGN)
      set(wanted ${ARGN})
    endif()
    foreach(command "validate;${name}" "info;${name}" "simulate;${name};--motion;nod;-o;out.csv" "render;${name};-o;out.png")
      execute_process(COMMAND "${PROGRAM}" ${command} WORKING_DIRECTORY "${FOLDER}"
                      RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
      if(NOT code EQUAL wanted OR NOT err MATCHES "error: ${name}: ${message}")
        message(FATAL_ERROR "${command}: exit code ${code}, wanted ${wanted} and '${name}: ${message}'\n${err}")
      endif()
    endforeach()
  endfunction()

  foreach(cut "0:too short" "31:too short" "32:size differs" "1000:size differs")
    string(REPLACE ":" ";" cut "${cut}")
    list(GET cut 0 bytes)
    list(GET cut 1 message)
    execute_process(COMMAND head -c ${bytes} "${ASSET}" OUTPUT_FILE "${FOLDER}/cut_${bytes}.coif" COMMAND_ERROR_IS_FATAL ANY)
    must_refuse(cut_${bytes}.coif "${message}")
  endforeach()

  file(SIZE "${ASSET}" size)
  math(EXPR last "${size} - 1")
  execute_process(COMMAND head -c ${last} "${ASSET}" OUTPUT_FILE "${FOLDER}/head" COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE "${FOLDER}/byte" "?")
  execute_process(COMMAND cat head byte WORKING_DIRECTORY "${FOLDER}" OUTPUT_FILE "${FOLDER}/changed.coif"
                  COMMAND_ERROR_IS_FATAL ANY)
  must_refuse(changed.coif "chunk TEXD: the bytes were changed after cooking")

  # Of another major version, the ninth byte of a file: nothing is wrong with it, but this program cannot read it.
  execute_process(COMMAND head -c 8 "${ASSET}" OUTPUT_FILE "${FOLDER}/head" COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND tail -c +10 "${ASSET}" OUTPUT_FILE "${FOLDER}/tail" COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND cat head byte tail WORKING_DIRECTORY "${FOLDER}" OUTPUT_FILE "${FOLDER}/newer.coif"
                  COMMAND_ERROR_IS_FATAL ANY)
  must_refuse(newer.coif "cooked for another major version" 5)
endif()

# The sample at the longest step that is computed at once, 0.1 s, through every motion: all numbers finite, and no hair farther
# from the head than a stretched chain could be. ASSET: a cooked asset.
if(CASE STREQUAL "largest_step_stays_finite")
  foreach(motion still nod turn charge run jump tumble teleport)
    execute_process(COMMAND "${PROGRAM}" simulate "${ASSET}" --motion ${motion} --fps 10 --seconds 20 -o ${motion}.csv
                    WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
    if(NOT code EQUAL 0)
      message(FATAL_ERROR "simulate --motion ${motion} --fps 10: exit code ${code}\n${err}")
    endif()
    file(READ "${FOLDER}/${motion}.csv" csv)
    string(REGEX MATCHALL "\n[0-9]+," rows "${csv}")
    list(LENGTH rows count)
    if(count LESS 2000)
      message(SEND_ERROR "${motion}: ${count} rows, so nothing was checked")
    endif()
    if(csv MATCHES "[^a-z](nan|-nan|inf|-inf)")
      message(SEND_ERROR "${motion}: a position is not finite")
    endif()
    # Head-space coordinates are columns 5 to 7; two digits before the point would be 10 m, the length of the teleport.
    if(csv MATCHES "\n[0-9]+,[0-9.]+,[0-9]+,[A-Za-z0-9_]*,(-?[0-9.]+,)?(-?[0-9.]+,)?-?[0-9][0-9]+\\.[0-9]+,")
      message(SEND_ERROR "${motion}: hair is 10 m or more from its head: ${CMAKE_MATCH_0}")
    endif()
  endforeach()
endif()

# Without --substeps a step has as many parts as the asset was tuned for; with it, as many as were asked. ASSET: cooked.
if(CASE STREQUAL "simulate_follows_tuning")
  function(run_coif result)
    execute_process(COMMAND "${PROGRAM}" ${ARGN} WORKING_DIRECTORY "${FOLDER}"
                    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
    if(NOT code EQUAL 0)
      message(FATAL_ERROR "${ARGN}: exit code ${code}\n${err}")
    endif()
    set(${result} "${out}" PARENT_SCOPE)
  endfunction()

  function(simulate output)
    run_coif(ignored simulate "${ASSET}" --motion turn --fps 15 --seconds 1 -o ${output} ${ARGN})
  endfunction()

  run_coif(info info "${ASSET}" --format json)
  string(JSON rate GET "${info}" settings tuning substep_rate)
  string(REGEX REPLACE "[.].*" "" rate "${rate}")
  math(EXPR parts "(${rate} + 14) / 15")
  if(parts LESS 2)
    message(FATAL_ERROR "the asset asks for ${rate} Hz: one part a step, which says nothing")
  endif()

  simulate(tuned.csv)
  simulate(zero.csv --substeps 0)
  simulate(asked.csv --substeps ${parts})
  simulate(one.csv --substeps 1)
  file(READ "${FOLDER}/tuned.csv" tuned)
  foreach(other zero asked one)
    file(READ "${FOLDER}/${other}.csv" rows)
    if(other STREQUAL "one" AND rows STREQUAL tuned)
      message(FATAL_ERROR "--substeps 1 changed nothing")
    elseif(NOT other STREQUAL "one" AND NOT rows STREQUAL tuned)
      message(FATAL_ERROR "${other}.csv is not what ${rate} Hz give, ${parts} parts a step")
    endif()
  endforeach()
endif()

# A node's animation as the head's movement: reported, simulated and drawn; and what is wrong with a clip is said, with
# the exit code that scripts rely on. ASSET: cooked.
if(CASE STREQUAL "clips_move_heads")
  # A head that slides 0.3 m along Z and back within a second. BYTES: its buffer in base64, 48 bytes; COUNT: of its keys.
  function(write_clip name bytes count)
    file(WRITE "${FOLDER}/${name}" [=[{"asset": {"version": "2.0"}, "nodes": [{"name": "rig:head"}, {"name": "tail"}],
      "animations": [{"name": "slide", "samplers": [{"input": 0, "output": 1}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
      "bufferViews": [{"buffer": 0, "byteLength": 12}, {"buffer": 0, "byteOffset": 12, "byteLength": 36}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "type": "SCALAR", "count": ]=] "${count}"
      [=[}, {"bufferView": 1, "componentType": 5126, "type": "VEC3", "count": 3}],
      "buffers": [{"byteLength": 48, "uri": "data:application/octet-stream;base64,]=] "${bytes}" "\"}]}")
  endfunction()

  include("${CMAKE_CURRENT_LIST_DIR}/expect.cmake")

  set(bytes AAAAAAAAAD8AAIA/AAAAAAAAAAAAAAAAAAAAAAAAAACamZk+AAAAAAAAAAAAAAAA)
  write_clip(slide.gltf ${bytes} 3)
  set(report report "${ASSET}" accuracy --fps 60 --substeps 1 --seconds 1 --solver coif)
  expect(0 "\"motion\": \"slide.gltf:rig:head\"" ${report} --motion slide.gltf --format json)
  expect(0 "over 2 motions" ${report} --motion slide.gltf:rig:head --motion nod)
  expect(0 "slide.csv: motion slide.gltf:rig:head, 61 frames"
         simulate "${ASSET}" --motion slide.gltf --seconds 1 -o slide.csv)
  expect(0 "still.csv: motion still" simulate "${ASSET}" --motion still --seconds 1 -o still.csv)
  file(READ "${FOLDER}/slide.csv" slide)
  file(READ "${FOLDER}/still.csv" still)
  if(slide STREQUAL still)
    message(SEND_ERROR "the clip moved nothing")
  endif()

  # Refused, with what, where and how to cure it.
  foreach(command "report;${ASSET};accuracy" "simulate;${ASSET};-o;out.csv" "render;${ASSET};-o;out.png")
    expect(2 "error: absent.glb: cannot open" ${command} --motion absent.glb)
    expect(3 "error: slide.gltf: no node 'tale'; animated are 'rig:head'" ${command} --motion slide.gltf:tale)
    expect(3 "error: slide.gltf: node 'tail' does not move" ${command} --motion slide.gltf:tail)
  endforeach()
  write_clip(more.gltf ${bytes} 4)
  set(where "animation 'slide', translation of node 'rig:head': key times")
  expect(3 "more.gltf: ${where}: accessor 0 is cut off: 3 of 4 elements; export" ${report} --motion more.gltf)
  write_clip(nan.gltf AAAAAAAAwH8AAIA/AAAAAAAAAAAAAAAAAAAAAAAAAACamZk+AAAAAAAAAAAAAAAA 3)
  expect(3 "nan.gltf: .*key times: accessor 0 is not finite in element 1" ${report} --motion nan.gltf)
  string(SUBSTRING ${bytes} 0 40 part)
  write_clip(part.gltf ${part} 3)
  expect(3 "part.gltf: .*buffer 0 is cut off: 30 of 48 bytes" ${report} --motion part.gltf)
  file(WRITE "${FOLDER}/none.gltf" "{\"nodes\": []}")
  expect(3 "none.gltf: no animation moves a node; export" ${report} --motion none.gltf)
  file(WRITE "${FOLDER}/text.glb" "no model")
  expect(3 "text.glb: cannot be read as glTF 2.0" ${report} --motion text.glb)
  file(WRITE "${FOLDER}/old.fbx" "Kaydara")
  expect(5 "old.fbx: clips are read from .glb, .gltf and .vrm only; convert it to glTF" ${report} --motion old.fbx)
  if(EXISTS "${FOLDER}/out.csv" OR EXISTS "${FOLDER}/out.png")
    message(SEND_ERROR "a refused clip left a file behind")
  endif()
endif()

# The same asset gives the same sheet, byte for byte; another solver other moving pictures.
if(CASE STREQUAL "galleries_repeat")
  function(sheet name asset)
    execute_process(COMMAND "${PROGRAM}" gallery "${asset}" --size 64x64 ${ARGN} -o ${name}.png
                    WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE code ERROR_VARIABLE error)
    if(NOT code EQUAL 0)
      message(FATAL_ERROR "${name}: exit code ${code}\n${error}")
    endif()
    file(SHA256 "${FOLDER}/${name}.png" hash)
    set(${name} ${hash} PARENT_SCOPE)
  endfunction()
  sheet(first "${ASSET}")
  sheet(second "${ASSET}")
  sheet(moving "${ASSET}" --only 5)
  sheet(published "${ASSET}" --only 5 --solver thesis)
  sheet(still "${ASSET}" --only 4)
  if(NOT first STREQUAL second)
    message(SEND_ERROR "two sheets of ${ASSET} differ")
  endif()
  if(moving STREQUAL published)
    message(SEND_ERROR "Gallery 5 is the same by Algorithm 1 as by the asset's own solver")
  endif()
  if(first STREQUAL moving OR moving STREQUAL still)
    message(SEND_ERROR "--only changes nothing")
  endif()
endif()

# Hair that Algorithm 1 moves lies otherwise, and other draw orders suit it: those chunks differ, what moves it does not.
if(CASE STREQUAL "orders_follow_their_solver")
  foreach(solver coif thesis)
    file(WRITE "${FOLDER}/${solver}.json" "{\"order\": {\"solver\": \"${solver}\"}, \"textures\": {\"max_size\": 64}}")
    execute_process(COMMAND "${PROGRAM}" cook "${SOURCE}" --recipe ${solver}.json -o ${solver}.coif
                    WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE code ERROR_VARIABLE error OUTPUT_QUIET)
    if(NOT code EQUAL 0)
      message(FATAL_ERROR "${solver}: exit code ${code}\n${error}")
    endif()
    execute_process(COMMAND "${PROGRAM}" strip ${solver}.coif --without mesh,provenance -o moves.coif
                    WORKING_DIRECTORY "${FOLDER}" OUTPUT_QUIET)
    file(SHA256 "${FOLDER}/${solver}.coif" ${solver}_all)
    file(SHA256 "${FOLDER}/moves.coif" ${solver}_moves)
  endforeach()
  if(coif_all STREQUAL thesis_all)
    message(SEND_ERROR "order.solver changes no draw order")
  endif()
  if(NOT coif_moves STREQUAL thesis_moves)
    message(SEND_ERROR "order.solver changes more than draw orders")
  endif()
endif()

# Two assets of different hair: exit code 3 and a message that says how far apart they are.
if(CASE STREQUAL "compare_refuses_other_hair")
  file(WRITE "${FOLDER}/card.obj" "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
  file(WRITE "${FOLDER}/other.obj" "v 0 0 0.5\nv 1 0 0.5\nv 0 1 0.5\nf 1 2 3\n")

  foreach(name card other)
    execute_process(COMMAND "${PROGRAM}" cook ${name}.obj -o ${name}.coif WORKING_DIRECTORY "${FOLDER}"
                    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
    if(NOT code EQUAL 0)
      message(FATAL_ERROR "cook ${name}.obj: exit code ${code}\n${err}")
    endif()
  endforeach()
  execute_process(COMMAND "${PROGRAM}" compare card.coif other.coif WORKING_DIRECTORY "${FOLDER}"
                  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  set(wanted "coif compare: error: card.coif and other.coif: the two surfaces differ at rest by .* mm RMS or more")
  if(NOT code EQUAL 3 OR NOT err MATCHES "${wanted}")
    message(FATAL_ERROR "exit code ${code}, wanted 3 and '${wanted}'\n${err}")
  endif()
endif()
