# Third-party code in coif's libraries and program. tools/packages.txt names it above each library of the group [program] as
#   #= NAME | LICENCE, an SPDX expression | library or program
# Writes third_party/ in the build folder: THIRD_PARTY_NOTICES.txt, each package's licence as Debian has it, coif.spdx.json, the same as
# SPDX 2.3, and, for `coif --licenses`, third_party_notices.cpp.
set(coif_third_party ${PROJECT_BINARY_DIR}/third_party)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS tools/packages.txt)

# coif_add_notice(NAME LICENCE PACKAGE): appends to `notices`, `spdx_packages` and `spdx_relations`.
function(coif_add_notice name licence package)
  set(text "(its licence's text was not on the machine that built this: ${package} is a Debian package)\n")
  if(EXISTS /usr/share/doc/${package}/copyright)
    file(READ /usr/share/doc/${package}/copyright text)
  endif()
  set(version unknown)
  find_program(COIF_DPKG_QUERY dpkg-query)
  mark_as_advanced(COIF_DPKG_QUERY)
  if(COIF_DPKG_QUERY)
    execute_process(COMMAND ${COIF_DPKG_QUERY} -W -f "\${Version}" ${package} OUTPUT_VARIABLE found ERROR_QUIET)
    if(found)
      set(version ${found})
    endif()
  endif()
  string(REPEAT = 78 line)
  set(notices "${notices}\n${line}\n${name}, ${licence} (${package} ${version})\n${line}\n\n${text}" PARENT_SCOPE)
  set(spdx_packages "${spdx_packages},
    {\"SPDXID\": \"SPDXRef-${package}\", \"name\": \"${name}\", \"versionInfo\": \"${version}\", \"licenseDeclared\": \"${licence}\",
     \"licenseConcluded\": \"NOASSERTION\", \"copyrightText\": \"NOASSERTION\", \"downloadLocation\": \"NOASSERTION\", \"filesAnalyzed\": false}"
    PARENT_SCOPE)
  set(spdx_relations "${spdx_relations},
    {\"spdxElementId\": \"SPDXRef-coif\", \"relationshipType\": \"DEPENDS_ON\", \"relatedSpdxElement\": \"SPDXRef-${package}\"}"
    PARENT_SCOPE)
endfunction()

# coif_add_page_notice(): the same of Emscripten's code in the page of `coif view`, which was built elsewhere: view/renew_page.sh.
function(coif_add_page_notice)
  file(READ ${PROJECT_SOURCE_DIR}/tools/view/built/emscripten text)
  string(REPEAT = 78 line)
  set(licence "MIT OR NCSA")
  set(notices "${notices}\n${line}\nEmscripten, ${licence} (in the page of coif view)\n${line}\n\n${text}" PARENT_SCOPE)
  set(spdx_packages "${spdx_packages},
    {\"SPDXID\": \"SPDXRef-emscripten\", \"name\": \"Emscripten\", \"versionInfo\": \"unknown\", \"licenseDeclared\": \"${licence}\",
     \"licenseConcluded\": \"NOASSERTION\", \"copyrightText\": \"NOASSERTION\", \"downloadLocation\": \"NOASSERTION\", \"filesAnalyzed\": false}"
    PARENT_SCOPE)
  set(spdx_relations "${spdx_relations},
    {\"spdxElementId\": \"SPDXRef-coif\", \"relationshipType\": \"DEPENDS_ON\", \"relatedSpdxElement\": \"SPDXRef-emscripten\"}"
    PARENT_SCOPE)
endfunction()

# coif_read_notices(WITH_PROGRAM): sets the same three from the list; with WITH_PROGRAM also for code that only the program has.
function(coif_read_notices with_program)
  set(notices "coif ${PROJECT_VERSION} has its own licence, MIT. It is built with these works of others.\n")
  file(STRINGS ${PROJECT_SOURCE_DIR}/tools/packages.txt lines)
  set(group "")
  set(said "")
  foreach(line IN LISTS lines)
    if(line MATCHES "^\\[(.*)\\]$")
      set(group ${CMAKE_MATCH_1})
    elseif(line MATCHES "^#= ([^|]+) \\| ([^|]+) \\| (library|program)$")
      set(said ${line})
    elseif(line MATCHES "^([a-z].*-dev|libjs-.*)$" AND group STREQUAL program)
      if(NOT said MATCHES "^#= ([^|]+) \\| ([^|]+) \\| (library|program)$")
        message(FATAL_ERROR "tools/packages.txt: no line \"#= NAME | LICENCE | library or program\" above ${line}")
      endif()
      if(with_program OR CMAKE_MATCH_3 STREQUAL library)
        coif_add_notice("${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}" ${line})
      endif()
      set(said "")
    endif()
  endforeach()
  if(with_program)
    coif_add_page_notice()
  endif()
  foreach(made notices spdx_packages spdx_relations)
    set(${made} "${${made}}" PARENT_SCOPE)
  endforeach()
endfunction()

string(TIMESTAMP coif_built_at UTC)
coif_read_notices(${COIF_TOOLS})
file(CONFIGURE OUTPUT ${coif_third_party}/THIRD_PARTY_NOTICES.txt CONTENT "@notices@" @ONLY)
file(CONFIGURE OUTPUT ${coif_third_party}/third_party_notices.cpp @ONLY CONTENT [[
#include "cli/messages.h"

namespace coif::cli {

const char* const kThirdPartyNotices = R"notices(@notices@)notices";

}  // namespace coif::cli
]])
file(CONFIGURE OUTPUT ${coif_third_party}/coif.spdx.json @ONLY CONTENT [[
{
  "spdxVersion": "SPDX-2.3",
  "dataLicense": "CC0-1.0",
  "SPDXID": "SPDXRef-DOCUMENT",
  "name": "coif-@PROJECT_VERSION@",
  "documentNamespace": "https://spdx.org/spdxdocs/coif-@PROJECT_VERSION@",
  "creationInfo": {"created": "@coif_built_at@", "creators": ["Tool: CMake-@CMAKE_VERSION@"]},
  "packages": [
    {"SPDXID": "SPDXRef-coif", "name": "coif", "versionInfo": "@PROJECT_VERSION@", "licenseDeclared": "MIT",
     "licenseConcluded": "MIT", "copyrightText": "NOASSERTION", "downloadLocation": "NOASSERTION", "filesAnalyzed": false}@spdx_packages@
  ],
  "relationships": [
    {"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": "SPDXRef-coif"}@spdx_relations@
  ]
}
]])
