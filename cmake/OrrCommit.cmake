# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DSOURCE=dir -DOUTPUT=file.h -DRELEASE=x.y.z -P OrrCommit.cmake: what the program is built from, for --version
# --verbose: the commit in a checkout, else the release. The file changes only when that does.
set(commit "")
if(EXISTS "${SOURCE}/.git")
  execute_process(COMMAND git describe --always --dirty --abbrev=12 --exclude=* WORKING_DIRECTORY "${SOURCE}"
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed)
    set(commit "")
  endif()
endif()
if(commit)
  set(text "commit ${commit}")
else()
  set(text "release ${RELEASE}")
endif()
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "// Made by OrrCommit.cmake.\n#define ORR_BUILT_FROM \"${text}\"\n" @ONLY)
