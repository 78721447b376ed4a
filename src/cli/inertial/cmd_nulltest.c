// SPDX-License-Identifier: GPL-3.0-or-later
// orrery nulltest: navigate on ideal readings and see whether the trajectory comes back.
#include <string.h>

#include "core/outfile.h"
#include "inertial/nav/null_test.h"
#include "inertial/readings/imu_file.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/json.h"
#include "src/cli/frame/options.h"

typedef struct series {
    FILE *stream;
    int64_t every, k;
} series;

static orr_status put_point(void *user, const orr_null_point *p)
{
    series *s = user;
    if (s->stream == NULL || s->k++ % s->every != 0) return ORR_OK;
    fprintf(s->stream, "%.6f,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", p->t_s, p->dr_m.x, p->dr_m.y, p->dr_m.z,
            p->horizontal_m, p->vertical_m, orr_vec3_norm(p->dv_mps), p->attitude_rad);
    return ORR_OK;
}

static const char *usual_navigator(const orr_imu_file *f)
{
    return f->imu.mode.approach == 1 ? "one-step" : "reference";
}

// "reference", "one-step", "2-sample", "4-sample", "5-sample"; the frame and projection are those of the
// readings unless told.
static orr_navigator choose(const orr_cli *c, const orr_imu_file *f)
{
    const orr_imu_mode *m = &f->imu.mode;
    orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE,
                         .samples = ORR_NAVIGATOR_MAX_SAMPLES,
                         .frame = m->approach == 1 ? m->frame : ORR_FRAME_GEOGRAPHIC,
                         .project_mid = m->approach == 1 ? m->project_mid : true,
                         .hold_vertical = *orr_cli_text(c, "vertical", "free") == 'h',
                         .gravity = f->gravity};
    const char *name = orr_cli_text(c, "navigator", usual_navigator(f));
    if (strcmp(name, "one-step") == 0) {
        nav.kind = ORR_NAVIGATOR_ONE_STEP;
    } else if (strcmp(name, "reference") != 0) {
        nav.kind = ORR_NAVIGATOR_MULTI_SAMPLE;
        nav.samples = name[0] - '0';
    }
    nav.samples = (int)orr_cli_int(c, "samples", nav.samples);
    const char *frame = orr_cli_text(c, "frame", orr_nav_frame_name(nav.frame));
    nav.frame = *frame == 'i' ? ORR_FRAME_INERTIAL : *frame == 'g' ? ORR_FRAME_GEOGRAPHIC : ORR_FRAME_BODY;
    nav.project_mid = *orr_cli_text(c, "project", nav.project_mid ? "mid" : "start") == 'm';
    return nav;
}

static const char *navigator_text(const orr_navigator *nav, char *buf, size_t n)
{
    if (nav->kind == ORR_NAVIGATOR_ONE_STEP)
        snprintf(buf, n, "one-step, %s frame, projection at %s, vertical channel %s",
                 orr_nav_frame_name(nav->frame), nav->project_mid ? "mid-step" : "t_j",
                 nav->hold_vertical ? "held" : "free");
    else
        snprintf(buf, n, "%s, %d samples%s",
                 nav->kind == ORR_NAVIGATOR_REFERENCE ? "reference" : "multi-sample", nav->samples,
                 nav->hold_vertical ? ", vertical channel held" : "");
    return buf;
}

static int print_json(const orr_cli *c, const orr_imu_file *f, const orr_navigator *nav,
                      const orr_null_report *r)
{
    char mode[160], text[160];
    json_t *j =
        json_pack("{s:s, s:s, s:o, s:{s:o, s:o, s:o, s:o, s:o}, s:{s:o}, s:{s:o}, s:o}", "readings",
                  orr_imu_mode_text(&f->imu.mode, mode, sizeof mode), "navigator",
                  navigator_text(nav, text, sizeof text), "duration_s", orr_json_number(r->duration_s),
                  "position", "max_3d_m", orr_json_number(r->max_3d_m), "max_horizontal_m",
                  orr_json_number(r->max_horizontal_m), "max_vertical_m", orr_json_number(r->max_vertical_m),
                  "max_xi1_m", orr_json_number(r->max_xi1_m), "final_3d_m", orr_json_number(r->final_3d_m),
                  "velocity", "max_mps", orr_json_number(r->max_velocity_mps), "attitude", "max_rad",
                  orr_json_number(r->max_attitude_rad), "compared", orr_json_count(r->compared));
    if (r->replayed) json_object_set_new(j, "bit_identical", json_boolean(r->bit_identical));
    return orr_json_print(c, j, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
}

static void print_table(const orr_imu_file *f, const orr_navigator *nav, const orr_null_report *r)
{
    char mode[160], text[160];
    printf("readings   %zu at %g Hz, %s\n", f->imu.n, f->imu.rate_hz,
           orr_imu_mode_text(&f->imu.mode, mode, sizeof mode));
    printf("navigator  %s\n", navigator_text(nav, text, sizeof text));
    printf("compared   %zu instants of %.3f s\n", r->compared, r->duration_s);
    printf("position   %.3g m at most (horizontal %.3g m, vertical %.3g m, along xi1 %.3g m), %.3g m at the "
           "end\n",
           r->max_3d_m, r->max_horizontal_m, r->max_vertical_m, r->max_xi1_m, r->final_3d_m);
    printf("velocity   %.3g m/s at most\n", r->max_velocity_mps);
    printf("attitude   %.3g rad at most\n", r->max_attitude_rad);
    if (r->replayed)
        printf("replay     %s\n",
               r->bit_identical ? "bit-identical with the generator" : "NOT bit-identical");
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    orr_imu_file f;
    const char *path = orr_cli_text(c, "csv", NULL);
    const bool csv_only = path != NULL && strcmp(path, "-") == 0, json = orr_cli_says(c, "format", "json");
    if (csv_only && json)
        return orr_cli_usage(c, "only one of --csv - and --format json can go to standard output");
    orr_status s = orr_imu_read(c->operand[0], orr_cli_text(c, "gravity-folder", NULL), &f, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    const int refused = orr_cli_settle(c, "navigator", usual_navigator(&f));
    if (refused != ORR_EXIT_OK) {
        orr_imu_file_free(&f);
        return refused;
    }
    if (orr_cli_says(c, "readings", "measured")) {
        if (f.imu.measured_dtheta_rad == NULL) {
            orr_imu_file_free(&f);
            return orr_cli_failf(c, "%s has no readings with errors ('orrery imu --errors' makes them)",
                                 c->operand[0]);
        }
        memcpy(f.imu.dtheta_rad, f.imu.measured_dtheta_rad, f.imu.n * sizeof *f.imu.dtheta_rad);
        memcpy(f.imu.dv_mps, f.imu.measured_dv_mps, f.imu.n * sizeof *f.imu.dv_mps);
    }
    orr_navigator nav = choose(c, &f);
    orr_null_report r;
    orr_outfile out = {0};
    series csv = {.every = orr_cli_int(c, "every", 1)};
    if (path != NULL) {
        s = orr_outfile_open(path, &out, &diag);
        csv.stream = out.stream;
        if (s == ORR_OK)
            fprintf(csv.stream, "t_s,dxi1_m,dxi2_m,dxi3_m,horizontal_m,vertical_m,dv_mps,attitude_rad\n");
    }
    if (s == ORR_OK) s = orr_null_test(&f.imu, &nav, put_point, &csv, &r, &diag);
    if (path != NULL && csv.stream != NULL) s = orr_outfile_end(&out, s, &diag);
    int status = ORR_EXIT_OK;
    if (s == ORR_OK && json)
        status = print_json(c, &f, &nav, &r);
    else if (s == ORR_OK && !csv_only)
        print_table(&f, &nav, &r);
    orr_imu_file_free(&f);
    return s == ORR_OK ? status : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    {.name = "navigator",
     .kind = ORR_OPT_CHOICE,
     .value = "reference|one-step|2-sample|4-sample|5-sample",
     .help = "Default: one-step for readings of approach 1, reference for physical ones."},
    {.name = "frame",
     .applies = "navigator=one-step",
     .kind = ORR_OPT_CHOICE,
     .value = "inertial|geographic|body",
     .help = "Frame. Default: that of the readings, or geographic."},
    {.name = "project",
     .applies = "navigator=one-step",
     .kind = ORR_OPT_CHOICE,
     .value = "mid|start",
     .help = "Matrices of mid-step or of t_j. Default: as the readings, or mid."},
    {.name = "vertical",
     .kind = ORR_OPT_CHOICE,
     .value = "free|held",
     .help = "Vertical channel: free, or height and vertical velocity held on the truth. Free, its error "
             "grows e-fold "
             "in 570 s. Default free."},
    {.name = "readings",
     .kind = ORR_OPT_CHOICE,
     .value = "ideal|measured",
     .help =
         "What the navigator is given: the ideal readings, or those with errors of sensors. Default ideal."},
    {.name = "samples",
     .applies = "navigator=reference",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 5,
     .help = "Samples a group. Default 5."},
    {.writes = true,
     .name = "csv",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "The differences over time; - for standard output, instead of the table."},
    {.name = "every",
     .applies = "csv",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 1e9,
     .help = "Only every N-th of them. Default 1."},
    {.name = "gravity-folder",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .help = "Where a gravity model's files are now."},
    ORR_OPTION_REPORT,
};

const orr_command orr_cmd_nulltest = {
    .name = "nulltest",
    .group = "Inertial",
    .summary = "navigate on ideal readings and compare with the truth",
    .operands = "IMU",
    .min_operands = 1,
    .max_operands = 1,
    .about = "Navigates from the start state and the readings of a file alone, in the gravity they were made "
             "in, and reports how far "
             "the solution strays from the true motion. docs/inertial.md says which navigator suits which "
             "readings.",
    .example =
        "orrery nulltest imu.nc\n"
        "orrery nulltest imu.nc --navigator one-step --frame body --project start --csv fig1.csv --every 100",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
