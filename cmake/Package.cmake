# Files that make an installed Taxel Studio part of a system: find_package(taxel), manual pages, completion of shells, the
# desktop's entry, icon and file types; and the tarball that `cpack` makes of everything.
#
# | component | holds                                                                                             |
# | --------- | ------------------------------------------------------------------------------------------------- |
# | dev       | lib/cmake/taxel                                                                                   |
# | desktop   | share/man, share/bash-completion, share/fish, share/zsh, share/applications, share/icons, share/mime |
include(CMakePackageConfigHelpers)
set(taxel_known_versions ${MuJoCo_VERSIONS})
list(JOIN taxel_known_versions " " taxel_known_versions)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/package/taxelConfig.cmake.in ${PROJECT_BINARY_DIR}/package/taxelConfig.cmake
  INSTALL_DESTINATION lib/cmake/taxel NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/taxelConfigVersion.cmake VERSION ${PROJECT_VERSION}
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/taxelConfig.cmake ${PROJECT_BINARY_DIR}/package/taxelConfigVersion.cmake
  DESTINATION lib/cmake/taxel COMPONENT dev)

# Each program writes its manual page and its completion scripts itself, from its table of options.
foreach(program IN LISTS installed_programs)
  set(written ${PROJECT_BINARY_DIR}/package/${program})
  file(MAKE_DIRECTORY ${written})
  install(CODE "
    set(program \"$<TARGET_FILE:${program}>\")
    execute_process(COMMAND \${program} --man OUTPUT_FILE ${written}/${program}.1 COMMAND_ERROR_IS_FATAL ANY)
    foreach(shell bash fish zsh)
      execute_process(COMMAND \${program} --completion \${shell} OUTPUT_FILE ${written}/\${shell} COMMAND_ERROR_IS_FATAL ANY)
    endforeach()" COMPONENT desktop)
  install(FILES ${written}/${program}.1 DESTINATION share/man/man1 COMPONENT desktop)
  install(FILES ${written}/bash DESTINATION share/bash-completion/completions RENAME ${program} COMPONENT desktop)
  install(FILES ${written}/fish DESTINATION share/fish/vendor_completions.d RENAME ${program}.fish COMPONENT desktop)
  install(FILES ${written}/zsh DESTINATION share/zsh/site-functions RENAME _${program} COMPONENT desktop)
endforeach()
if(TARGET taxelstudio)
  set(desktop ${PROJECT_SOURCE_DIR}/assets/desktop)
  install(FILES ${desktop}/taxelstudio.desktop DESTINATION share/applications COMPONENT desktop)
  install(FILES ${desktop}/taxelstudio.svg DESTINATION share/icons/hicolor/scalable/apps COMPONENT desktop)
  install(FILES ${desktop}/taxelstudio.xml DESTINATION share/mime/packages COMPONENT desktop)
endif()

# `cpack --config build/release/CPackConfig.cmake`. The programs in the tarball need the Debian packages of scripts/setup.
set(CPACK_GENERATOR TGZ)
set(CPACK_PACKAGE_NAME taxel-studio)
set(CPACK_PACKAGE_VENDOR "Taxel Studio")
set(CPACK_PACKAGE_FILE_NAME taxel-studio-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES ON)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
include(CPack)
