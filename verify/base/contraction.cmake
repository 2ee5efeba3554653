# SPDX-License-Identifier: MIT
# No library contains a fused multiply-add that its source does not ask for: where the compiler fuses
# depends on what it has inlined, and with it the last bits of a result (see dsc_flags). Called with
# `objdump` and `libraries`. Only a build for a processor that has such instructions (the preset
# release) can fail.
foreach(library IN LISTS libraries)
    execute_process(COMMAND ${objdump} --disassemble --no-show-raw-insn ${library}
        OUTPUT_VARIABLE instructions RESULT_VARIABLE code ERROR_VARIABLE error)
    if(NOT code EQUAL 0)
        message(FATAL_ERROR "${objdump} cannot read ${library}:\n${error}")
    endif()
    # x86: vfmadd231sd, vfmaddsub132pd, ...; ARM: fmadd, fmls, ...
    string(REGEX MATCHALL "\t(vfn?m(add|sub)|fn?m(add|sub)|fml[as])[^\n]*" fused "${instructions}")
    if(fused)
        list(LENGTH fused number)
        list(GET fused 0 first)
        string(STRIP "${first}" first)
        message(SEND_ERROR "${library}: ${number} fused multiply-adds, the first: ${first}")
    endif()
endforeach()
