# SPDX-License-Identifier: GPL-3.0-or-later
# How everything of ours is compiled: one place for flags, sanitizers and the shape of a room.
set(CMAKE_C_STANDARD 17)
set(CMAKE_C_STANDARD_REQUIRED ON)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

option(ORR_WERROR "Treat compiler warnings as errors" OFF)
set(ORR_SANITIZE "" CACHE STRING "Value of -fsanitize=, e.g. address,undefined")
option(ORR_COVERAGE "Instrument for gcov" OFF)
option(ORR_FUZZ "Build the libFuzzer targets (clang)" OFF)

find_program(ORR_CCACHE ccache)
if(ORR_CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER "${ORR_CCACHE}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${ORR_CCACHE}")
endif()

add_library(orr_flags INTERFACE)
# No contraction into FMA: the same product and time give the same bytes whichever compiler built us.
set(ORR_C_WARNINGS -Wconversion -Wstrict-prototypes -Wmissing-prototypes -Wvla)
# Users of the installed libraries compile as they like: these are for the build of Orrery alone.
target_compile_options(orr_flags INTERFACE
  "$<BUILD_INTERFACE:-ffp-contract=off;-fno-math-errno;-Wall;-Wextra;-Wpedantic;-Wshadow;-Wdouble-promotion>"
  "$<BUILD_INTERFACE:$<$<COMPILE_LANGUAGE:C>:${ORR_C_WARNINGS}>>")
target_compile_definitions(orr_flags INTERFACE
  "$<BUILD_INTERFACE:_POSIX_C_SOURCE=200809L;_XOPEN_SOURCE=700;ORR_VERSION=\"${PROJECT_VERSION}\">")
include(GNUInstallDirs)
target_include_directories(orr_flags INTERFACE
  "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/orrery>")
# Against errors that nobody has found. What is compiled so is the release alone: the other builds look for errors themselves.
option(ORR_HARDEN "Stack protector, FORTIFY_SOURCE, CET, relocations read-only" ON)
if(ORR_HARDEN AND NOT ORR_SANITIZE AND NOT ORR_COVERAGE AND NOT ORR_FUZZ)
  include(CheckCCompilerFlag)
  check_c_compiler_flag(-fcf-protection=full ORR_HAS_CET)
  set(hardened -fstack-protector-strong -fstack-clash-protection -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3)
  if(ORR_HAS_CET AND CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
    list(APPEND hardened -fcf-protection=full)
    add_link_options($<$<CONFIG:Release>:-Wl,-z,ibt,-z,shstk>)
  endif()
  # No folder of the machine that builds it: the same bytes from any checkout.
  list(APPEND hardened -ffile-prefix-map=${PROJECT_SOURCE_DIR}=.)
  target_compile_options(orr_flags INTERFACE "$<BUILD_INTERFACE:$<$<CONFIG:Release>:${hardened}>>")
  add_link_options(-pie -Wl,-z,relro,-z,now,-z,noexecstack)
endif()
if(ORR_WERROR)
  target_compile_options(orr_flags INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()
if(ORR_SANITIZE)
  target_compile_options(orr_flags INTERFACE -fsanitize=${ORR_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(orr_flags INTERFACE -fsanitize=${ORR_SANITIZE})
endif()
if(ORR_COVERAGE)
  target_link_options(orr_flags INTERFACE --coverage)
endif()
if(ORR_FUZZ)
  target_compile_options(orr_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# orr_room(<name> SOURCES ... [PUBLIC libs...] [PRIVATE libs...]): one static library per folder, orr_<name>.
function(orr_room name)
  cmake_parse_arguments(R "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(orr_${name} STATIC ${R_SOURCES})
  target_link_libraries(orr_${name} PUBLIC orr_flags ${R_PUBLIC} PRIVATE ${R_PRIVATE} m)
  # Counted are the rooms that bytes from outside come through; the others are compiled as for work, so that all tests can be run.
  if(ORR_COVERAGE AND name MATCHES "^(core|ingest|proto|service)$")
    target_compile_options(orr_${name} PRIVATE --coverage -fprofile-update=atomic -O0) # threads count too
  endif()
endfunction()

# Where real IGS files are; tests that need them are given this path and skip with a reason where it is empty.
set(ORR_DATA_DIR "$ENV{ORRERY_DATA}")
if(NOT ORR_DATA_DIR)
  set(ORR_DATA_DIR "${PROJECT_SOURCE_DIR}/../shared/data")
endif()
