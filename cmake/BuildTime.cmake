# What keeps a build from scratch short: headers parsed once, and optimisation where it is felt.

# taxel_precompile(target HEADERS...): with TAXEL_PRECOMPILE off nothing, so that a missing include is noticed.
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
