# What `cmake --install` writes. All paths in installed files are relative to the file, so the tree may be moved. The wheel
# holds the first four components below its package (scripts/wheel). cmake/Package.cmake has the other components of a system.
#
# | component   | holds                                                                                        |
# | ----------- | -------------------------------------------------------------------------------------------- |
# | programs    | bin/taxel, and the MuJoCo that our programs use: lib/taxel/libmujoco.so.VERSION              |
# | studio      | bin/taxelstudio                                                                              |
# | plugin      | lib/taxel/mujoco-VERSION/libtaxel_plugin.so, one for each version of MuJoCo                  |
# | data        | share/taxel: example layouts, meshes and scenes                                              |
# | python_TAG  | the package `taxel` for one Python; only on request, into a folder named taxel               |
include(GNUInstallDirs)
set(TAXEL_PRIVATE_LIBDIR lib/taxel)

set(installed_programs)
foreach(program taxel taxelstudio)
  if(TARGET ${program})
    set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/../${TAXEL_PRIVATE_LIBDIR}")
    list(APPEND installed_programs ${program})
  endif()
endforeach()
install(TARGETS taxel RUNTIME DESTINATION bin COMPONENT programs)
if(TARGET taxelstudio)
  install(TARGETS taxelstudio RUNTIME DESTINATION bin COMPONENT studio)
endif()
install(FILES ${MuJoCo_LIBRARY} DESTINATION ${TAXEL_PRIVATE_LIBDIR} COMPONENT programs
  PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# The one place that lists the plugin libraries. The target of our programs' MuJoCo is taxel_plugin, that of any other
# version taxel_plugin_VERSION. They have no RUNPATH: each one uses the MuJoCo that the process has loaded.
if(NOT MuJoCo_VERSIONS)
  set(MuJoCo_VERSIONS ${MuJoCo_VERSION})
endif()
set(TAXEL_PLUGINS)
foreach(version IN LISTS MuJoCo_VERSIONS)
  set(plugin taxel_plugin_${version})
  if(version STREQUAL MuJoCo_VERSION)
    set(plugin taxel_plugin)
  endif()
  set_target_properties(${plugin} PROPERTIES INSTALL_RPATH "")
  install(TARGETS ${plugin} LIBRARY DESTINATION ${TAXEL_PRIVATE_LIBDIR}/mujoco-${version} COMPONENT plugin)
  list(APPEND TAXEL_PLUGINS ${plugin})
endforeach()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/layouts ${PROJECT_SOURCE_DIR}/assets/meshes ${PROJECT_SOURCE_DIR}/assets/scenes
  ${PROJECT_SOURCE_DIR}/assets/schema DESTINATION share/taxel COMPONENT data)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/taxel COMPONENT data)

# The licences of the libraries inside the programs and of those that a wheel holds: share/doc/taxel/licences/LIBRARY.
function(taxel_install_licence library file)
  install(FILES ${file} DESTINATION share/doc/taxel/licences RENAME ${library}.txt COMPONENT data)
endfunction()
foreach(package libglm-dev libeigen3-dev libfmt-dev libcli11-dev libtbb-dev libhwy-dev libmbedtls-dev nlohmann-json3-dev libopenmesh-dev
    libtinygltf-dev libstb-dev libtinyxml2-dev libyaml-cpp-dev libzip-dev zlib1g libzstd1 libglfw3-dev libwebp-dev libepoxy-dev libssl3 libbz2-1.0
    fonts-dejavu-core)
  if(EXISTS /usr/share/doc/${package}/copyright)  # another distribution has other packages
    taxel_install_licence(${package} /usr/share/doc/${package}/copyright)
  endif()
endforeach()
file(GLOB mujoco_licences ${MuJoCo_ROOT}/../*.dist-info/licenses/*)
foreach(file IN LISTS mujoco_licences)
  get_filename_component(name ${file} NAME_WE)
  taxel_install_licence(mujoco_${name} ${file})
endforeach()
taxel_install_licence(manifold ${MANIFOLD_SOURCE}/LICENSE)
if(TARGET imgui)
  taxel_install_licence(imgui ${IMGUI_BUNDLE}/external/imgui/imgui/LICENSE.txt)
  taxel_install_licence(implot ${IMGUI_BUNDLE}/external/implot/implot/LICENSE)
endif()
if(TARGET taxel_python)
  file(GLOB nanobind_licence ${NANOBIND_SOURCE}/../*.dist-info/licenses/LICENSE)
  taxel_install_licence(nanobind ${nanobind_licence})
endif()

# taxel_install_python(TARGET TAG COMPONENT): into the folder that becomes the package.
function(taxel_install_python target tag component)
  set(without_stub)
  if(NOT TARGET taxel_python)
    set(without_stub OPTIONAL)
  endif()
  install(TARGETS ${target} LIBRARY DESTINATION . COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_BINARY_DIR}/python/${tag}/_core.pyi DESTINATION . COMPONENT ${component} EXCLUDE_FROM_ALL
    ${without_stub})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/taxel/ DESTINATION . COMPONENT ${component} EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN "*.py" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
endfunction()
foreach(tag IN LISTS TAXEL_PYTHON_TAGS)
  taxel_install_python(taxel_python_${tag} ${tag} python_${tag})
endforeach()

# Everything that a wheel holds. `pip install .` builds this target and installs its only module as the component `python`.
add_custom_target(taxel_wheel DEPENDS ${installed_programs} ${TAXEL_PLUGINS})
if(TARGET taxel_python)
  add_dependencies(taxel_wheel taxel_python)
endif()
if(SKBUILD)
  taxel_install_python(taxel_python_${TAXEL_PYTHON_TAGS} ${TAXEL_PYTHON_TAGS} python)
endif()
