# SPDX-License-Identifier: MIT
# Registers the suites of one GoogleTest program. CTest reads this when it starts, not the build when
# it ends: the sanitizers' environment comes from the test preset. Set before: `name`, `program`,
# `results`, `labels`, `timeout`, and `each_case`, which names the suites whose cases take long:
# each of these cases runs by itself, and first. All other suites run in one process each. No test
# compares times, so tests of threads may share the cores.

cmake_minimum_required(VERSION 3.25)

# A test that a preset selects by label but did not build must fail, not vanish.
if(NOT EXISTS ${program})
    add_test(${name}_NOT_BUILT ${program})
    set_tests_properties(${name}_NOT_BUILT PROPERTIES LABELS "${labels}")
    return()
endif()

execute_process(COMMAND ${program} --gtest_list_tests
    OUTPUT_VARIABLE listing RESULT_VARIABLE code ERROR_VARIABLE error TIMEOUT 60)
if(NOT code EQUAL 0)
    message(FATAL_ERROR "${program} --gtest_list_tests failed (${code}):\n${error}")
endif()

# "Suite." or "Prefix/Suite." or, for a typed one, "Suite/0.  # TypeParam = double"; then its cases,
# each indented by two blanks.
string(REGEX REPLACE " +#[^\n]*" "" listing "${listing}")
string(REPLACE "\n" ";" lines "${listing}")
set(known)
foreach(line IN LISTS lines)
    if(line MATCHES "^([^ ].*)\\.$")
        set(suite ${CMAKE_MATCH_1})
        set(cost 0)
        string(REGEX REPLACE "/[0-9]$" "" base ${suite})
        set(test ${base})
        if(suite STREQUAL base)
            set(filter "${base}.*")
        else()
            set(filter "${base}/?.*") # all types together
        endif()
    elseif(line MATCHES "^  (.+)$")
        set(case ${CMAKE_MATCH_1})
        if(base MATCHES "(^|/)(${each_case})$")
            set(test ${suite}.${case})
            set(filter ${test})
            set(cost 50)
        endif()
        if(test IN_LIST known)
            continue()
        endif()
        list(APPEND known ${test})
        string(REPLACE "/" "_" file ${name}.${test})
        add_test(${name}.${test} ${program} --gtest_filter=${filter} --gtest_brief=1
            --gtest_also_run_disabled_tests=0 --gtest_output=xml:${results}/${file}.xml)
        set_tests_properties(${name}.${test} PROPERTIES LABELS "${labels}"
            TIMEOUT ${timeout} COST ${cost})
    endif()
endforeach()
