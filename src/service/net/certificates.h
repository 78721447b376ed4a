// SPDX-License-Identifier: GPL-3.0-or-later
// A private authority for a laboratory, and certificates from it: EC keys on P-256, signed with SHA-256, written as PEM. Keys have mode 0600.
#ifndef ORR_SERVICE_NET_CERTIFICATES_H
#define ORR_SERVICE_NET_CERTIFICATES_H

#include "core/status.h"

enum {
    ORR_CERTIFICATE_DAYS = 825,
    ORR_AUTHORITY_DAYS = 3650,
};

// Makes the authority: DIR/ca.pem and DIR/ca.key; DIR is made where it is missing. An authority that is there already stays.
//   Given:    dir   the folder
//             days  how long it is valid from now; negative: it has expired
//   Returned: diag  why it failed
//   Errors:   ORR_E_ARG (there is one already), ORR_E_IO, ORR_E_MEMORY
orr_status orr_certificates_authority(const char *dir, int days, orr_diag *diag);
// Makes the service's certificate: DIR/server.pem and DIR/server.key, in place of those that are there.
//   Given:    dir    folder of the authority
//             names  [n] names and addresses that clients connect to
//             n      how many, at least one
//             days   how long it is valid from now; negative: it has expired
//   Returned: diag   why it failed
//   Errors:   ORR_E_ARG (a name that is none), ORR_E_IO, ORR_E_FORMAT (the authority's files), ORR_E_MEMORY
orr_status orr_certificates_server(const char *dir, const char *const *names, size_t n, int days,
                                   orr_diag *diag);
// Makes a client's: DIR/NAME.pem, certificate and key in one, in place of one that is there.
//   Given:    dir   folder of the authority
//             name  1 to 48 letters, digits, '-', '_', '.'; the certificate's common name
//             days  how long it is valid from now; negative: it has expired
//   Returned: diag  why it failed
//   Errors:   as of orr_certificates_server
orr_status orr_certificates_client(const char *dir, const char *name, int days, orr_diag *diag);

#endif
