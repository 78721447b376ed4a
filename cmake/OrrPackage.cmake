# SPDX-License-Identifier: GPL-3.0-or-later
# cpack -G DEB: Debian packages of the components that OrrInstall.cmake names: orrery (programs, manual, units), liborrery-dev (libraries,
# headers), python3-orrery (the client) and orrery-doc. `./check --deb` makes them, asks lintian, and installs them on a clean Debian 12.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME orrery)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "Orrery")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "back end of a GNSS signal generator")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENTS_ALL program dev python doc)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME orrery)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/packaging/postinst;${PROJECT_SOURCE_DIR}/packaging/postrm")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Satellite orbits and clocks, the ionosphere, broadcast data and inertial
 readings, prepared from published files and served by time tag.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME liborrery-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libgsl-dev, liberfa-dev, libnetcdf-dev, libfyaml-dev, zlib1g-dev, libdeflate-dev, libcurl4-openssl-dev, libssl-dev, libgeographiclib-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "static libraries and headers of Orrery
 The rooms of the program as libraries, and the client of its protocol.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-orrery)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/packaging/python/prerm")
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.10)")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Python client of Orrery's service
 Polls, streams, clock and live motion, over TCP, TLS and Unix sockets.")
set(CPACK_DEBIAN_DOC_PACKAGE_NAME orrery-doc)
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOC_PACKAGE_SECTION doc)
set(CPACK_COMPONENT_DOC_DESCRIPTION "documentation of Orrery
 Its protocol, scenario file, formats and methods, and samples.")
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/OrrPackageFiles.cmake")
include(CPack)
