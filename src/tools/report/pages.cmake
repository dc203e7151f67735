# Puts the pages of report.html together, each with its styles and scripts inside. A change of a part
# configures the build again.

# Sets `result` to the text of files one after another.
function(read_parts result)
  set(text "")
  foreach(part ${ARGN})
    file(READ ${part} content)
    string(APPEND text "${content}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${part})
  endforeach()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

set(report src/tools/report)
set(uplot third_party/uplot)
read_parts(uplot_license ${uplot}/LICENSE)
read_parts(uplot_script ${uplot}/uPlot.iife.min.js)
read_parts(report_style ${uplot}/uPlot.min.css ${report}/style.css)
read_parts(report_script
  ${report}/format.js ${report}/palette.js ${report}/data.js ${report}/motion.js ${report}/brush.js
  ${report}/scene.js ${report}/legend.js ${report}/charts.js ${report}/ttc_chart.js
  ${report}/strip_chart.js ${report}/figures.js ${report}/moment.js ${report}/events.js
  ${report}/player.js ${report}/main.js)
read_parts(report_list_style ${report}/style.css)
read_parts(report_list_script ${report}/format.js ${report}/palette.js ${report}/list.js)

read_parts(page_template ${report}/page.html)
string(CONFIGURE "${page_template}" report_page @ONLY)
read_parts(list_template ${report}/list.html)
string(CONFIGURE "${list_template}" report_list_page @ONLY)
configure_file(src/tools/analysis/report_assets.cpp.in
  ${CMAKE_CURRENT_BINARY_DIR}/report_assets.cpp @ONLY)
