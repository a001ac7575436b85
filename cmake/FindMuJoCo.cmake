# MuJoCo from the packages that scripts/setup unpacked.
#   mujoco::mujoco            the version that our own programs use
#   mujoco_headers_VERSION    headers of each version for which there is a plugin, without a library
#   MuJoCo_VERSIONS           these versions, the newest first
set(MuJoCo_VERSION 4.0.1 CACHE STRING "MuJoCo to build against (the wheel's version)")
set(MuJoCo_ROOT "${TAXEL_CACHE}/mujoco-core-${MuJoCo_VERSION}/mujoco" CACHE PATH "Folder with include/ and libmujoco.so.X")
set(TAXEL_PLUGIN_VERSIONS 4.0.0 3.17.0 3.8.1 3.3.7 CACHE STRING "Further versions of MuJoCo for which to build the plugin")
find_path(MuJoCo_INCLUDE_DIR mujoco/mujoco.h PATHS ${MuJoCo_ROOT}/include NO_DEFAULT_PATH)
set(MuJoCo_LIBRARY ${MuJoCo_ROOT}/libmujoco.so.${MuJoCo_VERSION})
if(NOT EXISTS ${MuJoCo_LIBRARY})
  message(FATAL_ERROR "MuJoCo ${MuJoCo_VERSION} is not in ${MuJoCo_ROOT}: run scripts/setup")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MuJoCo REQUIRED_VARS MuJoCo_LIBRARY MuJoCo_INCLUDE_DIR VERSION_VAR MuJoCo_VERSION)

# taxel_mujoco_headers(VERSION FOLDER): the target mujoco_headers_VERSION.
function(taxel_mujoco_headers version folder)
  add_library(mujoco_headers_${version} INTERFACE IMPORTED GLOBAL)
  set_target_properties(mujoco_headers_${version} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${folder})
endfunction()

if(NOT TARGET mujoco::mujoco)
  add_library(mujoco::mujoco SHARED IMPORTED)
  set_target_properties(mujoco::mujoco PROPERTIES
    IMPORTED_LOCATION ${MuJoCo_LIBRARY}
    IMPORTED_SONAME libmujoco.so.${MuJoCo_VERSION}  # the wheel has no symlink
    INTERFACE_INCLUDE_DIRECTORIES ${MuJoCo_INCLUDE_DIR})
  set(MuJoCo_VERSIONS ${MuJoCo_VERSION})
  taxel_mujoco_headers(${MuJoCo_VERSION} ${MuJoCo_INCLUDE_DIR})
  foreach(version IN LISTS TAXEL_PLUGIN_VERSIONS)
    set(folder ${TAXEL_CACHE}/mujoco-${version}/mujoco/include)
    if(version STREQUAL MuJoCo_VERSION)
      continue()
    elseif(NOT EXISTS ${folder}/mujoco/mujoco.h)
      message(WARNING "MuJoCo ${version} is not in ${folder}, so there is no plugin for it: run scripts/setup")
      continue()
    endif()
    list(APPEND MuJoCo_VERSIONS ${version})
    taxel_mujoco_headers(${version} ${folder})
  endforeach()
endif()
