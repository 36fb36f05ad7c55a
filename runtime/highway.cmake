# Highway, the simulation's SIMD library, and the instruction sets of a build. No public header includes it.
#   COIF_SIMD=dispatch                         all that the compiler knows, chosen at run time; links libhwy
#   COIF_SIMD=static                           the one that the compiler's flags allow; needs Highway's headers only
#   COIF_SIMD=scalar|sse4|avx2|avx512|neon|wasm    as static; where the flags do not allow it, configuring fails

# Highway requires all of Haswell for AVX2 (FMA, F16C, and AES and PCLMUL, which x86-64-v3 does not have),
# and ARM's crypto extensions for NEON. The simulation uses none of them. It never uses FMA, since no instruction
# set may round once where another rounds twice. SSSE3 adds nothing to the portable code and SSE4, and AVX3_DL adds only
# an error with -march=native to AVX3. Vectors without a fixed size cannot be members. So ARM has only NEON, and
# there is no choice at run time.
set(COIF_HIGHWAY_DEFINITIONS HWY_DISABLE_PCLMUL_AES HWY_DISABLE_BMI2_FMA HWY_DISABLE_F16C TOOLCHAIN_MISS_SYS_AUXV_H
  "HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_AVX3_DL|HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128|HWY_RVV)")
if(NOT COIF_SIMD STREQUAL "dispatch")
  list(APPEND COIF_HIGHWAY_DEFINITIONS HWY_COMPILE_ONLY_STATIC)
endif()

# coif_find_highway(): sets COIF_HIGHWAY_HEADERS to the folder of its headers, or to nothing if the compiler finds them.
function(coif_find_highway)
  find_package(hwy QUIET GLOBAL)  # whoever links the library in the same build links this with it
  if(hwy_FOUND)
    get_target_property(folders hwy::hwy INTERFACE_INCLUDE_DIRECTORIES)
  elseif(COIF_SIMD STREQUAL "dispatch")
    message(FATAL_ERROR "COIF_SIMD=dispatch needs Highway's library for the target system (Debian: libhwy-dev); "
                        "-DCOIF_SIMD=static needs its headers only")
  else()
    if(EMSCRIPTEN)
      set(anywhere PATHS /usr/local/include /usr/include NO_CMAKE_FIND_ROOT_PATH)  # no package of Highway is for it, and headers are for every system
    endif()
    find_path(COIF_HIGHWAY_FOLDER hwy/highway.h ${anywhere} DOC "Where hwy/highway.h of Highway is")
    if(NOT COIF_HIGHWAY_FOLDER)
      message(FATAL_ERROR "found no hwy/highway.h: install Highway (Debian: libhwy-dev), or say -DCOIF_HIGHWAY_FOLDER=...")
    endif()
    set(folders ${COIF_HIGHWAY_FOLDER})
    if(EMSCRIPTEN)
      # The folder may also have this machine's own headers, which are wrong for other systems.
      set(folders ${PROJECT_BINARY_DIR}/highway)
      file(MAKE_DIRECTORY ${folders})
      file(CREATE_LINK ${COIF_HIGHWAY_FOLDER}/hwy ${folders}/hwy SYMBOLIC)
    endif()
  endif()
  set(COIF_HIGHWAY_HEADERS "${folders}" PARENT_SCOPE)
endfunction()

# coif_static_set(RESULT): the instruction set that the compiler's flags allow, as COIF_SIMD would name it.
function(coif_static_set result)
  set(source ${PROJECT_BINARY_DIR}/instruction_set.cpp)
  list(TRANSFORM COIF_HIGHWAY_DEFINITIONS PREPEND -D OUTPUT_VARIABLE definitions)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [[
#include <hwy/detect_targets.h>
#if HWY_STATIC_TARGET == HWY_AVX3
extern const char set[] = "coif-instruction-set:avx512";
#elif HWY_STATIC_TARGET == HWY_AVX2
extern const char set[] = "coif-instruction-set:avx2";
#elif HWY_STATIC_TARGET == HWY_SSE4
extern const char set[] = "coif-instruction-set:sse4";
#elif HWY_STATIC_TARGET == HWY_NEON
extern const char set[] = "coif-instruction-set:neon";
#elif HWY_STATIC_TARGET == HWY_WASM
extern const char set[] = "coif-instruction-set:wasm";
#else
extern const char set[] = "coif-instruction-set:scalar";
#endif
int main() { return set[0]; }
]])
  if(EMSCRIPTEN)
    set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)  # its programs are JavaScript, with the words elsewhere
  endif()
  try_compile(compiled ${PROJECT_BINARY_DIR}/instruction_set ${source}
    CMAKE_FLAGS "-DINCLUDE_DIRECTORIES=${COIF_HIGHWAY_HEADERS}"
    COMPILE_DEFINITIONS ${definitions} OUTPUT_VARIABLE output COPY_FILE ${source}.bin)
  if(NOT compiled)
    message(FATAL_ERROR "Highway's headers do not compile:\n${output}")
  endif()
  file(STRINGS ${source}.bin found REGEX "coif-instruction-set:[a-z0-9]+")
  string(REGEX REPLACE ".*coif-instruction-set:([a-z0-9]+).*" "\\1" found "${found}")
  set(${result} ${found} PARENT_SCOPE)
endfunction()

# Prints the instruction set of a build for a single one; fails if another was requested.
function(coif_check_static_set)
  coif_static_set(found)
  set(cure "on x86-64 -DCMAKE_CXX_FLAGS=-march=x86-64-v2 gives sse4, x86-64-v3 avx2, x86-64-v4 avx512")
  if(NOT COIF_SIMD STREQUAL "static" AND NOT COIF_SIMD STREQUAL found)
    message(FATAL_ERROR "COIF_SIMD is ${COIF_SIMD}, but the compiler's flags allow ${found}; ${cure}")
  endif()
  if(found STREQUAL "scalar" AND COIF_SIMD STREQUAL "static")
    message(WARNING "coif: the simulation is scalar, about six times slower than avx2; ${cure}. -DCOIF_SIMD=scalar asks for this one")
  else()
    message(STATUS "coif: the simulation is compiled for ${found} alone")
  endif()
endfunction()

# coif_use_highway(TARGET): for a library that computes with vectors, or contains such a library.
function(coif_use_highway name)
  target_compile_definitions(${name} PRIVATE ${COIF_HIGHWAY_DEFINITIONS})
  if(COIF_SIMD STREQUAL "dispatch")
    target_link_libraries(${name} PRIVATE hwy::hwy)
  else()
    target_include_directories(${name} SYSTEM PRIVATE ${COIF_HIGHWAY_HEADERS})
  endif()
endfunction()

coif_find_highway()
if(NOT COIF_SIMD STREQUAL "dispatch")
  coif_check_static_set()
endif()
