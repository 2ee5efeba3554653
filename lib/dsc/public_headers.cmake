# SPDX-License-Identifier: MIT
# The public headers: dsc/dsc.h and what it includes, directly or not. Read where they are needed,
# by `cmake --install` and by the reference pages, so that there is no list to keep. `source` is the
# folder that holds dsc/; sets `public_headers`, relative to it.
cmake_minimum_required(VERSION 3.25)
set(public_headers dsc/dsc.h)
set(waiting ${public_headers})
while(waiting)
    list(POP_FRONT waiting header)
    file(STRINGS ${source}/${header} includes REGEX "^#include \"dsc/[^\"]+\"")
    foreach(include IN LISTS includes)
        string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included ${include})
        if(NOT included IN_LIST public_headers)
            list(APPEND public_headers ${included})
            list(APPEND waiting ${included})
        endif()
    endforeach()
endwhile()
