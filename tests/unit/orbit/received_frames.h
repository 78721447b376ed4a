// SPDX-License-Identifier: GPL-3.0-or-later
// Codewords of newer messages that were received on the air in 2024 (QZSS' second satellite, three of BeiDou-3), hexadecimal, the last
// digit filled with zeros; as published with the tests of PocketSDR (tomojitakasu/PocketSDR, test/python/sdr_ldpc_test.py).
#ifndef ORR_TESTS_UNIT_ORBIT_RECEIVED_FRAMES_H
#define ORR_TESTS_UNIT_ORBIT_RECEIVED_FRAMES_H

#include "orbit/navdata/page.h"

#define RECEIVED_CNAV2_SUBFRAME2                                                                             \
    "47c8309c604e7e3008400952e28d67ff200ca4bda85933c45caefed8426ccb9233d81d05717f18bf790e00cdff957fa2"       \
    "1f80294b0017fbfcb55d03ff6349fffbe00004fffdffc7e42b23bfd38222557fc85264588716305dee263ddc3decee57"       \
    "b3fd7909e41b9fc19156ab119f067a9b03ab96f0506d1f6082b40c1b10b3a4a1340fd0198711200c73844f3764c4f8d9"       \
    "478b06d78f6d"
#define RECEIVED_CNAV2_SUBFRAME3                                                                             \
    "c2111f2818e00880400795d746343e96e068000000000000000000000000000a2d6883f8e746213ce7097f508dfa6dcf"       \
    "de45c80a29244f07f443e001cd0ec87151f6c78e7"
#define RECEIVED_BCNAV1_SUBFRAME2                                                                            \
    "1d6be81a1b77300a948bff591a56ec0022025d43d2db0021ec9b91a78edbd1a750f544cfb2120ed655e0cffeec009c00"       \
    "a3cc01d7a40610800882bb9313d650049bc007afff68ca00979b89dd5dfdd49ff3632479d25329089ce235dba20bfd7d"       \
    "1a10589f01164c77ec63baa9d7a5d97fb444e6f5c9d5a8e8fccda87422f3379b88418d079ad1af40023ea9a8514ba4f3"       \
    "5b28d20de735"
#define RECEIVED_BCNAV1_SUBFRAME3                                                                            \
    "04000bc1b1cd5e44a434a08010407ffbf00000046d271d680f70200000007452d12f12a9f2e184e81081e2b99381ebf6"       \
    "a48acad78cd4f24412e70dda071e43c776a9"
#define RECEIVED_BCNAV2                                                                                      \
    "5ca92f4075a0006ddcc02a522ffd64695bb0008809750f4b6c0087b26e469e3b6fd2c19f13fad5d6c360e72ed54c2607"       \
    "b594a4cf0edb258bbd81afdf27a700e0bb872acaa9b0a73b"
#define RECEIVED_BCNAV3                                                                                      \
    "79b9bf475bb772627aca00937800f6435791290d282004101ffefc0000011b49c75a03dc08d2f01b2dfe098366e90df2"       \
    "0005bc17f8265e2d8e02cd89e047df0cedc6740bd2cfa83af11a1f69b4788a31a3a8c49fbaa27bb5b9798e1f40c9cf58"       \
    "717da2d4416b00875ad79686186daf781d981e0aaa14e7588c1"

// Messages 11, 30 and 31 of C30 in 2018, when BeiDou-3 was on trial, as published with the tests of a branch of GNSS-SDR
// (beidou_cnav2_navigation_message_test.cc).
#define RECEIVED_BCNAV2_11                                                                                   \
    "78b84bc2ffde6342afc4e4bfe00ecf15da6c00a0004ffcea6403cc0c03135fd7af0a8599bbd97cd8b23b3ffc3da94c0b"       \
    "108fce189501555df156375e714229475414dce8bf8ae978"
#define RECEIVED_BCNAV2_30                                                                                   \
    "79e84bceffea63957cc7f4ac6000a6fae7eb8aa264a283000080a0803000000000e47c42a07b18baf04f3a5b30b0fd22"       \
    "aaa74ee8fa38f93ef55e2a7541e8b57aeaa86c5ceded6626"
#define RECEIVED_BCNAV2_31                                                                                   \
    "79f84bbeffea63957cc7f4ac6000a68a14cc5476207001efb3714009beb96500002943ff7a342bd99d2cf2ea5b0b9b97"       \
    "3c16a6c6831a3d7c98ad98068769793df387fb0675d0faf3"

// The bits of such a codeword.
static inline void received_bits(const char *hex, orr_page *p)
{
    orr_page_begin(p, NULL);
    for (const char *c = hex; *c != '\0'; c++)
        orr_page_put(p, 4, (uint64_t)(*c <= '9' ? *c - '0' : *c - 'a' + 10));
}

#endif
