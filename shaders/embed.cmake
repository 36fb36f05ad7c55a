# Writes shader files into one C++ header, each as a string constant kShader<Name>. Run by the build:
#   cmake -D "FILES=a.vert;b.frag" -D OUT=header.h -P embed.cmake
# hair_depth.frag becomes kShaderHairDepthFrag. Line numbers in a compiler's log are those of the file.
set(text "#pragma once\n// Generated from shaders/; do not edit.\n\nnamespace coif {\n")
foreach(file IN LISTS FILES)
  file(READ "${file}" source)
  get_filename_component(name "${file}" NAME)
  string(REGEX REPLACE "[_.]" ";" words "${name}")
  set(constant "")
  foreach(word IN LISTS words)
    string(SUBSTRING "${word}" 0 1 first)
    string(SUBSTRING "${word}" 1 -1 rest)
    string(TOUPPER "${first}" first)
    string(APPEND constant "${first}${rest}")
  endforeach()
  string(APPEND text "\ninline constexpr char kShader${constant}[] = R\"glsl(${source})glsl\";\n")
endforeach()
string(APPEND text "\n}  // namespace coif\n")
file(WRITE "${OUT}" "${text}")
