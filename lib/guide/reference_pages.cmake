# SPDX-License-Identifier: MIT
# Runs doxygen over the public headers and the guide; fails where it warns. Run with `cmake -P`.
# `doxygen` and `python` are the programs, `source` is the folder that holds dsc/, the modules and guide/, `work`
# the one where pages/ is written, `version` that of the library.
cmake_minimum_required(VERSION 3.25)
include(${source}/dsc/public_headers.cmake)
file(GLOB pages ${source}/guide/*.md ${source}/guide/*.dox)
set(inputs ${pages})
foreach(module dsc fluid geometric_flows thesis topology)
    dsc_public_headers(headers ${source} ${module})
    list(TRANSFORM headers PREPEND ${source}/)
    list(APPEND inputs ${headers})
endforeach()
list(JOIN inputs "\" \\\n    \"" inputs)
configure_file(${source}/guide/Doxyfile.in ${work}/Doxyfile @ONLY)
execute_process(COMMAND ${doxygen} ${work}/Doxyfile RESULT_VARIABLE code)
if(NOT code EQUAL 0)
    message(FATAL_ERROR "doxygen ended with ${code}; each declaration named above needs a comment")
endif()
# Doxygen leaves pictures in tables to the reader's browser.
file(COPY ${source}/guide/pictures DESTINATION ${work}/pages)
