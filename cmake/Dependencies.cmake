# Every library of the project: what, which version, where from. scripts/setup installs exactly these.
#
# | library              | version    | from                                      |
# | -------------------- | ---------- | ----------------------------------------- |
# | MuJoCo               | 4.0.1      | PyPI mujoco-core, by hash (FindMuJoCo)    |
# | MuJoCo's headers     | see there  | PyPI mujoco, by hash (scripts/mujoco)     |
# | Dear ImGui (docking) | 1.93.0     | PyPI imgui-bundle, by hash (ImGui.cmake)  |
# | ImPlot               | 1.1        | PyPI imgui-bundle, by hash (ImGui.cmake)  |
# | portable-file-dialogs |           | PyPI imgui-bundle, by hash (ImGui.cmake)  |
# | Manifold             | 3.5.4      | PyPI manifold3d, by hash (Manifold.cmake) |
# | nanobind             | 3.1.0      | PyPI nanobind, by hash (Nanobind.cmake)   |
# | GLM                  | >= 0.9.9.8 | Debian libglm-dev                         |
# | Eigen                | >= 3.3     | Debian libeigen3-dev                      |
# | fmt                  | >= 9       | Debian libfmt-dev                         |
# | CLI11                | >= 2.1     | Debian libcli11-dev                       |
# | oneTBB               | >= 2021    | Debian libtbb-dev                         |
# | Highway              | >= 1.0     | Debian libhwy-dev                         |
# | mbed TLS (SHA-256)   | >= 2.28    | Debian libmbedtls-dev                     |
# | OpenMesh             | 9          | Debian libopenmesh-dev                    |
# | tinygltf             | 2.7        | Debian libtinygltf-dev                    |
# | nlohmann-json        | >= 3.11    | Debian nlohmann-json3-dev                 |
# | stb                  |            | Debian libstb-dev                         |
# | TinyXML-2            | >= 9       | Debian libtinyxml2-dev                    |
# | yaml-cpp             | >= 0.7     | Debian libyaml-cpp-dev                    |
# | libzip               | >= 1.7     | Debian libzip-dev                         |
# | zlib                 |            | Debian zlib1g-dev                         |
# | GLFW                 | >= 3.3     | Debian libglfw3-dev                       |
# | libwebp              | >= 1.0     | Debian libwebp-dev                        |
# | epoxy, EGL, Mesa     |            | Debian libepoxy-dev libegl-dev ...        |
# | GoogleTest           | >= 1.12    | Debian libgtest-dev                       |
# | RapidCheck           |            | Debian librapidcheck-dev                  |
# | Google Benchmark     |            | Debian libbenchmark-dev                   |

list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
set(TAXEL_CACHE "$ENV{TAXEL_CACHE}" CACHE PATH "Where scripts/setup unpacks the packages from PyPI")
if(NOT TAXEL_CACHE)
  if(DEFINED ENV{XDG_CACHE_HOME})
    set(TAXEL_CACHE "$ENV{XDG_CACHE_HOME}/taxelstudio" CACHE PATH "" FORCE)
  else()
    set(TAXEL_CACHE "$ENV{HOME}/.cache/taxelstudio" CACHE PATH "" FORCE)
  endif()
endif()

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(TBB REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS EGL)
pkg_check_modules(eigen3 REQUIRED IMPORTED_TARGET eigen3)
pkg_check_modules(OpenMesh REQUIRED IMPORTED_TARGET openmesh)
pkg_check_modules(stb REQUIRED IMPORTED_TARGET stb)
pkg_check_modules(hwy REQUIRED IMPORTED_TARGET libhwy)
pkg_check_modules(libzip REQUIRED IMPORTED_TARGET libzip)
pkg_check_modules(zlib REQUIRED IMPORTED_TARGET zlib)
pkg_check_modules(tinyxml2 REQUIRED IMPORTED_TARGET tinyxml2)
pkg_check_modules(yaml-cpp REQUIRED IMPORTED_TARGET yaml-cpp)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(glfw REQUIRED IMPORTED_TARGET glfw3)
if(TAXEL_BUILD_STUDIO)
  pkg_check_modules(webp REQUIRED IMPORTED_TARGET libwebpmux libwebp)
  pkg_check_modules(webpdemux REQUIRED IMPORTED_TARGET libwebpdemux libwebp)  # of the tests
  # The window's font; its place on Debian and Ubuntu, Fedora, and Arch.
  find_file(DEJAVU_SANS DejaVuSans.ttf REQUIRED PATHS /usr/share/fonts /usr/local/share/fonts
    PATH_SUFFIXES truetype/dejavu dejavu-sans-fonts dejavu TTF)
endif()
find_library(MBEDCRYPTO_LIBRARY NAMES libmbedcrypto.a mbedcrypto REQUIRED)
find_package(MuJoCo REQUIRED)
include(${CMAKE_CURRENT_LIST_DIR}/Manifold.cmake)
if(TAXEL_BUILD_TESTS)
  find_package(GTest REQUIRED)
endif()
