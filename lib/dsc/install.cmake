# SPDX-License-Identifier: MIT
# `cmake --install` gives the core, the modules, their public headers and what find_package(dsc) needs:
# dsc::dsc, and dsc::NAME for each module.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Programs that link the library must be compiled with the same flags: -march=native changes the
# alignment that Eigen allocates with, and fused multiply-adds in its templates would change results.
target_compile_options(dsc INTERFACE
    $<INSTALL_INTERFACE:-ffp-contract=off>
    $<INSTALL_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>>
    $<INSTALL_INTERFACE:$<$<BOOL:${DSC_NATIVE}>:-march=native>>)

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

# dsc_install_module(module target folder): the library, and the public headers of lib/MODULE below
# `folder`, which is relative to the prefix and holds MODULE/.
function(dsc_install_module module target folder)
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
            file(INSTALL \${source}/\${header}
                DESTINATION \${CMAKE_INSTALL_PREFIX}/${folder}/\${subfolder})
        endforeach()")
endfunction()

dsc_install_module(dsc dsc ${CMAKE_INSTALL_INCLUDEDIR})
