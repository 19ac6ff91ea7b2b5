# `cmake --install`, and with cpack the Debian package (scripts/package, which makes the manual pages
# and the gallery first).

include(GNUInstallDirs)

set(ossuary_documents ${CMAKE_INSTALL_DATAROOTDIR}/doc/ossuary)

install(TARGETS ossuary ossuary_server RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS ossuary_read RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/ossuary)
if(TARGET ossuary_read_cad)
    install(TARGETS ossuary_read_cad RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/ossuary)
endif()
install(DIRECTORY web/dist/ DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/ossuary/web)
install(DIRECTORY ${PROJECT_BINARY_DIR}/package/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
install(DIRECTORY ${PROJECT_BINARY_DIR}/package/doc/ DESTINATION ${ossuary_documents})
install(DIRECTORY docs/ DESTINATION ${ossuary_documents}
        FILES_MATCHING PATTERN "*.md" PATTERN "monitoring/*" PATTERN benchmarks EXCLUDE)
install(FILES README.md DESTINATION ${ossuary_documents})
install(FILES packaging/ossuary.bash RENAME ossuary
        DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions)
install(FILES packaging/ossuary.bash RENAME ossuary-server
        DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions)
install(FILES packaging/_ossuary DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/zsh/vendor-completions)
install(FILES packaging/ossuary-server.service packaging/ossuary-watch@.service
        DESTINATION /lib/systemd/system)
install(FILES packaging/server.conf DESTINATION /etc/ossuary)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ossuary)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "Ossuary <ossuary@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "search engine for 3D models, by their skeletons")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Given a model, Ossuary answers which models of a collection are built like\n\
it and which stand like it, shows why, and cuts models into parts that can be\n\
posed. The package has the indexer, the HTTP server and its gallery.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/conffiles)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/..)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# As dpkg wants them, whatever the mask of whoever builds.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
include(CPack)
