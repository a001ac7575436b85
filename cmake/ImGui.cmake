# Dear ImGui (docking branch) and ImPlot, from the source package that scripts/setup unpacked. Target: imgui. The same
# package has portable-file-dialogs, one header in the folder PORTABLE_FILE_DIALOGS.
set(IMGUI_BUNDLE "${TAXEL_CACHE}/imgui-bundle-1.93.0" CACHE PATH "Unpacked imgui-bundle source package")
set(_imgui ${IMGUI_BUNDLE}/external/imgui/imgui)
set(_implot ${IMGUI_BUNDLE}/external/implot/implot)
if(NOT EXISTS ${_imgui}/imgui.cpp)
  message(FATAL_ERROR "Dear ImGui is not in ${IMGUI_BUNDLE}: run scripts/setup")
endif()
set(PORTABLE_FILE_DIALOGS ${IMGUI_BUNDLE}/external/portable_file_dialogs/portable_file_dialogs)
if(NOT EXISTS ${PORTABLE_FILE_DIALOGS}/portable_file_dialogs.h)
  message(FATAL_ERROR "portable-file-dialogs is not in ${IMGUI_BUNDLE}: run scripts/setup")
endif()
add_library(imgui STATIC
  ${_imgui}/imgui.cpp ${_imgui}/imgui_draw.cpp ${_imgui}/imgui_tables.cpp ${_imgui}/imgui_widgets.cpp
  ${_imgui}/imgui_stacklayout.cpp ${_imgui}/misc/cpp/imgui_stdlib.cpp ${_imgui}/backends/imgui_impl_opengl3.cpp
  ${_implot}/implot.cpp ${_implot}/implot_items.cpp)
target_include_directories(imgui SYSTEM PUBLIC ${_imgui} ${_imgui}/backends ${_imgui}/misc/cpp ${_implot})
target_compile_features(imgui PUBLIC cxx_std_20)
target_compile_definitions(imgui PUBLIC IMGUI_DISABLE_OBSOLETE_FUNCTIONS "IMPLOT_CUSTOM_NUMERIC_TYPES=(double)")
target_link_libraries(imgui PRIVATE OpenGL::GL ${CMAKE_DL_LIBS})
set_target_properties(imgui PROPERTIES POSITION_INDEPENDENT_CODE ON)
taxel_optimise(imgui 1)  # ImPlot alone takes minutes otherwise
