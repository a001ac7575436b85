# Warnings of our own code; headers of libraries are SYSTEM. A newer compiler has new warnings, which must not keep anyone
# from building, so warnings are errors on request alone. Continuous integration asks for it.
option(TAXEL_WERROR "Make warnings errors" OFF)
add_library(taxel_options INTERFACE)
target_compile_features(taxel_options INTERFACE cxx_std_20)
target_compile_options(taxel_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast
  $<$<BOOL:${TAXEL_WERROR}>:-Werror>
  -ffp-contract=off)  # same bits on every machine and at every optimisation level
if(TAXEL_SANITIZE)
  # g++ warns of uninitialised values inside of OpenMesh that exist only in the sanitizers' own code.
  target_compile_options(taxel_options INTERFACE -fsanitize=${TAXEL_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized> -O1 -g1)  # more optimisation and full symbols double the time to build
  target_link_options(taxel_options INTERFACE -fsanitize=${TAXEL_SANITIZE})
endif()
