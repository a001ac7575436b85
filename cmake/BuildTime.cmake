# What keeps a build from scratch short: headers parsed once, files compiled together, and optimisation where it is felt.
# The debug preset does none of it, so that a missing include is noticed.

# taxel_precompile(target HEADERS...)
# taxel_precompile(target REUSE_FROM other): the same headers, once more of use; for the same compile options.
function(taxel_precompile target)
  if(NOT TAXEL_PRECOMPILE)
    return()
  endif()
  target_compile_options(${target} PRIVATE -fpch-preprocess)  # for ccache
  if(ARGV1 STREQUAL "REUSE_FROM")
    target_precompile_headers(${target} REUSE_FROM ${ARGV2})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# taxel_optimise(target LEVEL): of a release, where less than -O3 is as good.
function(taxel_optimise target level)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O${level}>)
endfunction()

# taxel_together(target): 24 files at a time are compiled as one. Names in their unnamed namespaces must differ. Files
# that include themselves (the kernels for several instruction sets) are compiled alone.
function(taxel_together target)
  if(NOT TAXEL_TOGETHER)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 24)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    if(source MATCHES "\\.cpp$" AND EXISTS ${source})
      file(STRINGS ${source} includes_itself REGEX "^#include <hwy/foreach_target.h>" LIMIT_COUNT 1)
      if(includes_itself)
        set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      endif()
    endif()
  endforeach()
endfunction()
