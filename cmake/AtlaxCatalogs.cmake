# Makes gettext catalogs for atlax::Translation at build time.
#
# atlax_catalogs(<target> DOMAIN <name> FOLDER <output folder> PO <language>.po ...): a target that
# compiles each file to <output folder>/<language>/LC_MESSAGES/<name>.mo. msgfmt checks the files: a
# header, a form for each plural, placeholders that agree.
function(atlax_catalogs target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "DOMAIN;FOLDER" "PO")
  find_program(ATLAX_MSGFMT msgfmt REQUIRED)
  set(catalogs)
  foreach(po ${arg_PO})
    cmake_path(ABSOLUTE_PATH po)
    cmake_path(GET po STEM language)
    set(folder ${arg_FOLDER}/${language}/LC_MESSAGES)
    set(catalog ${folder}/${arg_DOMAIN}.mo)
    add_custom_command(OUTPUT ${catalog}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
      COMMAND ${ATLAX_MSGFMT} --check --output-file=${catalog} ${po}
      DEPENDS ${po}
      COMMENT "Catalog ${arg_DOMAIN} of ${language}"
      VERBATIM)
    list(APPEND catalogs ${catalog})
  endforeach()
  add_custom_target(${target} ALL DEPENDS ${catalogs})
endfunction()
