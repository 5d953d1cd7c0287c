# What `cmake --install` puts beside the program, and the Debian package that `cpack -G DEB` makes of it.
include(CMakePackageConfigHelpers)
install(DIRECTORY assets/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/dsphere FILES_MATCHING PATTERN "*.pbrt")
install(PROGRAMS scripts/fetch-earth DESTINATION ${CMAKE_INSTALL_DATADIR}/dsphere)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
install(FILES completions/dsphere.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME dsphere)
install(FILES completions/_dsphere DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES completions/dsphere.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# `cmake --install BUILD --component library`: the library of docs/query.md with its header, and a package that
# find_package(dsphere) finds. It is no part of the program's own installation.
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/dsphere)
set(library COMPONENT library EXCLUDE_FROM_ALL)
install(TARGETS dsphere_base dsphere_scene dsphere_image dsphere_geo dsphere_surface dsphere_reference dsphere_gpu dsphere_render
                dsphere_verify dsphere_query
        EXPORT dsphere ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/dsphere ${library})
install(FILES src/query/query.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/dsphere ${library})
install(EXPORT dsphere FILE dsphere-targets.cmake NAMESPACE dsphere:: DESTINATION ${package_folder} ${library})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/dsphere-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/dsphere-config.cmake ${CMAKE_BINARY_DIR}/dsphere-config-version.cmake DESTINATION ${package_folder} ${library})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The dsphere authors")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The loader is opened at run time, which shlibdeps cannot see, as is GDAL; a driver may come from elsewhere; the geoid is a sample, as is
# the Earth, which npm fetches.
set(CPACK_DEBIAN_PACKAGE_DEPENDS libvulkan1)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "mesa-vulkan-drivers, fonts-dejavu-core, libgdal32")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "proj-data, npm")
include(CPack)
