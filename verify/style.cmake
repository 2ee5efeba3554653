# SPDX-License-Identifier: MIT
# Whether all sources are as clang-format leaves them, by the style of the project's .clang-format; but for
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
