# Manifold, from the source package that scripts/setup unpacked. Target: manifold. Serial and without cross-sections: no
# dependency of its own, and the same bits on any number of threads.
set(MANIFOLD_SOURCE "${TAXEL_CACHE}/manifold3d-3.5.4" CACHE PATH "Unpacked manifold3d source package")
if(NOT EXISTS ${MANIFOLD_SOURCE}/src/manifold.cpp)
  message(FATAL_ERROR "Manifold is not in ${MANIFOLD_SOURCE}: run scripts/setup")
endif()
set(_names boolean3 boolean_result constructors csg_tree edge_op execution_impl face_op impl manifold minkowski polygon
  properties quickhull sdf smoothing sort subdivision tree2d)
list(TRANSFORM _names REPLACE "(.+)" "${MANIFOLD_SOURCE}/src/\\1.cpp" OUTPUT_VARIABLE _sources)
add_library(manifold STATIC ${_sources})
target_include_directories(manifold SYSTEM PUBLIC ${MANIFOLD_SOURCE}/include)
target_compile_features(manifold PUBLIC cxx_std_17)
target_compile_definitions(manifold PUBLIC MANIFOLD_PAR=-1)
target_compile_options(manifold PRIVATE -w -ffp-contract=off)
set_target_properties(manifold PROPERTIES POSITION_INDEPENDENT_CODE ON)
