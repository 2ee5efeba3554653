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

# Starts from an empty folder, so that headers that are no longer installed are found missing.
file(REMOVE_RECURSE ${work})
set(prefix ${work}/prefix)
stage(install ${CMAKE_COMMAND} --install ${library} --prefix ${prefix})

# Every header that an installed header includes is installed, and every header except dsc.h,
# engine.h and MODULE/MODULE.h is included by another. Nothing but dsc/ is below include/.
set(modules dsc3 fluid geometric_flows replay thesis topology)
if(EXISTS ${prefix}/include/dsc/surface_files)
    list(APPEND modules surface_files)
endif()
file(GLOB_RECURSE installed RELATIVE ${prefix}/include ${prefix}/include/*)
set(included dsc/dsc.h dsc/engine.h)
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

# A component that does not exist: the error names those that do.
file(WRITE ${work}/misspelt/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(misspelt LANGUAGES CXX)
find_package(dsc REQUIRED COMPONENTS topologie)
")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${work}/misspelt -B ${work}/misspelt/build -G ${generator}
    -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${compiler}
    RESULT_VARIABLE code ERROR_VARIABLE text OUTPUT_QUIET)
string(REGEX REPLACE "[ \n]+" " " text "${text}")
if(code EQUAL 0 OR NOT text MATCHES "no component 'topologie'; it has dsc3, fluid, .*topology")
    message(FATAL_ERROR "stage misspelt: ${text}")
endif()

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
find_program(pkg_config pkg-config)
if(pkg_config)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${prefix}/lib/pkgconfig ${pkg_config}
        --cflags --libs dsc_topology OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(words UNIX_COMMAND "${flags} ${text}")
    stage(pkg-config ${compiler} -std=c++20 ${source}/modules/topology.cpp -o ${work}/by_pkg_config ${words})
endif()
stage(configure-modules ${CMAKE_COMMAND} -S ${source}/modules -B ${work}/modules ${options})
stage(build-modules ${CMAKE_COMMAND} --build ${work}/modules)
foreach(module IN LISTS modules ITEMS space)
    stage(run-${module} ${CMAKE_COMMAND} -E chdir ${work} ${work}/modules/${module})
endforeach()

# The library's results are bitwise the same, whichever flags its user is compiled with.
if(build_type STREQUAL "Release")
    stage(configure-native ${CMAKE_COMMAND} -S ${source}/modules -B ${work}/native ${options}
        -D CMAKE_CXX_FLAGS=-march=native)
    stage(build-native ${CMAKE_COMMAND} --build ${work}/native --target replay)
    foreach(kind modules native)
        execute_process(COMMAND ${work}/${kind}/replay OUTPUT_VARIABLE printed_${kind} COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
    if(NOT printed_native STREQUAL printed_modules)
        message(FATAL_ERROR "stage native: ${printed_native} instead of ${printed_modules}")
    endif()
endif()

file(STRINGS ${work}/build/CMakeCache.txt found REGEX "^dsc_DIR")
if(NOT found MATCHES "${prefix}")
    message(FATAL_ERROR "stage configure found another library: ${found}")
endif()

# A second installation elsewhere, for the test of uninstall.cmake.
file(COPY ${prefix}/ DESTINATION ${work}/second)
file(GLOB_RECURSE manifest ${work}/second/*)
list(JOIN manifest "\n" manifest)
file(WRITE ${work}/manifest.txt "${manifest}\n")
stage(uninstall ${CMAKE_COMMAND} -D manifest=${work}/manifest.txt -P ${project}/lib/dsc/uninstall.cmake)
if(EXISTS ${work}/second)
    message(FATAL_ERROR "stage uninstall: ${work}/second is still there")
endif()
