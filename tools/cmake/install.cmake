# cmake --install: the program, the libraries with their headers, presets, and what find_package(plinian) reads.
include(CMakePackageConfigHelpers)

foreach(library core viewport)
  set_target_properties(plinian_${library} PROPERTIES EXPORT_NAME ${library})
  install(TARGETS plinian_${library} EXPORT plinian-targets)
endforeach()
install(TARGETS plinian)
# A plug-in needs a few headers, and none of the libraries that the program is made of.
set_target_properties(plinian_plugin PROPERTIES EXPORT_NAME plugin)
install(TARGETS plinian_plugin EXPORT plinian-plugin-targets)
install(FILES host/sdk/abi.h host/sdk/plugin.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plinian/host/sdk)
install(DIRECTORY host/sdk/abi host/sdk/plugin DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plinian/host/sdk)

foreach(folder core viewport)
  install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plinian FILES_MATCHING PATTERN "*.h")
endforeach()
install(DIRECTORY host/sdk/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/plinian)
install(DIRECTORY presets DESTINATION ${CMAKE_INSTALL_DATADIR}/plinian)
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY tools/figures/pictures DESTINATION ${CMAKE_INSTALL_DOCDIR}/tools/figures)  # that the README shows

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/plinian)
install(EXPORT plinian-targets NAMESPACE plinian:: DESTINATION ${package})
install(EXPORT plinian-plugin-targets NAMESPACE plinian:: DESTINATION ${package})
configure_package_config_file(tools/cmake/plinian-config.cmake.in ${PROJECT_BINARY_DIR}/plinian-config.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/plinian-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/plinian-config.cmake ${PROJECT_BINARY_DIR}/plinian-config-version.cmake
              tools/cmake/FindOpenColorIO.cmake
        DESTINATION ${package})
