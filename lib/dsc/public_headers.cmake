# SPDX-License-Identifier: MIT
# Installs the public headers: dsc/dsc.h and what it includes, directly or not. Run by
# `cmake --install`, so that the headers are those of that moment and there is no list to keep.
# `source` is the folder that holds dsc/, `destination` where it goes.
cmake_minimum_required(VERSION 3.25)
set(found dsc/dsc.h)
set(waiting ${found})
while(waiting)
    list(POP_FRONT waiting header)
    file(STRINGS ${source}/${header} includes REGEX "^#include \"dsc/[^\"]+\"")
    foreach(include IN LISTS includes)
        string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included ${include})
        if(NOT included IN_LIST found)
            list(APPEND found ${included})
            list(APPEND waiting ${included})
        endif()
    endforeach()
endwhile()

foreach(header IN LISTS found)
    get_filename_component(folder ${header} DIRECTORY)
    file(INSTALL ${source}/${header} DESTINATION ${destination}/${folder})
endforeach()
