# embed_files(TARGET name NAMESPACE ns [ROOT folder] FILES ...): makes a source file with
#   namespace ns { std::string_view embedded_file(std::string_view name); }  // empty view when unknown
#     std::span<const std::string_view> embedded_names(); }          // names of all files
# so that programs carry their shaders, default assets and font with them. Names are relative to ROOT (default: the project).
function(embed_files)
  cmake_parse_arguments(E "" "TARGET;NAMESPACE;ROOT" "FILES" ${ARGN})
  if(NOT E_ROOT)
    set(E_ROOT ${PROJECT_SOURCE_DIR})
  endif()
  string(REPLACE "::" "_" prefix ${E_NAMESPACE})
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${prefix}_embedded.cpp)
  set(list)
  foreach(file IN LISTS E_FILES)
    get_filename_component(absolute ${file} ABSOLUTE)
    list(APPEND list ${absolute})
  endforeach()
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DOUT=${out} -DNAMESPACE=${E_NAMESPACE} "-DFILES=${list}" -DROOT=${E_ROOT}
            -P ${PROJECT_SOURCE_DIR}/cmake/embed_script.cmake
    DEPENDS ${list} ${PROJECT_SOURCE_DIR}/cmake/embed_script.cmake VERBATIM)
  target_sources(${E_TARGET} PRIVATE ${out})
endfunction()
