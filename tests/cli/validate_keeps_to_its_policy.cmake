# Which issues count, which are shown, and what that does to the exit code. ASSET: cooked from SOURCE.
cmake_minimum_required(VERSION 3.24)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

include("${CMAKE_CURRENT_LIST_DIR}/expect.cmake")

# judge(CODE SHOWN HIDDEN ARGS...): expect_of() of `coif validate ARGS`.
function(judge code shown hidden)
  expect_of("${code}" "${shown}" "${hidden}" validate ${ARGN})
endfunction()

function(strip chunks name)
  execute_process(COMMAND "${PROGRAM}" strip "${ASSET}" -o ${name} --without ${chunks} WORKING_DIRECTORY "${FOLDER}"
                  RESULT_VARIABLE result ERROR_VARIABLE err OUTPUT_QUIET)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "strip ${chunks}: ${err}")
  endif()
endfunction()

# A warning (no collider) and a note (no texture).
strip(COLL,TEXR bare.coif)
judge(0 "warning: bare.coif: no collider.*A203.*note: bare.coif: no base colour.*A204" "error:" bare.coif)
judge(0 "A203" "A204" bare.coif --severity warning)
judge(0 "bare.coif: valid" "A20" bare.coif --severity error)
judge(0 "A204" "A203" bare.coif --ignore A203)
judge(3 "bare.coif: invalid.*error: bare.coif: no collider.*note: .*A204" "warning:" bare.coif --warnings-as-errors)
judge(0 "bare.coif: valid" "A20" bare.coif --warnings-as-errors --ignore A203 --ignore A204)
judge(3 "bare.coif: invalid" "" "${ASSET}" bare.coif --warnings-as-errors)

# What lacks its origin is not known to match, unless a new cook shows it.
strip(PROV orphan.coif)
judge(0 "orphan.coif: valid" "R105" orphan.coif)
judge(3 "error: orphan.coif: it does not say what it was cooked from.*R105" "" orphan.coif --source "${SOURCE}")
judge(3 "error: bare.coif: cooked anew, it has other chunks .*COLL.*R106" "R10[1-5]" bare.coif --source "${SOURCE}"
       --recook)

# Seven meshes with the same fault.
set(rags "")
foreach(i RANGE 6)
  math(EXPR a "3 * ${i} + 1")
  math(EXPR b "3 * ${i} + 2")
  math(EXPR c "3 * ${i} + 3")
  string(APPEND rags "o hair_${i}\nv 0 0 ${i}\nv 0.1 0.2 ${i}\nv 0.2 0 ${i}\nf ${a} ${b} ${c}\n")
endforeach()
file(WRITE "${FOLDER}/rags.obj" "${rags}")
judge(0 "hair_1'.*hair_4'.*rags.obj: 2 more like this .S203." "hair_5'" rags.obj)
judge(0 "hair_0'.*rags.obj: 6 more like this .S203." "hair_1'" rags.obj --max-issues 1)
judge(0 "hair_6'" "more like this" rags.obj --max-issues 7)
