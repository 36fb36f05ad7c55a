# What the tests of the cook's cache share: a card with a material library and a texture, and cook().
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

function(write_card name)
  set(corners "v 0 0 0\nv 0.1 0 0\nv 0 0.3 0\nvt 0 0\nvt 1 0\nvt 0 1\n")
  file(WRITE "${FOLDER}/${name}.obj" "mtllib ${name}.mtl\n${corners}usemtl hair\nf 1/1 2/2 3/3\n")
  file(WRITE "${FOLDER}/${name}.mtl" "newmtl hair\nmap_Kd ${name}.png\n")
  file(WRITE "${FOLDER}/quick.json" "{\"order\": {\"method\": \"head\"}}")
endfunction()

# cook(ARGUMENTS...): in FOLDER; sets code, out and err.
function(cook)
  # What was written just before must be older than the cook, by the file system's coarse clock.
  execute_process(COMMAND ${CMAKE_COMMAND} -E sleep 0.05)
  execute_process(COMMAND "${PROGRAM}" cook ${ARGN} WORKING_DIRECTORY "${FOLDER}"
                  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  foreach(result code out err)
    set(${result} "${${result}}" PARENT_SCOPE)
  endforeach()
endfunction()

function(must_be_same a b)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files "${FOLDER}/${a}" "${FOLDER}/${b}" RESULT_VARIABLE differs)
  if(differs)
    message(FATAL_ERROR "${a} and ${b} differ")
  endif()
endfunction()

# must_take(hit|miss WHY SOURCE): cooks SOURCE with the cache, which must hold it or not, and without; the assets and what
# is told of them must be the same.
function(must_take kind why source)
  cook(${source} --recipe quick.json --cache cache -o cached.coif --report report.json)
  set(cached_err "${err}")
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${why}: exit code ${code}\n${err}")
  endif()
  file(READ "${FOLDER}/report.json" report)
  string(JSON from_cache GET "${report}" from_cache)
  if((kind STREQUAL "hit") AND NOT (from_cache AND out MATCHES "bytes from the cache"))
    message(FATAL_ERROR "${why}: was not taken from the cache\n${out}\n${err}")
  elseif((kind STREQUAL "miss") AND (from_cache OR out MATCHES "from the cache"))
    message(FATAL_ERROR "${why}: was taken from the cache\n${out}")
  endif()
  cook(${source} --recipe quick.json -o plain.coif)
  must_be_same(cached.coif plain.coif)
  if(NOT err STREQUAL cached_err)
    message(FATAL_ERROR "${why}: messages differ\n--- with the cache\n${cached_err}--- without\n${err}")
  endif()
endfunction()
