# The batches of a manifest together make what one cook of all of it makes; the cook of all finds their work in the cache.
cmake_minimum_required(VERSION 3.24)
include(${CMAKE_CURRENT_LIST_DIR}/cached_cook.cmake)
file(MAKE_DIRECTORY "${FOLDER}/out" "${FOLDER}/whole")
foreach(name one two three four five)
  write_card(${name})
endforeach()
file(WRITE "${FOLDER}/three.obj" "v 0 0 0\n")
file(WRITE "${FOLDER}/list.json" "{\"assets\": [
  {\"source\": \"one.obj\", \"recipe\": \"quick.json\"},
  {\"source\": \"two.obj\", \"recipe\": \"quick.json\", \"output\": \"deep/down/second.coif\"},
  // a source without anything to cook
  \"three.obj\",
  {\"source\": \"four.obj\", \"recipe\": \"quick.json\"},
  {\"source\": \"five.obj\", \"recipe\": \"quick.json\"}]}")

function(must_hold what text regex)
  if(NOT "${text}" MATCHES "${regex}")
    message(FATAL_ERROR "${what} lacks: ${regex}\n${text}")
  endif()
endfunction()

cook(--manifest list.json -o out --cache cache --batch 1/2)
must_hold("exit code" "${code}" "^3$")
must_hold("batch 1" "${out}" "one.obj .*three.obj .*five.obj .*\n3 asked, 2 cooked [(]0 from the cache[)], 1 failed\n$")
cook(--manifest list.json -o out --cache cache --batch 2/2)
must_hold("exit code" "${code}" "^0$")
must_hold("batch 2" "${out}" "two.obj .*four.obj .*\n2 asked, 2 cooked [(]0 from the cache[)], 0 failed\n$")
file(GLOB_RECURSE made RELATIVE "${FOLDER}/out" "${FOLDER}/out/*")
must_hold("folder" "${made}" "^deep/down/second.coif;five.coif;four.coif;one.coif$")

cook(--manifest list.json -o whole --cache cache --report page.html --format json)
must_hold("exit code" "${code}" "^3$")
foreach(wanted asked=5 cooked=4 from_cache=4 failed=1)
  string(REPLACE "=" ";" pair "${wanted}")
  list(POP_FRONT pair key)
  string(JSON found GET "${out}" ${key})
  if(NOT found STREQUAL pair)
    message(FATAL_ERROR "JSON ${key}: ${found}, not ${pair}")
  endif()
endforeach()
foreach(asset ${made})
  must_be_same(out/${asset} whole/${asset})
endforeach()

# The page begins with what failed, and shows what was cooked.
file(READ "${FOLDER}/page.html" page)
must_hold("page" "${page}" "5 asked, 4 cooked [(]4 from the cache[)], 1 failed[.].*three.obj<.*one.obj<")
string(REGEX MATCHALL "base64,iVBOR" pictures "${page}")
list(LENGTH pictures count)
if(NOT (count EQUAL 4 OR page MATCHES "not drawn"))
  message(FATAL_ERROR "the page shows ${count} pictures of 4 assets")
endif()
