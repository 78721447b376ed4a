// SPDX-License-Identifier: GPL-3.0-or-later
// A clock between two nodes, of one number or of several side by side: clock_between.h includes it for both, and says what
// NUMBER and its company are. All are inlined, since numbers of 32 bytes have no common way into a function.

// The clock and its rate a part of the way (0 to 1) into an interval: C1 where both sides of a node have one rate there.
static inline __attribute__((always_inline)) void INTERVAL_AT(const INTERVAL *c, const NUMBER *part,
                                                              NUMBER *clock_s, NUMBER *rate_sps)
{
    const double room = ORR_CLOCK_ROUNDED;
    const NUMBER p = *part, from_last = 1 - p;
    const NUMBER begins = WHERE(p < room, c->bend_first_sps),
                 ends = WHERE(from_last < room, c->bend_last_sps);
    const NUMBER u = (WHERE(p < room, p) + WHERE(p >= room, from_last)) / room;
    *clock_s = c->clock_s + c->rate_sps * (p * c->length_s) +
               (begins - ends) * (room * c->length_s) * (u * (1 - u) * (1 - u));
    *rate_sps = c->rate_sps + (begins + ends) * ((1 - u) * (1 - 3 * u));
}

// Variance of what the clock is off the line between two nodes, a part of the way into an interval of length_s:
// a random walk held at both ends wanders by q h p (1 - p), one whose frequency wanders by q h^3 p^2 (1 - p)^2 / 3 (the
// square of the Green function of a string held at both ends); white noise of both nodes and of the instant itself, as
// far as they are not one (orr_clock_white_correlation). What all clocks of a system do together is not in it.
static inline __attribute__((always_inline)) void BETWEEN_S2(const NOISE *n, const NUMBER *length_s,
                                                             const NUMBER *part, NUMBER *variance_s2)
{
    const NUMBER p = *part, q = 1 - p, h = *length_s, hs = h * (1 / ORR_CLOCK_WHITE_S);
    // The correlations' roots, 1 / (1 + tau / 300 s), of the whole and of its two parts.
    const NUMBER ra = 1 / (1 + hs), rb = 1 / (1 + p * hs), rc = 1 / (1 + q * hs);
    const NUMBER apart = 1 + p * p + q * q + 2 * p * q * (ra * ra) - 2 * q * (rb * rb) - 2 * p * (rc * rc);
    const NUMBER hpq = h * p * q;
    *variance_s2 = n->white_s2 * WHERE(apart > 0, apart) + n->wfm_s2ps * hpq +
                   n->rwfm_s2ps3 * h * (hpq * hpq) * (1.0 / 3);
}

#undef NUMBER
#undef WHERE
#undef INTERVAL
#undef NOISE
#undef INTERVAL_AT
#undef BETWEEN_S2
