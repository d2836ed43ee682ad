# The Debian package: cpack in the build folder makes netwright_VERSION_ARCHITECTURE.deb. What it depends on is read off
# the programs; only what they load by themselves is named here.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME netwright)
set(CPACK_PACKAGE_CONTACT "The Netwright authors <netwright@netwright.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "unfold a 3-D model into one piece of paper")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Netwright turns a 3-D model into a single piece of paper
without overlaps, shows live how it is found, proves the result, and prints it
at true size to cut, fold and glue. netwright-cli does the same without a
window.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(NETWRIGHT_GUI)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1, hicolor-icon-theme")  # the window's toolkit opens libGL itself
endif()
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS ${CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS})
include(CPack)
