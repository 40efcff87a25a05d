# What is installed: the program, and what it writes about itself (manual pages, completion, guide), the editor files and
# the licence. cpack makes a Debian package of the same.
include(GNUInstallDirs)
install(TARGETS rungproof)
install(FILES ${CMAKE_SOURCE_DIR}/frontend/package/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/rungproof)
file(GLOB editors CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/frontend/editor/*)
foreach(editor IN LISTS editors)
  if(IS_DIRECTORY ${editor})
    install(DIRECTORY ${editor} DESTINATION ${CMAKE_INSTALL_DATADIR}/rungproof/editor PATTERN node_modules EXCLUDE
      PATTERN "*.vsix" EXCLUDE PATTERN "*.cpp" EXCLUDE PATTERN "*.hpp" EXCLUDE)
  endif()
endforeach()
install(CODE "set(RUNGPROOF \"$<TARGET_FILE:rungproof>\")\nset(DATA_DIR \"${CMAKE_INSTALL_DATADIR}\")\nset(MAN_DIR \"${CMAKE_INSTALL_MANDIR}\")")
install(SCRIPT ${CMAKE_SOURCE_DIR}/frontend/package/written.cmake)

set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # packing does not build the tests
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rungproof)
set(CPACK_PACKAGE_VERSION ${RUNGPROOF_VERSION})
set(CPACK_PACKAGE_CONTACT "the rungproof authors <authors@rungproof.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "model checker and static analyser for S7-200 programs")
set(CPACK_PACKAGE_DESCRIPTION
"Reads ladder, FBD and STL programs of Siemens S7-200, S7-200 SMART and S7-300/400 controllers, reports what is
wrong in them, proves safety interlocks or shows the run that breaks them, and compares simulated with expected traces.
Every proof comes with a certificate that another solver can check.")
# For the archive, which lies beside other things until it is copied to its place.
set(CPACK_PACKAGE_FILE_NAME rungproof-${RUNGPROOF_VERSION}-linux-x64)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cvc5, man-db")
find_program(SHLIBDEPS dpkg-shlibdeps)
if(SHLIBDEPS)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
else()  # as it gives them on Debian 12
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "libc6 (>= 2.36), libfmt9 (>= 9.1.0), libgcc-s1, libicu72 (>= 72.1), libmimalloc2.0, libpugixml1v5 (>= 1.4), libstdc++6 (>= 12), libz3-4, zlib1g")
endif()
include(CPack)
