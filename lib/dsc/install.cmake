# SPDX-License-Identifier: MIT
# `cmake --install` gives the library, its public headers and what find_package(dsc) needs:
# dsc::dsc.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Who links the library must compile as it was compiled: -march=native changes the alignment that
# Eigen allocates with, and fused multiply-adds in its templates would change results.
target_compile_options(dsc INTERFACE
    $<INSTALL_INTERFACE:-ffp-contract=off>
    $<INSTALL_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>>
    $<INSTALL_INTERFACE:$<$<BOOL:${DSC_NATIVE}>:-march=native>>)

install(TARGETS dsc EXPORT dscTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(CODE "
    set(source \"${PROJECT_SOURCE_DIR}/lib\")
    set(destination \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\")
    include(\"${CMAKE_CURRENT_LIST_DIR}/public_headers.cmake\")
    foreach(header IN LISTS public_headers)
        get_filename_component(folder \${header} DIRECTORY)
        file(INSTALL \${source}/\${header} DESTINATION \${destination}/\${folder})
    endforeach()")

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/dsc)
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
