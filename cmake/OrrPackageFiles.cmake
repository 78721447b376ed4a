# SPDX-License-Identifier: GPL-3.0-or-later
# Run by cpack before it makes the packages: manual pages are compressed as Debian has them, without a date.
file(GLOB pages "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/program/usr/share/man/man1/*.1")
if(pages)
  execute_process(COMMAND gzip -9n ${pages} COMMAND_ERROR_IS_FATAL ANY)
endif()
