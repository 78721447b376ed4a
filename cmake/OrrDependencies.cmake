# SPDX-License-Identifier: GPL-3.0-or-later
# Libraries of Debian 12 that we lean on (docs/architecture.md says why each).
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
foreach(dep IN ITEMS gsl erfa netcdf jansson sqlite3 libfyaml zlib libdeflate libcurl openssl geographiclib)
  pkg_check_modules(${dep} REQUIRED IMPORTED_TARGET ${dep})
endforeach()
pkg_check_modules(libevent REQUIRED IMPORTED_TARGET libevent libevent_openssl libevent_pthreads)
