# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install: the program with its manual pages and completion, the rooms as static libraries with their headers, and
# the client of the protocol. The rooms keep their names below lib/orrery and include/orrery; pkg-config knows them as
# `orrery`, the client alone (libc, MIT) as `orrery-client`; CMake as Orrery::<room>.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS orrery orrery-generator RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)

# --- Manual pages and completion, from the command table ---
set(tables "${PROJECT_SOURCE_DIR}/src/cli/commands.def")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${tables}")
file(STRINGS "${tables}" lines REGEX "^ORR_COMMAND")
set(man_dir "${PROJECT_BINARY_DIR}/man")
set(pages "${man_dir}/orrery.1")
set(make_pages COMMAND orrery --man > "${man_dir}/orrery.1")
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^ORR_COMMAND\\(([a-z_]+)\\).*" "\\1" name "${line}")
  string(REPLACE "_" "-" name "${name}")
  list(APPEND pages "${man_dir}/orrery-${name}.1")
  list(APPEND make_pages COMMAND orrery --man ${name} > "${man_dir}/orrery-${name}.1")
endforeach()
set(completion_dir "${PROJECT_BINARY_DIR}/completion")
set(completions "${completion_dir}/orrery" "${completion_dir}/_orrery")
file(MAKE_DIRECTORY "${man_dir}" "${completion_dir}")
add_custom_command(OUTPUT ${pages} ${completions}
  ${make_pages}
  COMMAND orrery --completion bash > "${completion_dir}/orrery"
  COMMAND orrery --completion zsh > "${completion_dir}/_orrery"
  DEPENDS orrery COMMENT "Manual pages and completion" VERBATIM)
add_custom_target(orr_pages ALL DEPENDS ${pages} ${completions})
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES "${completion_dir}/orrery" DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES "${completion_dir}/_orrery" DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT program)

# --- Libraries and headers ---
set(rooms scenario make config iono orbit inertial ingest core) # in the order of linking
set(library_dir ${CMAKE_INSTALL_LIBDIR}/orrery)
set(header_dir ${CMAKE_INSTALL_INCLUDEDIR}/orrery)
foreach(room IN LISTS rooms ITEMS proto)
  set_property(TARGET orr_${room} PROPERTY EXPORT_NAME ${room})
endforeach()
set(targets ${rooms} proto flags)
list(TRANSFORM targets PREPEND orr_)
install(TARGETS ${targets} EXPORT OrreryTargets ARCHIVE DESTINATION ${library_dir} COMPONENT dev)
foreach(folder IN ITEMS core ingest orbit iono inertial proto src/config src/make src/scenario)
  get_filename_component(above ${folder} DIRECTORY)
  install(DIRECTORY ${folder} DESTINATION ${header_dir}/${above} COMPONENT dev FILES_MATCHING
    PATTERN "*.h" PATTERN "*.def" PATTERN "*_private.h" EXCLUDE PATTERN "firmware" EXCLUDE PATTERN "python" EXCLUDE
    PATTERN "spec" EXCLUDE)
endforeach()

# --- Python client and Wireshark dissector ---
# Below the prefix by default; Debian's packages have Python's own folder.
set(ORR_PYTHON_DIR ${CMAKE_INSTALL_DATADIR}/orrery/python CACHE STRING "Where the Python client goes")
install(DIRECTORY proto/python/orrery DESTINATION ${ORR_PYTHON_DIR} COMPONENT python FILES_MATCHING
  PATTERN "*.py" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
install(FILES proto/gen/orrery.lua DESTINATION ${CMAKE_INSTALL_DATADIR}/orrery/wireshark COMPONENT program)

# --- pkg-config, wherever the prefix comes to lie ---
file(RELATIVE_PATH pc_up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
set(pc_libs "")
foreach(room IN LISTS rooms)
  string(APPEND pc_libs " -lorr_${room}")
endforeach()
configure_file(cmake/orrery.pc.in orrery.pc @ONLY)
configure_file(cmake/orrery-client.pc.in orrery-client.pc @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/orrery.pc" "${PROJECT_BINARY_DIR}/orrery-client.pc"
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)

# --- CMake package ---
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Orrery)
install(EXPORT OrreryTargets NAMESPACE Orrery:: DESTINATION ${package_dir} COMPONENT dev)
configure_package_config_file(cmake/OrreryConfig.cmake.in OrreryConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(OrreryConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/OrreryConfig.cmake" "${PROJECT_BINARY_DIR}/OrreryConfigVersion.cmake"
  cmake/OrrDependencies.cmake DESTINATION ${package_dir} COMPONENT dev)

# --- What Debian's packages have beside: units, documentation, licences, changes ---
install(FILES packaging/orrery.service packaging/orrery.socket DESTINATION lib/systemd/system COMPONENT program)
install(FILES packaging/lintian-overrides RENAME orrery DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT program)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/orrery-doc/docs COMPONENT doc FILES_MATCHING PATTERN "*.md")
install(DIRECTORY samples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/orrery-doc/examples COMPONENT doc
  PATTERN "CMakeLists.txt" EXCLUDE PATTERN "__pycache__" EXCLUDE)
string(TIMESTAMP packaged "%a, %d %b %Y %H:%M:%S +0000" UTC) # SOURCE_DATE_EPOCH, where it is set
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/packaging/changelog" CONTENT "orrery (${PROJECT_VERSION}-1) unstable; urgency=medium

  * As CHANGELOG.md tells, which is in orrery-doc.

 -- ${CPACK_PACKAGE_CONTACT}  ${packaged}
")
execute_process(COMMAND gzip -9nkf "${PROJECT_BINARY_DIR}/packaging/changelog")
foreach(part IN ITEMS program:orrery dev:liborrery-dev python:python3-orrery doc:orrery-doc)
  string(REPLACE ":" ";" part ${part})
  list(GET part 0 component)
  list(GET part 1 package)
  install(FILES packaging/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
  install(FILES "${PROJECT_BINARY_DIR}/packaging/changelog.gz" RENAME changelog.Debian.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endforeach()
