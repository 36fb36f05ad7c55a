# A head of hair whose file says other than it is: what 'coif cook' and 'coif validate' make of it.
cmake_minimum_required(VERSION 3.24)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

# Hair around a head of radius 10, half as long again as it is wide; x, up, front.
set(points
  "2.29 9 3.28" "3.51 9 1.92" "4 9 0.16" "3.65 9 -1.63" "2.55 9 -3.08" "0.91 9 -3.89"
  "-0.91 9 -3.89" "-2.55 9 -3.08" "-3.65 9 -1.63" "-4 9 0.16" "-3.51 9 1.92" "-2.29 9 3.28"
  "4.02 7 5.73" "6.14 7 3.35" "6.99 7 0.28" "6.39 7 -2.86" "4.46 7 -5.4" "1.6 7 -6.82"
  "-1.6 7 -6.82" "-4.46 7 -5.4" "-6.39 7 -2.86" "-6.99 7 0.28" "-6.14 7 3.35" "-4.02 7 5.73"
  "5.45 3 7.78" "8.34 3 4.55" "9.49 3 0.38" "8.67 3 -3.88" "6.05 3 -7.33" "2.17 3 -9.25"
  "-2.17 3 -9.25" "-6.05 3 -7.33" "-8.67 3 -3.88" "-9.49 3 0.38" "-8.34 3 4.55" "-5.45 3 7.78"
  "5.74 0 8.19" "8.78 0 4.79" "9.99 0 0.4" "9.13 0 -4.08" "6.37 0 -7.71" "2.28 0 -9.74"
  "-2.28 0 -9.74" "-6.37 0 -7.71" "-9.13 0 -4.08" "-9.99 0 0.4" "-8.78 0 4.79" "-5.74 0 8.19"
  "6.02 -15 8.6" "9.22 -15 5.03" "10.49 -15 0.42" "9.59 -15 -4.29" "6.69 -15 -8.1" "2.39 -15 -10.22"
  "-2.39 -15 -10.22" "-6.69 -15 -8.1" "-9.59 -15 -4.29" "-10.49 -15 0.42" "-9.22 -15 5.03" "-6.02 -15 8.6"
  "6.31 -30 9.01" "9.65 -30 5.27" "10.99 -30 0.44" "10.04 -30 -4.49" "7 -30 -8.48" "2.51 -30 -10.71"
  "-2.51 -30 -10.71" "-7 -30 -8.48" "-10.04 -30 -4.49" "-10.99 -30 0.44" "-9.65 -30 5.27" "-6.31 -30 9.01"
  "6.31 -45 9.01" "9.65 -45 5.27" "10.99 -45 0.44" "10.04 -45 -4.49" "7 -45 -8.48" "2.51 -45 -10.71"
  "-2.51 -45 -10.71" "-7 -45 -8.48" "-10.04 -45 -4.49" "-10.99 -45 0.44" "-9.65 -45 5.27" "-6.31 -45 9.01")
string(CONCAT triangles
  "0 12 1 1 12 13 1 13 2 2 13 14 2 14 3 3 14 15 3 15 4 4 15 16 4 16 5 5 16 17 5 17 6 6 17 18 6 18 7 7 18 19 7 19 "
  "8 8 19 20 8 20 9 9 20 21 9 21 10 10 21 22 10 22 11 11 22 23 12 24 13 13 24 25 13 25 14 14 25 26 14 26 15 15 26 "
  "27 15 27 16 16 27 28 16 28 17 17 28 29 17 29 18 18 29 30 18 30 19 19 30 31 19 31 20 20 31 32 20 32 21 21 32 33 "
  "21 33 22 22 33 34 22 34 23 23 34 35 24 36 25 25 36 37 25 37 26 26 37 38 26 38 27 27 38 39 27 39 28 28 39 40 28 "
  "40 29 29 40 41 29 41 30 30 41 42 30 42 31 31 42 43 31 43 32 32 43 44 32 44 33 33 44 45 33 45 34 34 45 46 34 46 "
  "35 35 46 47 36 48 37 37 48 49 37 49 38 38 49 50 38 50 39 39 50 51 39 51 40 40 51 52 40 52 41 41 52 53 41 53 42 "
  "42 53 54 42 54 43 43 54 55 43 55 44 44 55 56 44 56 45 45 56 57 45 57 46 46 57 58 46 58 47 47 58 59 48 60 49 49 "
  "60 61 49 61 50 50 61 62 50 62 51 51 62 63 51 63 52 52 63 64 52 64 53 53 64 65 53 65 54 54 65 66 54 66 55 55 66 "
  "67 55 67 56 56 67 68 56 68 57 57 68 69 57 69 58 58 69 70 58 70 59 59 70 71 60 72 61 61 72 73 61 73 62 62 73 74 "
  "62 74 63 63 74 75 63 75 64 64 75 76 64 76 65 65 76 77 65 77 66 66 77 78 66 78 67 67 78 79 67 79 68 68 79 80 68 "
  "80 69 69 80 81 69 81 70 70 81 82 70 82 71 71 82 83 ")

# write_dae(NAME METRES_PER_UNIT UP): UP is y or z; the file says Y either way.
function(write_dae name unit up)
  set(numbers "")
  foreach(point IN LISTS points)
    string(REPLACE " " ";" point "${point}")
    list(GET point 0 x)
    list(GET point 1 height)
    list(GET point 2 front)
    if(up STREQUAL "y")
      string(APPEND numbers "${x} ${height} ${front} ")
    else()
      string(REGEX REPLACE "^--" "" back "-${front}")
      string(APPEND numbers "${x} ${back} ${height} ")
    endif()
  endforeach()
  list(LENGTH points count)
  math(EXPR numbers_count "3 * ${count}")
  string(REGEX MATCHALL "[0-9]+" corners "${triangles}")
  list(LENGTH corners corner_count)
  math(EXPR triangle_count "${corner_count} / 3")
  file(WRITE "${FOLDER}/${name}.dae" "<?xml version=\"1.0\"?>
<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">
<asset><unit meter=\"${unit}\"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id=\"hair\" name=\"hair\"><mesh>
<source id=\"p\"><float_array id=\"a\" count=\"${numbers_count}\">${numbers}</float_array><technique_common>
<accessor source=\"#a\" count=\"${count}\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor>
</technique_common></source>
<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>
<triangles count=\"${triangle_count}\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>${triangles}</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id=\"s\"><node id=\"n\" name=\"hair\"><instance_geometry url=\"#hair\"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>
")
endfunction()

# run(EXIT STDERR ARGS...): STDERR is what must be said there; "" for nothing of size or axis.
function(run wanted text)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL wanted)
    message(FATAL_ERROR "${ARGN}: exit code ${code}, wanted ${wanted}\n${err}")
  endif()
  if(text STREQUAL "" AND err MATCHES "metres_per_unit|up_axis")
    message(FATAL_ERROR "${ARGN}: nothing to say of size or axis, and yet:\n${err}")
  endif()
  if(NOT err MATCHES "${text}")
    message(FATAL_ERROR "${ARGN}: standard error lacks '${text}':\n${err}")
  endif()
endfunction()

write_dae(right 0.01 y)
write_dae(metres 1 y)
write_dae(lying 0.01 z)
write_dae(doll 0.0015 y)
file(WRITE "${FOLDER}/metres.json" "{\"source\": {\"metres_per_unit\": 1}}")
file(WRITE "${FOLDER}/y.json" "{\"source\": {\"up_axis\": \"y\"}}")

run(0 "" validate right.dae)
run(0 "" cook right.dae --draft -o right.coif)
set(lost "the file's unit .<unit meter=.1.>. would make .*usually .*; taken as 0.01 m per unit instead.*: set \"source.metres_per_unit\": 1 in the recipe if the file is right")
run(0 "metres.dae: ${lost} .S207." validate metres.dae)
run(3 "S207" validate metres.dae --warnings-as-errors)
run(0 "metres.dae: ${lost}" cook metres.dae --draft -o metres.coif)
run(0 "metres.dae: ${lost}" render right.coif -o body.png --size 16x16 --body metres.dae --body-mesh hair)
run(0 "right.dae: has nothing but the hair; drawn as without --body" render right.coif -o body.png --size 16x16 --body right.dae)
run(3 "nothing was written" cook metres.dae --draft --warnings-as-errors -o other.coif)
set(given "the recipe's \"source.metres_per_unit\": 1 makes .*usually .*; 0.01 would make .*: check it")
run(0 "metres.dae: ${given} .S208." validate metres.dae --recipe metres.json)
run(0 "metres.dae: ${given}" cook metres.dae --draft --recipe metres.json -o given.coif)
run(0 "doll.dae: the unit is doubtful: 0.0015 m per unit .*S208" validate doll.dae)
set(lies "up is the file's .Z and not what it says .<up_axis>.: with that, hair falls from the head.*: set \"source.up_axis\": \"y\" in the recipe if the file is right")
run(0 "lying.dae: ${lies} .S209." validate lying.dae)
run(0 "lying.dae: ${lies}" cook lying.dae --draft -o lying.coif)
run(0 "lying.dae: the recipe's \"source.up_axis\": \"y\" is doubtful: .*: check it .S210." validate lying.dae --recipe y.json)

# All that were taken for what they are came out alike, and the one whose recipe lies did not.
function(bones name variable)
  execute_process(COMMAND "${PROGRAM}" info ${name}.coif --format json WORKING_DIRECTORY "${FOLDER}" OUTPUT_VARIABLE out RESULT_VARIABLE code)
  string(JSON count GET "${out}" simulated_bones)
  set(${variable} ${count} PARENT_SCOPE)
endfunction()
bones(right wanted)
if(wanted LESS 1)
  message(FATAL_ERROR "no bone is simulated, so that nothing can differ")
endif()
foreach(name IN ITEMS metres lying)
  bones(${name} count)
  if(NOT count EQUAL wanted)
    message(FATAL_ERROR "${name}: ${count} simulated bones, and ${wanted} of the same hair from right.dae")
  endif()
endforeach()
