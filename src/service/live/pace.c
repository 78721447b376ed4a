// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/live/pace.h"

#include <math.h>
#include <stdio.h>

#include "orbit/navdata/glonass_time.h"

static const int64_t UNIX_TO_GPS_S = 315964800;
static const int64_t JUMP_NS =
    ORR_NS_PER_S / 10;                    // of the host's clocks against each other: a suspend, or somebody
static const double TIME_CONSTANT_S = 10; // of the loop when it has settled
static const double STEP_NS =
    50e6; // of a generator's time: it was restarted, not slow; told twice it is believed
static const int64_t STALE_NS = 10 * ORR_NS_PER_S, SILENCE_NS = 2 * ORR_NS_PER_S;

void orr_pace_init(orr_pace *p, orr_time begin, const orr_leap_table *leap)
{
    *p = (orr_pace){.clock = {.state = ORR_CLOCK_STOPPED, .t = begin},
                    .begin = begin,
                    .pps0 = ORR_TIME_NONE,
                    .start_t = ORR_TIME_NONE,
                    .leap = leap};
}

orr_time orr_pace_wall(const orr_pace *p, const orr_host *h)
{
    const orr_time label = orr_time_add(h->real_ns, -UNIX_TO_GPS_S * ORR_NS_PER_S);
    // The leap seconds in force at the label are those of the instant, but within seconds of a change.
    const int64_t leap_s = orr_leap_tai_minus_utc(label, p->leap) - ORR_TAI_MINUS_GPS_S;
    return orr_time_add(label, leap_s * ORR_NS_PER_S);
}

// --- What paces the clock ---

// What the reference shows now.
static int64_t reference_ns(const orr_pace *p, const orr_host *h)
{
    if (p->reference == ORR_MSG_CLOCK_REFERENCE_WALL) return orr_pace_wall(p, h);
    const int64_t d = h->mono_ns - p->radio.host_ns;
    return p->radio.elapsed_ns + d + llround((double)d * p->radio.rate + p->radio.fraction_ns);
}

// The clock anew, from what the reference shows and when it is to start.
static void follow(orr_pace *p, const orr_host *h)
{
    if (p->clock.state != ORR_CLOCK_RUNNING || p->start_t == ORR_TIME_NONE) return;
    p->clock.host_ns = h->mono_ns;
    p->clock.t = orr_time_add(p->start_t, reference_ns(p, h) - p->start_ns);
    p->clock.drift = p->reference == ORR_MSG_CLOCK_REFERENCE_RADIO ? p->radio.rate : 0;
}

void orr_pace_host(orr_pace *p, const orr_host *h)
{
    const orr_host last = p->host;
    p->host = *h;
    if (!p->has_host) {
        p->has_host = true;
        return;
    }
    const int64_t slept_ns = (h->boot_ns - last.boot_ns) - (h->mono_ns - last.mono_ns);
    const int64_t set_ns = (h->real_ns - last.real_ns) - (h->boot_ns - last.boot_ns);
    if (slept_ns > JUMP_NS) { // wall and generator went on meanwhile
        p->suspends++;
        p->radio.host_ns -= slept_ns;
        if (p->clock.state == ORR_CLOCK_RUNNING) p->clock.host_ns -= slept_ns;
    }
    if (set_ns > JUMP_NS || set_ns < -JUMP_NS) {
        p->sets++;
        const bool wall = p->reference == ORR_MSG_CLOCK_REFERENCE_WALL;
        // A start that was asked for at an instant of the wall is still to be at that instant; a scenario under way goes on.
        if (wall && p->clock.state == ORR_CLOCK_RUNNING && orr_clock_at(&p->clock, h->mono_ns) < p->start_t)
            follow(p, h);
        else if (wall)
            p->start_ns += set_ns;
        if (wall && p->pps0 != ORR_TIME_NONE) p->pps0_ns += set_ns;
    }
}

// --- CONTROL ---

static uint16_t wrong(orr_server_refusal *why, const char *sentence)
{
    snprintf(why->sentence, sizeof why->sentence, "CONTROL: %s", sentence);
    return ORR_MSG_ERROR_CODE_BAD_REQUEST;
}

static uint16_t wait_pps(orr_pace *p, const orr_host *h, const orr_msg_control *m, orr_server_refusal *why)
{
    if (p->clock.state != ORR_CLOCK_ARMED) return wrong(why, "WAIT_PPS wants a scenario that is armed");
    const int64_t now = reference_ns(p, h);
    p->pps0_ns = now - orr_floor_mod(now, ORR_NS_PER_S) + ORR_NS_PER_S;
    p->pps0 = m->t != ORR_TIME_NONE ? m->t : p->clock.t;
    p->clock.t = p->pps0;
    p->waits_pps = true;
    return 0;
}

static uint16_t start(orr_pace *p, const orr_host *h, const orr_msg_control *m, orr_server_refusal *why)
{
    const int64_t now = reference_ns(p, h);
    int64_t at = now;
    orr_time t = m->t != ORR_TIME_NONE ? m->t : p->clock.t;
    if (p->clock.state == ORR_CLOCK_RUNNING) return wrong(why, "START: it runs already");
    if (p->waits_pps) {
        at = orr_time_add(p->pps0_ns, m->delay);
        t = orr_time_add(p->pps0, m->delay);
    } else if (m->at != ORR_TIME_NONE) {
        if (p->reference != ORR_MSG_CLOCK_REFERENCE_WALL)
            return wrong(why,
                         "START: `at` is an instant of the wall's clock; with a generator WAIT_PPS fixes it");
        at = orr_time_add(m->at, m->delay);
    } else {
        at = orr_time_add(now, m->delay);
    }
    if (at < now) return wrong(why, "START: that moment has passed");
    p->waits_pps = false;
    p->start_ns = at;
    p->start_t = t;
    p->clock.state = ORR_CLOCK_RUNNING;
    follow(p, h);
    return 0;
}

uint16_t orr_pace_control(orr_pace *p, const orr_host *h, const orr_msg_control *m, orr_server_refusal *why)
{
    const bool takes_reference =
        m->action == ORR_MSG_CONTROL_ACTION_ARM || m->action == ORR_MSG_CONTROL_ACTION_START;
    if (m->reference > ORR_MSG_CLOCK_REFERENCE_RADIO) return wrong(why, "the reference is WALL or RADIO");
    if (m->delay < 0 || m->delay > 3600 * ORR_NS_PER_S) return wrong(why, "delay is 0 to an hour");
    if (takes_reference && p->clock.state != ORR_CLOCK_RUNNING && !p->waits_pps) {
        if (m->reference == ORR_MSG_CLOCK_REFERENCE_RADIO && p->radio.samples == 0)
            return wrong(why, "the generator's clock is not known: RADIO_TIME comes first");
        p->reference = m->reference;
    }
    switch (m->action) {
    case ORR_MSG_CONTROL_ACTION_LOAD:
    case ORR_MSG_CONTROL_ACTION_STOP:
        if (m->action == ORR_MSG_CONTROL_ACTION_LOAD && m->t != ORR_TIME_NONE) p->begin = m->t;
        p->clock = (orr_clock){.state = ORR_CLOCK_STOPPED, .t = p->begin};
        p->pps0 = p->start_t = ORR_TIME_NONE;
        p->waits_pps = false;
        return 0;
    case ORR_MSG_CONTROL_ACTION_ARM:
        if (p->clock.state == ORR_CLOCK_RUNNING) return wrong(why, "ARM: it runs; PAUSE or STOP it first");
        if (m->t != ORR_TIME_NONE) p->clock.t = m->t;
        p->clock.state = ORR_CLOCK_ARMED;
        p->waits_pps = false;
        return 0;
    case ORR_MSG_CONTROL_ACTION_WAIT_PPS:
        return wait_pps(p, h, m, why);
    case ORR_MSG_CONTROL_ACTION_START:
        return start(p, h, m, why);
    case ORR_MSG_CONTROL_ACTION_PAUSE:
        if (p->clock.state != ORR_CLOCK_RUNNING) return wrong(why, "PAUSE: it does not run");
        orr_clock_pause(&p->clock, h->mono_ns);
        p->start_t = ORR_TIME_NONE;
        return 0;
    default:
        return wrong(why, "there is no such action");
    }
}

// --- RADIO_TIME ---

// The host's monotonic clock when the generator showed its elapsed time; false where the stamp is of no clock of this host.
static bool stamp_of(const orr_host *h, const orr_msg_radio_time *m, int64_t *mono_ns)
{
    int64_t now;
    switch (m->clock) {
    case ORR_MSG_STAMP_CLOCK_ARRIVAL:
        *mono_ns = h->mono_ns;
        return true;
    case ORR_MSG_STAMP_CLOCK_MONOTONIC:
        now = h->mono_ns;
        break;
    case ORR_MSG_STAMP_CLOCK_TAI:
        now = h->tai_ns;
        break;
    case ORR_MSG_STAMP_CLOCK_REALTIME:
        now = h->real_ns;
        break;
    default:
        return false;
    }
    const int64_t age = orr_time_sub_ns(now, m->stamp);
    if (age > STALE_NS || age < -ORR_NS_PER_S) return false;
    *mono_ns = h->mono_ns - age;
    return true;
}

static void lock_anew(orr_radio *r, int64_t host_ns, int64_t elapsed_ns)
{
    *r = (orr_radio){.samples = 1, .host_ns = host_ns, .elapsed_ns = elapsed_ns};
}

// One sample for the loop: proportional and integral gain are those of a straight line through all samples at first, and do not
// fall below those of the time constant.
static void take_sample(orr_radio *r, int64_t host_ns, int64_t elapsed_ns)
{
    const double n = (double)++r->samples, dt_ns = (double)(host_ns - r->host_ns);
    const double settled = fmin(dt_ns * 1e-9 / TIME_CONSTANT_S, 1);
    const double kp = fmin(1, fmax(2 * (2 * n - 1) / (n * (n + 1)), 2 * settled));
    const double ki = fmin(1, fmax(6 / (n * (n + 1)), settled * settled));
    const int64_t step_ns = host_ns - r->host_ns;
    const double expected = dt_ns * r->rate + r->fraction_ns;
    r->error_ns = (double)(elapsed_ns - r->elapsed_ns - step_ns) - expected;
    const double moved = expected + kp * r->error_ns, whole = floor(moved);
    r->elapsed_ns += step_ns + (int64_t)whole;
    r->fraction_ns = moved - whole;
    if (dt_ns > 0) r->rate += ki * r->error_ns / dt_ns;
    r->square_ns2 += fmax(1 / n, 0.01) * (r->error_ns * r->error_ns - r->square_ns2);
    r->host_ns = host_ns;
}

uint16_t orr_pace_radio(orr_pace *p, const orr_host *h, const orr_msg_radio_time *m, orr_server_refusal *why)
{
    int64_t host_ns;
    orr_radio *r = &p->radio;
    const char *bad = NULL;
    if (m->elapsed < 0 || m->elapsed > ORR_TIME_FAR)
        bad = "RADIO_TIME: the elapsed time is 0 or more";
    else if (!stamp_of(h, m, &host_ns))
        bad = "RADIO_TIME: the stamp is no reading of this host's clock, or 10 s old";
    else if (r->samples > 0 && host_ns < r->host_ns)
        bad = "RADIO_TIME: stamps do not go back";
    if (bad != NULL) {
        snprintf(why->sentence, sizeof why->sentence, "%s", bad);
        return ORR_MSG_ERROR_CODE_BAD_REQUEST;
    }
    const int64_t expected = r->elapsed_ns + (host_ns - r->host_ns);
    if (r->samples == 0) {
        lock_anew(r, host_ns, m->elapsed);
    } else if (fabs((double)(m->elapsed - expected)) >
               STEP_NS + fabs((double)(host_ns - r->host_ns)) * 1e-3) {
        if (++r->far < 2) return 0; // one sample may be wrong
        lock_anew(r, host_ns, m->elapsed);
        p->steps++;
    } else {
        r->far = 0;
        take_sample(r, host_ns, m->elapsed);
    }
    if (p->reference == ORR_MSG_CLOCK_REFERENCE_RADIO) follow(p, h);
    return 0;
}

// --- Telling ---

static double wander_ns(const orr_radio *r) { return sqrt(r->square_ns2); }

void orr_pace_told(const orr_pace *p, const orr_host *h, orr_time made, orr_msg_pace *m)
{
    *m = (orr_msg_pace){.t = orr_clock_at(&p->clock, h->mono_ns),
                        .error_ns = p->radio.error_ns,
                        .rate = p->radio.rate,
                        .wander_ns = wander_ns(&p->radio),
                        .made = made};
    const int64_t air_ns = made != ORR_TIME_NONE ? orr_clock_when(&p->clock, made) : INT64_MAX;
    m->until_air = air_ns == INT64_MAX ? INT64_MIN : orr_time_sub_ns(air_ns, h->mono_ns);
}

orr_msg_leap_seconds orr_pace_leap(orr_time t, const orr_leap_table *table)
{
    if (table == NULL) table = orr_leap_builtin();
    const int now = orr_leap_tai_minus_utc(t, table) - ORR_TAI_MINUS_GPS_S;
    orr_msg_leap_seconds leap = {(int16_t)now, (int16_t)now, ORR_TIME_NONE};
    for (size_t i = 0; i < table->n; i++) {
        const orr_time begin = orr_time_from_mjd(table->entry[i].mjd, 0, ORR_SCALE_UTC, table);
        if (begin <= t) continue;
        leap.next = begin;
        leap.next_gps_utc_s = (int16_t)(table->entry[i].tai_minus_utc_s - ORR_TAI_MINUS_GPS_S);
        break;
    }
    return leap;
}

uint8_t orr_pace_state(const orr_pace *p, orr_time now)
{
    switch (p->clock.state) {
    case ORR_CLOCK_ARMED:
        return p->waits_pps ? ORR_MSG_CLOCK_STATE_WAITING : ORR_MSG_CLOCK_STATE_ARMED;
    case ORR_CLOCK_RUNNING:
        return now < p->start_t ? ORR_MSG_CLOCK_STATE_WAITING : ORR_MSG_CLOCK_STATE_RUNNING;
    case ORR_CLOCK_PAUSED:
        return ORR_MSG_CLOCK_STATE_PAUSED;
    case ORR_CLOCK_STOPPED:
        break;
    }
    return ORR_MSG_CLOCK_STATE_STOPPED;
}

uint8_t orr_pace_lock(const orr_pace *p, int64_t now_ns)
{
    if (p->radio.samples == 0 || now_ns - p->radio.host_ns > SILENCE_NS) return ORR_MSG_MODE_SILENT;
    return p->radio.far > 0 ? ORR_MSG_MODE_STEPPING : ORR_MSG_MODE_LOCKED;
}

void orr_pace_time(const orr_pace *p, const orr_host *h, orr_msg_time *m)
{
    const orr_time t = orr_clock_at(&p->clock, h->mono_ns);
    int n4 = 0, nt = 0;
    orr_civil moscow;
    *m = (orr_msg_time){.t = t,
                        .state = orr_pace_state(p, t),
                        .reference = p->reference,
                        .leap = orr_pace_leap(t, p->leap),
                        .pps0 = p->pps0,
                        .host = h->mono_ns,
                        .wall = orr_pace_wall(p, h),
                        .error_ns = p->radio.error_ns,
                        .rate = p->radio.rate,
                        .wander_ns = wander_ns(&p->radio),
                        .samples = p->radio.samples,
                        .steps = p->steps,
                        .suspends = p->suspends,
                        .sets = p->sets};
    orr_time_week(t, &m->week, &m->tow);
    orr_time_mjd(t, ORR_SCALE_UTC, p->leap, &m->utc_mjd, &(double){0});
    (void)orr_glonass_clock(t, p->leap, &moscow);
    m->utc_su = ((moscow.hour * INT64_C(60) + moscow.minute) * 60 + moscow.second) * ORR_NS_PER_S + moscow.ns;
    if (orr_glonass_calendar(t, p->leap, &n4, &nt, NULL) == ORR_OK) { // zero before 1996 and after 2119
        m->n4 = (uint16_t)n4;
        m->nt = (uint16_t)nt;
    }
}
