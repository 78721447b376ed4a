// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/readings.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "inertial/sense/sensors.h"

orr_status orr_inputs_scenario(orr_inputs *inputs, const char *path, const orr_leap_table *leap,
                               orr_scenario *out, orr_diag *diag)
{
    orr_bytes text;
    *out = (orr_scenario){0};
    orr_status s = orr_inputs_read_raw(inputs, path, 0, &text, diag);
    if (s != ORR_OK) return s;
    const char *slash = strrchr(path, '/');
    char *folder = strndup(path, slash == NULL ? 0 : slash == path ? 1 : (size_t)(slash - path));
    s = folder != NULL ? orr_scenario_parse(path, text.text, text.n, folder, leap, out, diag)
                       : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    free(folder);
    orr_bytes_free(&text);
    return s;
}

typedef struct noting {
    orr_inputs *inputs;
    orr_status status;
    orr_diag *diag;
} noting;

static bool note_file(void *user, const char *path)
{
    noting *n = user;
    struct stat is;
    if (stat(path, &is) == 0 && S_ISREG(is.st_mode)) n->status = orr_inputs_note(n->inputs, path, n->diag);
    return n->status == ORR_OK;
}

orr_status orr_inputs_scenario_files(orr_inputs *inputs, const orr_scenario *scenario, orr_diag *diag)
{
    noting n = {.inputs = inputs, .diag = diag};
    (void)orr_schema_files(orr_scenario_schema(), scenario, note_file, &n);
    return n.status;
}

orr_readings_plan orr_readings_plan_of(const orr_moving *moving)
{
    return (orr_readings_plan){.moving = moving, .rate_hz = moving->rate_hz, .mode = moving->mode};
}

// As many as the wished rate says, at most all of them.
static size_t truth_every(const orr_imu *imu, double wish_hz)
{
    if (wish_hz <= 0) wish_hz = imu->mode.approach == 1 ? imu->rate_hz : fmin(imu->rate_hz, 20.0);
    const double k = floor(imu->rate_hz / wish_hz + 1e-9);
    return k < 1.0 ? 1 : k < (double)imu->n ? (size_t)k : imu->n;
}

orr_status orr_readings_make(const orr_readings_plan *plan, orr_readings *out, orr_diag *diag)
{
    *out = (orr_readings){0};
    const orr_moving *v = plan->moving;
    const orr_trajectory *tr = orr_moving_unit(v, plan->unit);
    const orr_imu_request q = {.begin_s = tr->begin_s,
                               .duration_s = tr->end_s - tr->begin_s,
                               .rate_hz = plan->rate_hz,
                               .mode = plan->mode,
                               .instantaneous = plan->instantaneous,
                               .gravity = v->gravity};
    orr_status s = orr_imu_generate(tr, &q, &out->imu, diag);
    if (s != ORR_OK) {
        out->imu = (orr_imu){0}; // nothing is kept of a failure
        return s;
    }
    if (plan->errors != NULL) {
        s = orr_imu_add_errors(plan->errors, &out->imu, &out->cut, diag);
        if (s != ORR_OK) return s;
    }
    const size_t every = truth_every(&out->imu, plan->truth_rate_hz);
    const size_t tenth_s = (size_t)nearbyint(fmax(1.0, q.rate_hz / 10.0));
    out->truth_every = every;
    return orr_gravimetry_truth(tr, v->gravity, &out->imu, (tenth_s + every - 1) / every * every, &out->truth,
                                diag);
}

void orr_readings_free(orr_readings *r)
{
    orr_gravimetry_free(&r->truth);
    orr_imu_free(&r->imu);
    *r = (orr_readings){0};
}

orr_status orr_readings_save(const orr_readings *r, const orr_readings_plan *plan,
                             const orr_scenario *scenario, const orr_inputs *inputs, const char *path,
                             const char *history, orr_diag *diag)
{
    const orr_moving *v = plan->moving;
    orr_inputs all = {0};
    orr_status s = inputs != NULL ? orr_inputs_join(&all, inputs, diag) : ORR_OK;
    if (s == ORR_OK) s = orr_inputs_join(&all, &v->inputs, diag);
    orr_nc_input *input = orr_inputs_provenance(&all);
    if (s == ORR_OK && input == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for the names of inputs");
    const orr_scenario_gravity *gravity = &scenario->motion.gravity;
    const orr_imu_labels labels = {.title = scenario->title,
                                   .history = history,
                                   .gravity_model_name = v->model != NULL ? gravity->model : NULL,
                                   .gravity_model_dir = v->model != NULL ? gravity->folder : NULL,
                                   .input = input,
                                   .n_inputs = all.n,
                                   .truth_every = r->truth_every,
                                   .axes = plan->axes,
                                   .errors = plan->errors != NULL ? plan->errors_title : NULL};
    if (s == ORR_OK) s = orr_imu_write(path, &r->imu, &r->truth, v->gravity, &labels, diag);
    free(input);
    orr_inputs_free(&all);
    return s;
}
