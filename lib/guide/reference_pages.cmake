# SPDX-License-Identifier: MIT
# Runs doxygen on the public headers and the guide; fails if it warns. Run with `cmake -P`. `doxygen` and `python` are
# the programs, `source` is the folder that holds dsc/, the modules and guide/, `work` the one where pages/ is written,
# `version` that of the library.
cmake_minimum_required(VERSION 3.25)
include(${source}/dsc/public_headers.cmake)
file(GLOB pages ${source}/guide/*.md ${source}/guide/*.dox)
foreach(module dsc fluid geometric_flows thesis topology)
    dsc_public_headers(headers ${source} ${module})
    list(APPEND all_headers ${headers})
endforeach()
set(copies ${work}/headers)
file(REMOVE_RECURSE ${copies})
execute_process(
    COMMAND ${python} -I -S ${source}/guide/doxygen_filter.py ${source} ${copies} ${all_headers}
    COMMAND_ERROR_IS_FATAL ANY)
# Doxygen runs its filter twice for each header, so the filter only prints the copy.
file(WRITE ${work}/filter.sh "exec cat \"${copies}/\${1#${source}/}\"\n")
list(TRANSFORM all_headers PREPEND ${source}/)
set(inputs ${pages} ${all_headers})
list(JOIN inputs "\" \\\n    \"" inputs)
configure_file(${source}/guide/Doxyfile.in ${work}/Doxyfile @ONLY)
execute_process(COMMAND ${doxygen} ${work}/Doxyfile RESULT_VARIABLE code)
if(NOT code EQUAL 0)
    message(FATAL_ERROR "doxygen ended with ${code}; each declaration named above needs a comment")
endif()
# Doxygen leaves pictures in tables to the reader's browser.
file(COPY ${source}/guide/pictures DESTINATION ${work}/pages)
