# SPDX-License-Identifier: MIT
# The public headers of a module: MODULE/MODULE.h, for the core also dsc/engine.h, and all headers
# of the module that these include, directly or not. `cmake --install` and the reference pages call
# this, so that no list has to be maintained. `source` is the folder that holds MODULE/; sets
# `result`, relative to it.
cmake_minimum_required(VERSION 3.25)
function(dsc_public_headers result source module)
    set(headers ${module}/${module}.h)
    if(EXISTS ${source}/${module}/engine.h)
        list(APPEND headers ${module}/engine.h)
    endif()
    set(waiting ${headers})
    while(waiting)
        list(POP_FRONT waiting header)
        file(STRINGS ${source}/${header} includes REGEX "^#include \"${module}/[^\"]+\"")
        foreach(include IN LISTS includes)
            string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included ${include})
            if(NOT included IN_LIST headers)
                list(APPEND headers ${included})
                list(APPEND waiting ${included})
            endif()
        endforeach()
    endwhile()
    set(${result} ${headers} PARENT_SCOPE)
endfunction()
