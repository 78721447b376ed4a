// SPDX-License-Identifier: GPL-3.0-or-later
// A seal at the end of our NetCDF files: one line with the SHA-256 of all bytes before it. The HDF5 library
// may crash or hang on damaged bytes (a few in ten thousand random damages did), so damage is to be found
// before it sees them. HDF5 ignores bytes after its own end of file, so that every other program reads a
// sealed file as well; and a file without a seal, from another program, is opened as it is. Only ncread.c and
// ncwrite.c include this.
#ifndef ORR_CORE_NCSEAL_H
#define ORR_CORE_NCSEAL_H

#include "core/status.h"

// Appends the seal to a finished file.
orr_status orr_nc_seal(const char *path, orr_diag *diag);
// ORR_OK if there is no seal or it fits; ORR_E_FORMAT if it does not, or is cut.
orr_status orr_nc_check_seal(const char *path, orr_diag *diag);

#endif
