# SPDX-License-Identifier: MIT
# `cmake --install` installs the core, the modules, their public headers and the files that
# find_package(dsc) needs: dsc::dsc, and dsc::NAME for each module.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/dsc)
# The installed and exported parts of each module are collected when the build is generated.
install(EXPORT dscTargets NAMESPACE dsc:: DESTINATION ${package_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/dsc-config.cmake.in
    ${CMAKE_CURRENT_BINARY_DIR}/dscConfig.cmake INSTALL_DESTINATION ${package_dir})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/dscConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES
    ${CMAKE_CURRENT_BINARY_DIR}/dscConfig.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/dscConfigVersion.cmake
    DESTINATION ${package_dir})

if(PROJECT_IS_TOP_LEVEL)
    add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -D manifest=${PROJECT_BINARY_DIR}/install_manifest.txt
        -P ${CMAKE_CURRENT_LIST_DIR}/uninstall.cmake)
endif()

# dsc_install_module(module target folder [ON module...]): the library, the public headers of lib/MODULE
# below `folder`, which is relative to the prefix and holds MODULE/, and TARGET.pc for pkg-config. Installed headers
# include those of modules as "dsc/MODULE/...", so that a folder of the application with the name of a module, such as
# fluid, does not get in the way.
function(dsc_install_module module target folder)
    cmake_parse_arguments(PARSE_ARGV 3 arg "" "" "ON")
    list(TRANSFORM arg_ON PREPEND dsc_)
    set(requires "eigen3")
    set(private "-lz -fopenmp")
    if(NOT target STREQUAL dsc)
        list(JOIN arg_ON " " requires)
        string(PREPEND requires "dsc ")
        set(private "")
    endif()
    get_target_property(library ${target} OUTPUT_NAME)
    if(NOT library)
        set(library ${target})
    endif()
    configure_file(${PROJECT_SOURCE_DIR}/lib/dsc/dsc.pc.in ${PROJECT_BINARY_DIR}/${target}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${target}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
    install(TARGETS ${target} EXPORT dscTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
    target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${folder}>)
    install(CODE "
        set(source \"${PROJECT_SOURCE_DIR}/lib\")
        include(\"${PROJECT_SOURCE_DIR}/lib/dsc/public_headers.cmake\")
        dsc_public_headers(headers \${source} ${module})
        foreach(header IN LISTS headers)
            get_filename_component(subfolder \${header} DIRECTORY)
            file(READ \${source}/\${header} text)
            string(REGEX REPLACE \"#include \\\"([a-z0-9_]+/)\" \"#include \\\"dsc/\\\\1\" text \"\${text}\")
            string(REPLACE \"#include \\\"dsc/dsc/\" \"#include \\\"dsc/\" text \"\${text}\")
            file(WRITE \"${PROJECT_BINARY_DIR}/installed_headers/\${header}\" \"\${text}\")
            file(INSTALL \"${PROJECT_BINARY_DIR}/installed_headers/\${header}\"
                DESTINATION \${CMAKE_INSTALL_PREFIX}/${folder}/\${subfolder})
        endforeach()")
endfunction()

dsc_install_module(dsc dsc ${CMAKE_INSTALL_INCLUDEDIR})
