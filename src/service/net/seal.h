// SPDX-License-Identifier: GPL-3.0-or-later
// HMAC-SHA-256 behind datagrams, by keys that both ends of a TLS session get from it without sending them (RFC 8446, 7.5; RFC 5705).
#ifndef ORR_SERVICE_NET_SEAL_H
#define ORR_SERVICE_NET_SEAL_H

#include <openssl/ssl.h>
#include <stdbool.h>
#include <stdint.h>

enum { ORR_SEAL_KEY = 32, ORR_SEAL_KEYS = 2 * ORR_SEAL_KEY };

// Keys of the two directions, as DATAGRAMS has them.
typedef struct orr_seal_keys {
    uint8_t client[ORR_SEAL_KEY]; // of what the client sends
    uint8_t server[ORR_SEAL_KEY]; // of what the server sends
} orr_seal_keys;

// A key made ready; one thread at a time uses it.
typedef struct orr_seal orr_seal;

// The keys of a session whose handshake is done; both ends get the same. False: the session has none.
bool orr_seal_keys_of(SSL *ssl, orr_seal_keys *out);
// Makes a key ready; NULL: out of memory. Free with orr_seal_close.
orr_seal *orr_seal_open(const uint8_t key[ORR_SEAL_KEY]);
void orr_seal_close(orr_seal *s); // NULL is allowed
// Puts the 32 bytes of the seal of data[0..n) behind them. False: out of memory.
bool orr_seal_put(orr_seal *s, uint8_t *data, size_t n);
// Whether the 32 bytes behind data[0..n) are its seal; takes the same time whatever they are. `user` is the seal (orr_datagram_reader).
bool orr_seal_holds(void *user, const uint8_t *data, size_t n);

#endif
