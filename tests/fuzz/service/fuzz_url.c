// SPDX-License-Identifier: GPL-3.0-or-later
// Addresses as users write them: what is read is told so that it is read as the same again.
#include <stdlib.h>
#include <string.h>

#include "src/service/net/url.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    char text[600], told[ORR_URL_TEXT], twice[ORR_URL_TEXT];
    if (n >= sizeof text) return 0;
    memcpy(text, data, n);
    text[n] = '\0';
    orr_url u, again;
    orr_diag diag = {0};
    if (orr_url_parse(text, &u, &diag) != ORR_OK) {
        if (diag.text[0] == '\0') abort();
        return 0;
    }
    if (orr_url_parse(orr_url_text(&u, told), &again, &diag) != ORR_OK) abort();
    if (strcmp(told, orr_url_text(&again, twice)) != 0) abort();
    if (u.is_unix != again.is_unix || u.tls != again.tls || u.port != again.port) abort();
    (void)orr_url_is_local(&u);
    return 0;
}
