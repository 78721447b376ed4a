// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation: the product and a time in, states out. One routine does the arithmetic whoever asks, so that
// one satellite and the whole constellation give the same bits.
#include "orbit/ephemeris/ephemeris_at.h"

static orr_status eval_plain(const orr_ephemeris *e, orr_sat sat, orr_time t, orr_sat_state *out)
{
    return eval(e, sat, t, out);
}
static size_t eval_all_plain(const orr_ephemeris *e, orr_time t, orr_sat_state *out, size_t max)
{
    return t < e->from || t > e->to ? 0 : eval_all(e, t, out, max, NULL);
}

#if defined(__x86_64__)
// The same again for machines whose vectors hold four doubles. All that it calls is inlined: a function of its own is not compiled for
// them, and its plain instructions wait for the registers' upper halves (clock_before alone made a satellite cost 200 ns in place of 40).
// These are cleared behind it, for the same reason: the C library's wide functions (log, atan2) would wait some 100 ns each.
__attribute__((target("avx2"))) static orr_status eval_wide(const orr_ephemeris *e, orr_sat sat, orr_time t,
                                                            orr_sat_state *out)
{
    const orr_status s = eval(e, sat, t, out);
    __builtin_ia32_vzeroupper();
    return s;
}
__attribute__((target("avx2"))) static size_t eval_all_wide(const orr_ephemeris *e, orr_time t,
                                                            orr_sat_state *out, size_t max)
{
    const size_t n = t < e->from || t > e->to ? 0 : eval_all(e, t, out, max, NULL);
    __builtin_ia32_vzeroupper();
    return n;
}
bool eph_machine_is_wide(void) { return __builtin_cpu_supports("avx2") != 0; }
#else
#define eval_wide eval_plain
#define eval_all_wide eval_all_plain
bool eph_machine_is_wide(void) { return false; }
#endif

orr_status orr_ephemeris_eval(const orr_ephemeris *e, orr_sat sat, orr_time t, orr_sat_state *out)
{
    return e->wide ? eval_wide(e, sat, t, out) : eval_plain(e, sat, t, out);
}

size_t orr_ephemeris_eval_all(const orr_ephemeris *e, orr_time t, orr_sat_state *out, size_t max)
{
    return e->wide ? eval_all_wide(e, t, out, max) : eval_all_plain(e, t, out, max);
}
