// SPDX-License-Identifier: GPL-3.0-or-later
// orrery satellites: what a signal generator needs of each satellite beside its state.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "core/outfile.h"
#include "orbit/spacecraft/spacecraft.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/make/frames.h"
#include "src/make/inputs.h"
#include "src/make/products.h"

#define MAX_SIGNALS 16
#define MAX_CELLS (24 + MAX_SIGNALS)

typedef struct request {
    const orr_products *products;
    orr_spacecraft_sources src; // src.orbit: the product of the instant
    orr_time from, to;
    int64_t step_ns;
    const orr_sat_set *sats; // NULL: all
    size_t n_signals;
    char signal[MAX_SIGNALS][3];
    char format; // t, c or j
    size_t with_antenna, with_delay,
        with_health; // rows that have something from --antex, --bias or --nav, --nav
} request;

// One column of a row: a number (NAN: not known), or a word where there is one.
typedef struct cell {
    const char *name;
    double value;
    int decimals;
    const char *word;
} cell;

static double degrees(double rad) { return rad * ORR_DEG_PER_RAD; }

static const char *health_word(orr_health h)
{
    return h == ORR_HEALTH_OK ? "ok" : h == ORR_HEALTH_BAD ? "bad" : "";
}

static size_t fill(const request *q, const orr_spacecraft *x, orr_time t, char names[MAX_SIGNALS][16],
                   cell row[MAX_CELLS])
{
    const double nan = ORR_NAN;
    const orr_attitude *a = &x->attitude;
    const orr_sat_state *s = &x->state;
    const cell fixed[] = {
        {"attitude", nan, 0,
         !x->has_attitude  ? ""
         : x->orbit_normal ? "orbit-normal"
                           : "yaw-steering"},
        {"beta_deg", x->has_attitude ? degrees(a->beta_rad) : nan, 6, NULL},
        {"yaw_deg", x->has_attitude ? degrees(a->yaw_rad) : nan, 6, NULL},
        {"yaw_rate_dps", x->has_attitude ? degrees(a->yaw_rate_radps) : nan, 9, NULL},
        {"fast_turn", x->has_attitude ? (double)a->fast_turn : nan, 0, NULL},
        {"sunlight", x->has_attitude ? a->sunlight : nan, 6, NULL},
        {"eclipse", (s->flags & ORR_EPH_ECLIPSE) != 0, 0, NULL},
        {"apc_body_x_m", x->antenna_body_m[0], 4, NULL},
        {"apc_body_y_m", x->antenna_body_m[1], 4, NULL},
        {"apc_body_z_m", x->antenna_body_m[2], 4, NULL},
        {"apc_ecef_x_m", x->antenna_ecef_m.x, 4, NULL},
        {"apc_ecef_y_m", x->antenna_ecef_m.y, 4, NULL},
        {"apc_ecef_z_m", x->antenna_ecef_m.z, 4, NULL},
        {"clock_s", s->clock_s, 15, NULL},
        {"clock_rate_sps", s->clock_rate_sps, 18, NULL},
        {"relativity_s", x->relativity_s, 15, NULL},
        {"health", nan, 0, health_word(x->health)},
        {"manoeuvre", (s->flags & ORR_EPH_MANOEUVRE) != 0, 0, NULL},
        {"predicted", (s->flags & ORR_EPH_PREDICTED) != 0, 0, NULL},
        {"sigma_m", (double)s->sigma_m, 6, NULL},
    };
    size_t n = sizeof fixed / sizeof fixed[0];
    memcpy(row, fixed, sizeof fixed);
    for (size_t i = 0; i < q->n_signals; i++) {
        double delay = nan;
        snprintf(names[i], 16, "delay_%s_s", q->signal[i]);
        if (orr_spacecraft_delay(&q->src, s->sat, q->signal[i], t, &delay) != ORR_OK) delay = nan;
        row[n++] = (cell){names[i], delay, 15, NULL};
    }
    return n;
}

static void print_csv(FILE *f, const char *t, const char *sat, const cell *row, size_t n, size_t rows)
{
    if (rows == 0) {
        fputs("t_gps,sat", f);
        for (size_t i = 0; i < n; i++) fprintf(f, ",%s", row[i].name);
        fputc('\n', f);
    }
    fprintf(f, "%s,%s", t, sat);
    for (size_t i = 0; i < n; i++) {
        fputc(',', f);
        if (row[i].word != NULL)
            fputs(row[i].word, f);
        else if (isfinite(row[i].value))
            fprintf(f, "%.*f", row[i].decimals, row[i].value);
    }
    fputc('\n', f);
}

static void print_json(FILE *f, const char *t, const char *sat, const cell *row, size_t n, size_t rows)
{
    fprintf(f, "%s\n {\"t_gps\": \"%s\", \"sat\": \"%s\"", rows > 0 ? "," : "[", t, sat);
    for (size_t i = 0; i < n; i++) {
        fprintf(f, ", \"%s\": ", row[i].name);
        if (row[i].word != NULL && row[i].word[0] != '\0')
            fprintf(f, "\"%s\"", row[i].word);
        else if (isfinite(row[i].value))
            fprintf(f, "%.*f", row[i].decimals, row[i].value);
        else
            fputs("null", f);
    }
    fputc('}', f);
}

static void print_number(FILE *f, int width, int decimals, double x)
{
    if (isfinite(x))
        fprintf(f, " %*.*f", width, decimals, x);
    else
        fprintf(f, " %*s", width, "-");
}

// For people: microseconds, nanoseconds, millimetres, words.
static void print_line(FILE *f, const request *q, const orr_spacecraft *x, orr_time t)
{
    char sat[ORR_SAT_TEXT];
    const orr_sat_state *s = &x->state;
    fprintf(f, "  %s", orr_sat_text(s->sat, sat));
    print_number(f, 6, 2, x->has_attitude ? degrees(x->attitude.beta_rad) : ORR_NAN);
    print_number(f, 7, 2, x->has_attitude ? degrees(x->attitude.yaw_rad) : ORR_NAN);
    print_number(f, 5, 2, x->has_attitude ? x->attitude.sunlight : ORR_NAN);
    for (int i = 0; i < 3; i++) print_number(f, 7, 3, x->antenna_body_m[i]);
    print_number(f, 13, 6, s->clock_s * 1e6);
    print_number(f, 8, 3, x->relativity_s * 1e9);
    for (size_t i = 0; i < q->n_signals; i++) {
        double delay;
        const bool known = orr_spacecraft_delay(&q->src, s->sat, q->signal[i], t, &delay) == ORR_OK;
        print_number(f, 8, 3, known ? delay * 1e9 : ORR_NAN);
    }
    print_number(f, 7, 2, (double)s->sigma_m * 1e3);
    fprintf(f, "  %-6s%s%s%s%s%s\n",
            q->src.nav != NULL && x->health == ORR_HEALTH_UNKNOWN ? "-" : health_word(x->health),
            (s->flags & ORR_EPH_ECLIPSE) != 0 ? " eclipse" : "",
            x->has_attitude && x->attitude.fast_turn ? " fast-turn" : "",
            x->orbit_normal ? " orbit-normal" : "", (s->flags & ORR_EPH_MANOEUVRE) != 0 ? " manoeuvre" : "",
            (s->flags & ORR_EPH_PREDICTED) != 0 ? " predicted" : "");
}

static void print_head(FILE *f, const request *q, const char *t)
{
    fprintf(f, "%s GPS\n  sat   beta     yaw  sun   antenna x, y, z (body), m      clock us    rel ns", t);
    for (size_t i = 0; i < q->n_signals; i++) fprintf(f, "    %s ns", q->signal[i]);
    fputs("   s mm  health\n", f);
}

static orr_status print_all(request *q, FILE *f, size_t *rows)
{
    const orr_sat *list = q->products->sat;
    *rows = 0;
    for (orr_time t = q->from;; t += q->step_ns) {
        char when[ORR_TIME_TEXT], sat[ORR_SAT_TEXT];
        orr_time_text(t, when);
        q->src.orbit = orr_products_at(q->products, t);
        const orr_vec3 sun =
            orr_attitude_sun(t, q->src.orbit != NULL ? orr_ephemeris_eop(q->src.orbit) : NULL);
        if (q->format == 't') print_head(f, q, when);
        for (size_t i = 0; i < q->products->n_sats && q->src.orbit != NULL; i++) {
            orr_spacecraft x;
            char names[MAX_SIGNALS][16];
            cell row[MAX_CELLS];
            if (q->sats != NULL && !orr_sat_set_has(q->sats, list[i])) continue;
            if (orr_spacecraft_at(&q->src, list[i], t, sun, &x) != ORR_OK) continue;
            const size_t n = fill(q, &x, t, names, row);
            if (isfinite(x.antenna_body_m[0])) q->with_antenna++;
            q->with_health += x.health != ORR_HEALTH_UNKNOWN;
            for (size_t k = 0; k < q->n_signals; k++)
                if (isfinite(row[n - 1 - k].value)) q->with_delay++;
            if (q->format == 't')
                print_line(f, q, &x, t);
            else if (q->format == 'c')
                print_csv(f, when, orr_sat_text(list[i], sat), row, n, *rows);
            else
                print_json(f, when, orr_sat_text(list[i], sat), row, n, *rows);
            ++*rows;
        }
        if (q->to - t < q->step_ns) break;
    }
    if (q->format == 'j' && *rows > 0) fputs("\n]\n", f);
    return *rows > 0 ? ORR_OK : ORR_E_NODATA;
}

// A file that tells nothing of what was printed was the wrong one.
static void tell_useless(const orr_cli *c, const request *q)
{
    const char *const antex = orr_cli_text(c, "antex", NULL), *const bias = orr_cli_text(c, "bias", NULL),
                      *const nav = orr_cli_text(c, "nav", NULL);
    if (antex != NULL && q->with_antenna == 0)
        orr_cli_failf(c, "warning: %s: has no antenna of these satellites at that time", antex);
    if (bias != NULL && q->with_delay == 0)
        orr_cli_failf(c, "warning: %s: does not tell the delays of these signals at that time", bias);
    if (nav != NULL && q->with_health == 0)
        orr_cli_failf(c, "warning: %s: has no record of these satellites", nav);
}

// "1C,2W" into the request; false, with the sentence said, where it is something else.
static bool read_signals(const orr_cli *c, request *q)
{
    const char *p = orr_cli_text(c, "signal", "");
    while (*p != '\0') {
        const size_t n = strcspn(p, ",");
        if (n != 2 || p[0] < '1' || p[0] > '9' || p[1] < 'A' || p[1] > 'Z') {
            orr_cli_usage(c, "--signal is a list of bands with attributes as RINEX 3 has them, like 1C,2W");
            return false;
        }
        if (q->n_signals == MAX_SIGNALS) {
            orr_cli_usage(c, "--signal: %d signals at most", MAX_SIGNALS);
            return false;
        }
        memcpy(q->signal[q->n_signals++], p, 2);
        p += n + (p[n] == ',');
    }
    if (q->n_signals > 0 && !orr_cli_given(c, "bias") && !orr_cli_given(c, "nav")) {
        orr_cli_usage(c, "--signal needs --bias or --nav to tell the delays");
        return false;
    }
    if (q->n_signals == 0 && orr_cli_given(c, "bias")) {
        orr_cli_usage(c, "--bias tells the delays of signals; name them: --signal 1C,2W");
        return false;
    }
    return true;
}

static bool read_times(const orr_cli *c, request *q)
{
    const orr_time from = q->products->from, to = q->products->to;
    char a[ORR_TIME_TEXT], b[ORR_TIME_TEXT];
    q->from = orr_cli_time(c, "at", orr_cli_time(c, "from", from));
    q->to = orr_cli_time(c, "at", orr_cli_time(c, "to", to));
    q->step_ns = orr_cli_duration_ns(c, "step", 900 * ORR_NS_PER_S);
    if (q->from >= from && q->to <= to && q->from <= q->to) return true;
    orr_cli_failf(c, "%s cover%s %s to %s (GPS time), not all of what was asked",
                  q->products->n > 1 ? "the products" : c->operand[0], q->products->n > 1 ? "" : "s",
                  orr_time_text(from, a), orr_time_text(to, b));
    return false;
}

static orr_status write_out(const orr_cli *c, request *q, orr_diag *diag)
{
    orr_outfile out;
    size_t rows;
    orr_status s = orr_outfile_open(orr_cli_text(c, "output", "-"), &out, diag);
    if (s != ORR_OK) return s;
    s = print_all(q, out.stream, &rows);
    if (s == ORR_OK)
        tell_useless(c, q);
    else
        orr_diag_set(diag, s, "%s has no orbit of these satellites then", c->operand[0]);
    return orr_outfile_end(&out, s, diag);
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    request q = {.sats = orr_cli_sats(c, "sat"), .format = orr_cli_text(c, "format", "csv")[0]};
    orr_products products = {0};
    orr_antex antex = {0};
    orr_bias_set bias = {0};
    orr_nav nav = {0};
    if (orr_cli_backward(c)) return orr_cli_usage(c, "--to is before --from");
    if (!read_signals(c, &q)) return ORR_EXIT_USAGE;
    uint32_t messages = 0;
    if (orr_cli_given(c, "message") &&
        orr_nav_messages_parse(orr_cli_text(c, "message", ""), &messages, &diag) != ORR_OK)
        return orr_cli_usage(c, "--message: %s", diag.text);
    const char *const antex_path = orr_cli_text(c, "antex", NULL),
                      *const bias_path = orr_cli_text(c, "bias", NULL),
                      *const nav_path = orr_cli_text(c, "nav", NULL);
    orr_nav_limits limits = orr_nav_default_limits();
    limits.leap = c->leap;
    orr_status s = orr_products_open((const char *const *)c->operand, (size_t)c->n_operands, &products,
                                     &warnings, &diag);
    if (s == ORR_OK && antex_path != NULL) s = orr_antex_read(antex_path, NULL, &antex, &warnings, &diag);
    if (s == ORR_OK && antex_path != NULL)
        orr_frames_check_antex(&antex, antex_path, orr_ephemeris_frame(products.item[0]), &warnings);
    if (s == ORR_OK && bias_path != NULL) s = orr_bias_read(bias_path, NULL, &bias, &warnings, &diag);
    if (s == ORR_OK && nav_path != NULL) s = orr_nav_read(nav_path, &limits, &nav, &warnings, &diag);
    orr_cli_warnings(c, &warnings);
    int status = ORR_EXIT_FAILED;
    if (s != ORR_OK) {
        orr_cli_fail(c, &diag);
    } else {
        q.products = &products;
        q.src = (orr_spacecraft_sources){.antex = antex_path != NULL ? &antex : NULL,
                                         .bias = bias_path != NULL ? &bias : NULL,
                                         .nav = nav_path != NULL ? &nav : NULL,
                                         .messages = messages};
        if (read_times(c, &q))
            status = write_out(c, &q, &diag) == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
    }
    orr_products_free(&products);
    orr_antex_free(&antex);
    orr_bias_free(&bias);
    orr_nav_free(&nav);
    orr_warnings_free(&warnings);
    return status;
}

static const orr_option options[] = {
    ORR_OPTION_INSTANTS,
    ORR_OPTION_SATS,
    ORR_OPTION_ANTEX(
            .help =
                "ANTEX file: antennas' phase centres from the centres of mass, of the pair of carriers that "
                "the "
                "clocks belong to (GPS L1/L2, GLONASS G1/G2, Galileo E1/E5a, BeiDou B1I/B3I, QZSS L1/L2)."),
    ORR_OPTION_BIAS(.help = "Bias-SINEX or DCB file: group delays of the signals of --signal."),
    ORR_OPTION_NAV(.help = "RINEX navigation file: health; without --bias the group delays too."),
    ORR_OPTION_MESSAGE(.applies = "nav"),
    {.name = "signal",
     .kind = ORR_OPT_TEXT,
     .value = "LIST",
     .help = "Signals as RINEX 3 codes without the first letter, e.g. 1C,2W,5Q: a column each of the delay "
             "against the clock's pair, to be subtracted from the clock for a user of that signal alone."},
    ORR_OPTION_FORMAT("table|csv|json", "csv"),
    ORR_OPTION_OUTPUT,
};

const orr_command orr_cmd_satellites = {
    .name = "satellites",
    .group = "Orbits",
    .summary = "attitude, antenna, clock parts, group delays and health of satellites",
    .operands = "PRODUCT...",
    .min_operands = 1,
    .max_operands = -1,
    .about =
        "What a signal generator needs beside the states of `orrery states`. Attitude is nominal yaw "
        "steering: "
        "beta is the Sun's elevation above the orbital plane, yaw the angle from the along-track direction "
        "to "
        "the body's X axis, which looks to the Sun's side; Z looks to the Earth. Geostationary satellites of "
        "BeiDou and QZSS fly orbit-normal instead: X along the track. Satellites depart from the law in "
        "eclipses and where fast_turn is 1: there it asks for a turn faster than 0.1 deg/s, or did within "
        "half "
        "an hour. BeiDou-2 at beta below 4 deg and QZS-1 below 20 fly orbit-normal too. All this is flagged "
        "or "
        "said here, not modelled.\n\n"
        "The clock is the product's; periodic relativity, -2 r.v/c^2, stands apart and is to be added. What "
        "is "
        "not known is blank in CSV, null in JSON, - in the table.",
    .example =
        "orrery satellites day.nc --at 2024-02-04T12:00 --antex igs20.atx --nav brdc.rnx --format table\n"
        "orrery satellites day.nc --sat G --step 300 --bias osb.bia --signal 1C,2W -o gps.csv",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
