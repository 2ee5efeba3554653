# SPDX-License-Identifier: MIT
# cmake -D manifest=FILE -P uninstall.cmake: removes the files that the last `cmake --install`
# wrote, and folders that are then empty.
if(NOT EXISTS ${manifest})
    message(FATAL_ERROR "nothing has been installed from this build: ${manifest} does not exist")
endif()
file(STRINGS ${manifest} files)
foreach(file IN LISTS files)
    file(REMOVE ${file})
    get_filename_component(folder ${file} DIRECTORY)
    file(GLOB rest ${folder}/*)
    while(NOT rest AND EXISTS ${folder})
        file(REMOVE_RECURSE ${folder})
        get_filename_component(folder ${folder} DIRECTORY)
        file(GLOB rest ${folder}/*)
    endwhile()
endforeach()
file(REMOVE ${manifest})
