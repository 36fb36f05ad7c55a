# A node's animation as the head's movement: reported, simulated and drawn; and what is wrong with a clip is said, with
# the exit code that scripts rely on. ASSET: cooked.
cmake_minimum_required(VERSION 3.24)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

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

function(expect code text)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} WORKING_DIRECTORY "${FOLDER}"
                  RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT result EQUAL code OR NOT "${out}${err}" MATCHES "${text}")
    message(SEND_ERROR "${ARGN}: exit code ${result}, wanted ${code} and: ${text}\n${out}${err}")
  endif()
endfunction()

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
