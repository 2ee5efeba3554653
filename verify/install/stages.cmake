# SPDX-License-Identifier: MIT
# Installs the library into the build tree, then configures, builds and runs a stranger's program.
# A failure names its stage. Run by CTest, see verify/CMakeLists.txt.
function(stage name)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
    if(NOT code EQUAL 0)
        message(FATAL_ERROR "stage ${name} failed (${code}):\n${text}")
    endif()
    message(STATUS "${name}: done")
endfunction()

# From nothing, so that a header that is no longer installed is missed.
file(REMOVE_RECURSE ${work})
set(prefix ${work}/prefix)
stage(install ${CMAKE_COMMAND} --install ${library} --prefix ${prefix})

# Headers: what an installed one includes is there, and each but dsc.h and those of the modules that
# have their name is included by another. Nothing but dsc/ is below include/.
set(modules dsc3 fluid geometric_flows replay thesis topology)
if(EXISTS ${prefix}/include/dsc/surface_files)
    list(APPEND modules surface_files)
endif()
file(GLOB_RECURSE installed RELATIVE ${prefix}/include ${prefix}/include/*)
set(included dsc/dsc.h)
foreach(module IN LISTS modules)
    list(APPEND included dsc/${module}/${module}.h)
endforeach()
list(JOIN modules "|" modules_pattern)
foreach(header IN LISTS installed)
    file(STRINGS ${prefix}/include/${header} lines REGEX "^#include \"")
    foreach(line IN LISTS lines)
        string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" other ${line})
        if(other MATCHES "^(${modules_pattern})/")
            string(PREPEND other dsc/)
        endif()
        list(APPEND included ${other})
    endforeach()
endforeach()
list(REMOVE_DUPLICATES included)
list(SORT included)
list(SORT installed)
if(NOT installed STREQUAL included)
    set(extra ${installed})
    list(REMOVE_ITEM extra ${included})
    list(REMOVE_ITEM included ${installed})
    message(FATAL_ERROR "stage headers: installed, though nothing public includes them: ${extra}; "
                        "included, but not installed: ${included}")
endif()
message(STATUS "headers: done")

# The gate, if it is built, holds runs to the suites that are installed with it.
if(EXISTS ${prefix}/bin/dsc_verify)
    stage(gate ${prefix}/bin/dsc_verify run accuracy_area --out ${work}/gate)
    file(READ ${work}/gate/verify.json result)
    string(JSON suite GET "${result}" suites 0)
    file(REAL_PATH ${prefix}/share/dsc/suites/accuracy.toml expected)
    if(NOT suite STREQUAL expected)
        message(FATAL_ERROR "stage gate: the suite is ${suite}, not ${expected}")
    endif()
endif()

# The Python package is installed with its compiled part or not at all.
if(python)
    file(GLOB package ${prefix}/lib/python*/dist-packages)
    if(NOT package)
        message(FATAL_ERROR "stage import: no package below ${prefix}/lib/python*")
    endif()
    stage(import ${CMAKE_COMMAND} -E env --unset=PYTHONPATH ${CMAKE_COMMAND} -E chdir ${package}
        ${python} -B -c "import dsc; dsc.circle((0, 0), 1, 0.1); print(dsc.__version__)")
endif()
stage(configure-only ${CMAKE_COMMAND} -S ${project} -B ${work}/not_built -G ${generator}
    -D CMAKE_CXX_COMPILER=${compiler} -D DSC_NATIVE=OFF)
stage(install-nothing ${CMAKE_COMMAND} --install ${work}/not_built --component python
    --prefix ${work}/nothing)
file(GLOB_RECURSE installed ${work}/nothing/*)
if(installed)
    message(FATAL_ERROR "stage install-nothing: installed, though nothing is built: ${installed}")
endif()

set(options -G ${generator}
    -D CMAKE_PREFIX_PATH=${prefix}
    -D CMAKE_CXX_COMPILER=${compiler}
    -D CMAKE_CXX_FLAGS=${flags}
    -D CMAKE_BUILD_TYPE=${build_type})
stage(configure ${CMAKE_COMMAND} -S ${source} -B ${work}/build ${options})
stage(build ${CMAKE_COMMAND} --build ${work}/build)
stage(run ${work}/build/stranger)
stage(configure-modules ${CMAKE_COMMAND} -S ${source}/modules -B ${work}/modules ${options})
stage(build-modules ${CMAKE_COMMAND} --build ${work}/modules)
foreach(module IN LISTS modules ITEMS space)
    stage(run-${module} ${CMAKE_COMMAND} -E chdir ${work} ${work}/modules/${module})
endforeach()

file(STRINGS ${work}/build/CMakeCache.txt found REGEX "^dsc_DIR")
if(NOT found MATCHES "${prefix}")
    message(FATAL_ERROR "stage configure found another library: ${found}")
endif()
