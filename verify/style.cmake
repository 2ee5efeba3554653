# SPDX-License-Identifier: MIT
# Checks that clang-format, with the project's .clang-format, would not change any source, except
# the programs in verify/install, which have the width of the pages that show them.
#
#   cmake -D clang_format=PROGRAM -D source=FOLDER -P style.cmake
foreach(room lib reference bench verify)
    file(GLOB_RECURSE files ${source}/${room}/*.h ${source}/${room}/*.cpp)
    list(FILTER files EXCLUDE REGEX /verify/install/)
    execute_process(COMMAND ${clang_format} --dry-run -Werror ${files} RESULT_VARIABLE code)
    if(NOT code EQUAL 0)
        message(SEND_ERROR "in ${room}: run ${clang_format} -i on the files named above")
    endif()
endforeach()
