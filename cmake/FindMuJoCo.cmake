# MuJoCo from the mujoco-core wheel that scripts/setup unpacked. Target: mujoco::mujoco.
set(MuJoCo_VERSION 4.0.1 CACHE STRING "MuJoCo to build against (the wheel's version)")
set(MuJoCo_ROOT "${TAXEL_CACHE}/mujoco-core-${MuJoCo_VERSION}/mujoco" CACHE PATH "Folder with include/ and libmujoco.so.X")
find_path(MuJoCo_INCLUDE_DIR mujoco/mujoco.h PATHS ${MuJoCo_ROOT}/include NO_DEFAULT_PATH)
set(MuJoCo_LIBRARY ${MuJoCo_ROOT}/libmujoco.so.${MuJoCo_VERSION})
if(NOT EXISTS ${MuJoCo_LIBRARY})
  message(FATAL_ERROR "MuJoCo ${MuJoCo_VERSION} is not in ${MuJoCo_ROOT}: run scripts/setup")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MuJoCo REQUIRED_VARS MuJoCo_LIBRARY MuJoCo_INCLUDE_DIR VERSION_VAR MuJoCo_VERSION)
if(NOT TARGET mujoco::mujoco)
  add_library(mujoco::mujoco SHARED IMPORTED)
  set_target_properties(mujoco::mujoco PROPERTIES
    IMPORTED_LOCATION ${MuJoCo_LIBRARY}
    IMPORTED_SONAME libmujoco.so.${MuJoCo_VERSION}  # the wheel has no symlink
    INTERFACE_INCLUDE_DIRECTORIES ${MuJoCo_INCLUDE_DIR})
endif()
