# coif_cook(TARGET name SOURCES file... [RECIPE r.json] [OUTPUT_DIRECTORY folder] [CACHE folder] [ROOTS folder...])
# A target, part of ALL, that cooks each source into OUTPUT_DIRECTORY/STEM.coif (default: the current binary directory), with
# the cook's report beside it as STEM.report.json. Without RECIPE each source takes the STEM.recipe.json beside it,
# if there is one. Files that a source names may also lie in ROOTS, for example as targets of links (coif cook --root). An asset is cooked
# again when its source, its recipe, a file that either of them reads (textures, buffers, material libraries) or the program
# changes. Only the cache notices a new image where none was found before, and only when something
# else changes. The target's property COIF_ASSETS lists the assets' paths.
# COIF_PROGRAM: the program, if it shall not be this build's, the installed one or that in PATH.
cmake_policy(VERSION 3.20)  # also what depfiles of the functions below mean

# Sets `result` to the program as a command names it.
function(coif_find_program result)
  if(NOT COIF_PROGRAM AND TARGET coif_cli)
    set(${result} coif_cli PARENT_SCOPE)
    return()
  endif()
  get_property(folder GLOBAL PROPERTY COIF_PROGRAM_FOLDER)
  find_program(COIF_PROGRAM coif HINTS "${folder}" DOC "The coif program")
  if(NOT COIF_PROGRAM)
    message(FATAL_ERROR "coif_cook: there is no program 'coif'; install coif built with COIF_TOOLS, or set COIF_PROGRAM")
  endif()
  set(${result} "${COIF_PROGRAM}" PARENT_SCOPE)
endfunction()

# Sets `result` to the recipe beside a source, or to nothing. One that appears later makes CMake run again.
function(coif_find_recipe source result)
  cmake_path(GET source PARENT_PATH folder)
  cmake_path(GET source STEM LAST_ONLY stem)
  file(GLOB recipes CONFIGURE_DEPENDS "${folder}/*.recipe.json")
  set(recipe "${folder}/${stem}.recipe.json")
  if(NOT recipe IN_LIST recipes)
    set(recipe "")
  endif()
  set(${result} "${recipe}" PARENT_SCOPE)
endfunction()

# Sets `result` to the rest of a command that works around a fault of CMake with depfiles. For Ninja, CMake (3.20 and all later
# versions so far) rewrites the file without doubling dollar signs. Then Ninja does not find a file such as "a$b.obj"
# and cooks it in every build. Dollar signs that are doubled once more beforehand survive.
function(coif_depfile_repair depfile result)
  set(${result} "" PARENT_SCOPE)
  if(CMAKE_GENERATOR MATCHES "Ninja")
    set(script "${CMAKE_BINARY_DIR}/CMakeFiles/coif_double_dollars.cmake")
    file(CONFIGURE OUTPUT "${script}" @ONLY CONTENT [[
file(READ "${DEPFILE}" text)
string(REPLACE "$" "$$" text "${text}")
file(WRITE "${DEPFILE}" "${text}")
]])
    set(${result} COMMAND "${CMAKE_COMMAND}" -D "DEPFILE=${depfile}" -P "${script}" PARENT_SCOPE)
  endif()
endfunction()

function(coif_cook)
  cmake_parse_arguments(PARSE_ARGV 0 COOK "" "TARGET;RECIPE;OUTPUT_DIRECTORY;CACHE" "SOURCES;ROOTS")
  if(NOT COOK_TARGET OR NOT COOK_SOURCES OR COOK_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "coif_cook: needs TARGET and SOURCES; unknown: '${COOK_UNPARSED_ARGUMENTS}'")
  endif()
  coif_find_program(program)
  if(NOT COOK_OUTPUT_DIRECTORY)
    set(COOK_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}")
  endif()
  cmake_path(ABSOLUTE_PATH COOK_OUTPUT_DIRECTORY BASE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}" NORMALIZE)
  file(MAKE_DIRECTORY "${COOK_OUTPUT_DIRECTORY}")
  set(options "")
  if(COOK_CACHE)
    cmake_path(ABSOLUTE_PATH COOK_CACHE BASE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}" NORMALIZE)
    list(APPEND options --cache "${COOK_CACHE}")
  endif()
  foreach(root IN LISTS COOK_ROOTS)
    cmake_path(ABSOLUTE_PATH root NORMALIZE)
    list(APPEND options --root "${root}")
  endforeach()
  list(LENGTH COOK_SOURCES count)
  if(count GREATER 1)
    list(APPEND options --threads 1)  # the build runs several cooks at once
  endif()
  set(assets "")
  foreach(source IN LISTS COOK_SOURCES)
    cmake_path(ABSOLUTE_PATH source NORMALIZE)
    set(recipe "${COOK_RECIPE}")
    if(recipe)
      cmake_path(ABSOLUTE_PATH recipe NORMALIZE)
    else()
      coif_find_recipe("${source}" recipe)
    endif()
    set(with_recipe "")
    if(recipe)
      set(with_recipe --recipe "${recipe}")
    endif()
    cmake_path(GET source STEM LAST_ONLY stem)
    cmake_path(APPEND COOK_OUTPUT_DIRECTORY "${stem}.coif" OUTPUT_VARIABLE asset)
    cmake_path(APPEND COOK_OUTPUT_DIRECTORY "${stem}.report.json" OUTPUT_VARIABLE report)
    coif_depfile_repair("${asset}.d" repair)
    add_custom_command(OUTPUT "${asset}" BYPRODUCTS "${report}"
      COMMAND "${program}" cook "${source}" -o "${asset}" --quiet ${with_recipe} ${options}
              --report "${report}" --depfile "${asset}.d"
      ${repair}
      DEPENDS "${source}" ${recipe} "${program}"
      DEPFILE "${asset}.d"
      COMMENT "Cooking ${stem}.coif"
      VERBATIM)
    list(APPEND assets "${asset}")
  endforeach()
  add_custom_target(${COOK_TARGET} ALL DEPENDS ${assets})
  set_target_properties(${COOK_TARGET} PROPERTIES COIF_ASSETS "${assets}")
endfunction()
