// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/calibration.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/linalg.h"
#include "inertial/study/calibration_private.h"

// --- Unknowns ---

static const struct {
    const char *name, *unit;
} sensor_name[30] = {
    {"accelerometer bias x", "m/s2"},
    {"accelerometer bias y", "m/s2"},
    {"accelerometer bias z", "m/s2"},
    {"accelerometer scale x", "1"},
    {"accelerometer scale y", "1"},
    {"accelerometer scale z", "1"},
    {"accelerometer y of x", "rad"},
    {"accelerometer z of x", "rad"},
    {"accelerometer z of y", "rad"},
    {"gyro bias x", "rad/s"},
    {"gyro bias y", "rad/s"},
    {"gyro bias z", "rad/s"},
    {"gyro scale x", "1"},
    {"gyro x of y", "rad"},
    {"gyro x of z", "rad"},
    {"gyro y of x", "rad"},
    {"gyro scale y", "1"},
    {"gyro y of z", "rad"},
    {"gyro z of x", "rad"},
    {"gyro z of y", "rad"},
    {"gyro scale z", "1"},
    {"arm of accelerometer x, 1", "m"},
    {"arm of accelerometer x, 2", "m"},
    {"arm of accelerometer x, 3", "m"},
    {"arm of accelerometer y, 1", "m"},
    {"arm of accelerometer y, 2", "m"},
    {"arm of accelerometer y, 3", "m"},
    {"arm of accelerometer z, 1", "m"},
    {"arm of accelerometer z, 2", "m"},
    {"arm of accelerometer z, 3", "m"},
};

static size_t arm_unknowns(const orr_calibration_plan *p) { return !p->arms ? 0 : p->offsets_known ? 9 : 6; }
size_t orr_calibration_parameters(const orr_calibration_plan *plan)
{
    return ORR_CALIBRATION_SENSORS + arm_unknowns(plan);
}
size_t orr_calibration_unknowns(const orr_calibration_plan *plan)
{
    return orr_calibration_parameters(plan) + orr_calibration_per_cycle(plan) * plan->n_cycles;
}

const char *orr_calibration_name(const orr_calibration_plan *plan, size_t k, const char **unit)
{
    if (k >= orr_calibration_parameters(plan)) return NULL;
    // Six arms are those of the second and third accelerometer.
    const size_t at = k >= ARMS && !plan->offsets_known ? k + 3 : k;
    if (unit != NULL) *unit = sensor_name[at].unit;
    return sensor_name[at].name;
}

double orr_calibration_size(size_t k)
{
    if (k >= ARMS) return 0.1; // arms and offsets in m, angles in rad
    if (k < ACCEL_SCALE) return 0.01;
    return k >= GYRO_BIAS && k < GYRO_MATRIX ? 1e-5 : 0.01;
}

// A cycle with the mounting that the unknowns say.
static orr_stand_cycle cycle_of(const orr_calibration_plan *p, size_t c, const double *value)
{
    orr_stand_cycle out = p->cycle[c];
    const double *v = value + orr_calibration_parameters(p) + c * orr_calibration_per_cycle(p);
    const int a = orr_calibration_nearest(&out), i = (a + 1) % 3, j = (a + 2) % 3;
    out.mounting_rad = (orr_vec3){0, 0, 0};
    *orr_component(&out.mounting_rad, i) = v[TILT_1];
    *orr_component(&out.mounting_rad, j) = v[TILT_2];
    out.start_rad = v[START];
    if (p->offsets_known) return out;
    *orr_component(&out.outer_m, a) = p->along_m[c];
    *orr_component(&out.outer_m, i) = v[OFFSET_1];
    *orr_component(&out.outer_m, j) = v[OFFSET_2];
    return out;
}

static orr_vec3 arm_of(const orr_calibration_plan *p, const orr_stand_cycle *c, const double *value, int axis)
{
    if (!p->arms || (axis == 0 && !p->offsets_known)) return c->outer_m;
    const double *v = value + ARMS + 3 * (axis - (p->offsets_known ? 0 : 1));
    return orr_vec3_add(c->outer_m, (orr_vec3){v[0], v[1], v[2]});
}

// --- The model of a block ---

typedef struct block {
    size_t cycle;
    double from_s, to_s;
} block;

// True increments of a block by the unknowns: [0..2] of the gyros, [3..5] of the accelerometers.
static void ideal(const orr_calibration_plan *p, const block *b, const double *value, double out[6],
                  orr_stand_increment *increment)
{
    const orr_stand_cycle c = cycle_of(p, b->cycle, value);
    orr_stand exact = *p->stand;
    exact.setup.literal_mounting = exact.setup.literal_forces = false;
    *increment = orr_stand_integrate(&exact, &c, b->from_s, b->to_s);
    out[0] = increment->dtheta_rad.x;
    out[1] = increment->dtheta_rad.y;
    out[2] = increment->dtheta_rad.z;
    for (int i = 0; i < 3; i++) out[3 + i] = orr_stand_force(increment, i, arm_of(p, &c, value, i));
}

// M of the accelerometers and of the gyros.
static void matrices(const double *value, double A[3][3], double G[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            A[i][k] = i == k ? 1 + value[ACCEL_SCALE + i] : 0;
            G[i][k] = (i == k ? 1 : 0) + value[GYRO_MATRIX + 3 * i + k];
        }
    for (int k = 0; k < 3; k++) A[cross_row[k]][cross_column[k]] = value[ACCEL_CROSS + k];
}

static void apply(double M[3][3], const double x[3], double out[3])
{
    for (int i = 0; i < 3; i++) out[i] = M[i][0] * x[0] + M[i][1] * x[1] + M[i][2] * x[2];
}

// Rows of one block: what is measured less what the unknowns say (`y`, NULL: none), and derivatives by the unknowns, both
// over their sigma.
static void block_rows(const orr_calibration_plan *p, const block *b, const double *value,
                       const double measured[6], double *J, double *y)
{
    const size_t n = orr_calibration_unknowns(p),
                 first = orr_calibration_parameters(p) + b->cycle * orr_calibration_per_cycle(p);
    const double T = b->to_s - b->from_s;
    const double w[6] = {1 / (p->gyro_white_radps_s * sqrt(T)), 1 / (p->gyro_white_radps_s * sqrt(T)),
                         1 / (p->gyro_white_radps_s * sqrt(T)), 1 / (p->accel_white_mps2_s * sqrt(T)),
                         1 / (p->accel_white_mps2_s * sqrt(T)), 1 / (p->accel_white_mps2_s * sqrt(T))};
    double A[3][3], G[3][3], x[6], told[6];
    orr_stand_increment inc, other;
    matrices(value, A, G);
    ideal(p, b, value, x, &inc);
    apply(G, x, told);
    apply(A, x + 3, told + 3);
    for (int i = 0; i < 3; i++) {
        double *g = J + (size_t)i * n, *a = J + (size_t)(3 + i) * n;
        g[GYRO_BIAS + i] = w[i] * T;
        a[ACCEL_BIAS + i] = w[3 + i] * T;
        for (int k = 0; k < 3; k++) g[GYRO_MATRIX + 3 * i + k] = w[i] * x[k];
        a[ACCEL_SCALE + i] = w[3 + i] * x[3 + i];
        for (int k = 0; k < 3; k++)
            if (cross_row[k] == i) a[ACCEL_CROSS + k] = w[3 + i] * x[3 + cross_column[k]];
        // Arms and offsets: dv_k changes by arm_ps[k][j] of its own.
        for (int k = 0; k < 3; k++) {
            if (p->arms && (k > 0 || p->offsets_known))
                for (int j = 0; j < 3; j++)
                    a[ARMS + 3 * (k - (p->offsets_known ? 0 : 1)) + j] =
                        w[3 + i] * A[i][k] * inc.arm_ps.m[k][j];
            if (p->offsets_known) continue;
            const int axis = orr_calibration_nearest(&p->cycle[b->cycle]), one = (axis + 1) % 3,
                      two = (axis + 2) % 3;
            a[first + OFFSET_1] += w[3 + i] * A[i][k] * inc.arm_ps.m[k][one];
            a[first + OFFSET_2] += w[3 + i] * A[i][k] * inc.arm_ps.m[k][two];
        }
    }
    if (y != NULL)
        for (int r = 0; r < 6; r++) {
            const double bias = r < 3 ? value[GYRO_BIAS + r] : value[ACCEL_BIAS + r - 3];
            y[r] = w[r] * (measured[r] - told[r] - bias * T);
        }
    // The three angles of the cycle, by differences: exact to 1e-10, which costs no more than a digit a step.
    double shifted[ORR_CALIBRATION_MOST];
    memcpy(shifted, value, n * sizeof *shifted);
    const double step = 1e-5;
    for (int k = 0; k < 3; k++) {
        double up[6], down[6], d[6], row[6];
        shifted[first + (size_t)k] = value[first + (size_t)k] + step;
        ideal(p, b, shifted, up, &other);
        shifted[first + (size_t)k] = value[first + (size_t)k] - step;
        ideal(p, b, shifted, down, &other);
        shifted[first + (size_t)k] = value[first + (size_t)k];
        for (int r = 0; r < 6; r++) d[r] = (up[r] - down[r]) / (2 * step);
        apply(G, d, row);
        apply(A, d + 3, row + 3);
        for (int r = 0; r < 6; r++) J[(size_t)r * n + first + (size_t)k] = w[r] * row[r];
    }
}

// --- Blocks and readings ---

static size_t blocks_of(const orr_calibration_plan *p, size_t cycle)
{
    return (size_t)fmax(1.0, floor(orr_stand_duration(&p->cycle[cycle].profile) / p->block_s + 1e-9));
}

void orr_calibration_data_free(orr_calibration_data *d)
{
    free(d->cycle);
    free(d->from_s);
    free(d->to_s);
    free(d->dtheta_rad);
    free(d->dv_mps);
    memset(d, 0, sizeof *d);
}

static orr_status check_plan(const orr_calibration_plan *p, orr_diag *diag)
{
    if (p->n_cycles == 0 || p->n_cycles > ORR_CALIBRATION_MOST_CYCLES)
        return orr_diag_set(diag, ORR_E_LIMIT, "a plan of %zu cycles; 1 to %d can be", p->n_cycles,
                            ORR_CALIBRATION_MOST_CYCLES);
    if (!(p->block_s > 0) || !(p->gyro_white_radps_s > 0) || !(p->accel_white_mps2_s > 0))
        return orr_diag_set(diag, ORR_E_ARG,
                            "the length of blocks and the noises that readings are weighted by are above 0");
    for (size_t c = 0; c < p->n_cycles; c++) {
        const orr_status s = orr_stand_cycle_check(&p->cycle[c], diag);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}

orr_status orr_calibration_sum(const orr_calibration_plan *plan, const orr_imu *imu, bool measured,
                               orr_calibration_data *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_status s = check_plan(plan, diag);
    if (s != ORR_OK) return s;
    size_t n = 0;
    for (size_t c = 0; c < plan->n_cycles; c++) n += blocks_of(plan, c);
    out->cycle = malloc(n * sizeof *out->cycle);
    out->from_s = malloc(n * sizeof *out->from_s);
    out->to_s = malloc(n * sizeof *out->to_s);
    out->dtheta_rad = calloc(n, sizeof *out->dtheta_rad);
    out->dv_mps = calloc(n, sizeof *out->dv_mps);
    if (out->cycle == NULL || out->from_s == NULL || out->to_s == NULL || out->dtheta_rad == NULL ||
        out->dv_mps == NULL) {
        orr_calibration_data_free(out);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu blocks", n);
    }
    for (size_t c = 0; c < plan->n_cycles; c++) {
        const orr_imu *m = &imu[c];
        const orr_vec3 *dtheta = measured ? m->measured_dtheta_rad : m->dtheta_rad,
                       *dv = measured ? m->measured_dv_mps : m->dv_mps;
        const size_t blocks = blocks_of(plan, c);
        if (dtheta == NULL || m->n < blocks) {
            orr_calibration_data_free(out);
            return orr_diag_set(diag, ORR_E_ARG, "cycle %zu has %zu readings for %zu blocks", c + 1,
                                dtheta == NULL ? (size_t)0 : m->n, blocks);
        }
        for (size_t b = 0; b < blocks; b++) {
            const size_t from = b * m->n / blocks, to = (b + 1) * m->n / blocks, at = out->n++;
            out->cycle[at] = c;
            out->from_s[at] = (double)from / m->rate_hz;
            out->to_s[at] = (double)to / m->rate_hz;
            for (size_t j = from; j < to; j++) {
                out->dtheta_rad[at] = orr_vec3_add(out->dtheta_rad[at], dtheta[j]);
                out->dv_mps[at] = orr_vec3_add(out->dv_mps[at], dv[j]);
            }
        }
    }
    return ORR_OK;
}

// --- Least squares ---

void orr_calibration_result_free(orr_calibration_result *r)
{
    free(r->covariance);
    free(r->factor);
    memset(r, 0, sizeof *r);
}

// The rows of all blocks, [6 blocks][n] and [6 blocks]; without data those that the plan would have.
static orr_status all_rows(const orr_calibration_plan *p, const orr_calibration_data *d, const double *value,
                           double **J, double **y, size_t *rows, orr_diag *diag)
{
    const size_t n = orr_calibration_unknowns(p);
    size_t blocks = d != NULL ? d->n : 0;
    for (size_t c = 0; d == NULL && c < p->n_cycles; c++) blocks += blocks_of(p, c);
    *rows = 6 * blocks;
    if (*rows < n)
        return orr_diag_set(diag, ORR_E_ARG,
                            "%zu unknowns from %zu blocks of readings; shorter blocks are needed", n, blocks);
    if (blocks > 1000000)
        return orr_diag_set(diag, ORR_E_LIMIT, "%zu blocks; longer ones are needed", blocks);
    *J = calloc(*rows * n, sizeof **J);
    *y = calloc(*rows, sizeof **y);
    if (*J == NULL || *y == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu blocks", blocks);
    size_t cycle = 0, within = 0;
    for (size_t k = 0; k < blocks; k++) {
        block b;
        double measured[6] = {0};
        if (d != NULL) {
            b = (block){d->cycle[k], d->from_s[k], d->to_s[k]};
            const double m[6] = {d->dtheta_rad[k].x, d->dtheta_rad[k].y, d->dtheta_rad[k].z,
                                 d->dv_mps[k].x,     d->dv_mps[k].y,     d->dv_mps[k].z};
            memcpy(measured, m, sizeof m);
        } else {
            while (within == blocks_of(p, cycle)) cycle++, within = 0;
            const double length = orr_stand_duration(&p->cycle[cycle].profile) / (double)blocks_of(p, cycle);
            b = (block){cycle, (double)within * length, (double)(within + 1) * length};
            within++;
        }
        block_rows(p, &b, value, measured, *J + 6 * k * n, d != NULL ? *y + 6 * k : NULL);
    }
    return ORR_OK;
}

// x of the linear problem, and what its columns say of observability; J and y are overwritten.
static orr_status linear(const orr_calibration_plan *p, double *J, double *y, size_t rows, double *x,
                         orr_calibration_result *out, orr_diag *diag)
{
    const size_t n = orr_calibration_unknowns(p);
    orr_calibration_result_free(out);
    out->n = n;
    out->sensors = orr_calibration_parameters(p);
    out->factor = calloc(n * n, sizeof *out->factor);
    out->covariance = calloc(n * n, sizeof *out->covariance);
    double *tau = malloc(n * sizeof *tau); // and then sizes
    orr_status s = out->factor != NULL && out->covariance != NULL && tau != NULL
                       ? ORR_OK
                       : orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu unknowns", n);
    if (s == ORR_OK && orr_least_squares(J, rows, n, y, tau, NULL) != ORR_OK)
        s = orr_diag_set(diag, ORR_E_NUMERIC, "the least squares of a plan have no numbers");
    if (s == ORR_OK) {
        for (size_t i = 0; i < n; i++)
            for (size_t k = i; k < n; k++) out->factor[i * n + k] = J[i * n + k];
        for (size_t k = 0; k < n; k++) tau[k] = orr_calibration_size(k);
        s = orr_calibration_decompose(out, tau, y, x, diag);
    }
    if (s == ORR_OK) {
        double sum = 0;
        for (size_t i = n; i < rows; i++) sum += y[i] * y[i];
        out->residual_rms = rows > n ? sqrt(sum / (double)(rows - n)) : 0;
    }
    free(tau);
    return s;
}

static orr_status one_step(const orr_calibration_plan *p, const orr_calibration_data *d, const double *value,
                           double *x, orr_calibration_result *out, orr_diag *diag)
{
    double *J = NULL, *y = NULL;
    size_t rows;
    orr_status s = all_rows(p, d, value, &J, &y, &rows, diag);
    if (s == ORR_OK) s = linear(p, J, y, rows, x, out, diag);
    free(J);
    free(y);
    return s;
}

orr_status orr_calibration_observe(const orr_calibration_plan *plan, const double *value,
                                   orr_calibration_result *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_status s = check_plan(plan, diag);
    if (s != ORR_OK) return s;
    double at[ORR_CALIBRATION_MOST] = {0}, x[ORR_CALIBRATION_MOST];
    if (value != NULL) memcpy(at, value, orr_calibration_unknowns(plan) * sizeof *at);
    s = one_step(plan, NULL, at, x, out, diag);
    memcpy(out->value, at, sizeof at);
    if (s != ORR_OK) orr_calibration_result_free(out);
    return s;
}

static orr_status unseen(const orr_calibration_plan *p, const orr_calibration_result *r, orr_diag *diag)
{
    char names[300] = "";
    size_t used = 0;
    for (size_t k = 0; k < r->sensors; k++)
        if (!r->seen[k] && used + 40 < sizeof names)
            used += (size_t)snprintf(names + used, sizeof names - used, "%s%s", used > 0 ? "; " : "",
                                     orr_calibration_name(p, k, NULL));
    return orr_diag_set(diag, ORR_E_NUMERIC, "the plan is singular: it cannot see %s",
                        used > 0 ? names : "how the unit is mounted");
}

orr_status orr_calibration_solve(const orr_calibration_plan *plan, const orr_calibration_data *data,
                                 const double *start, int most, orr_calibration_result *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_status s = check_plan(plan, diag);
    if (s != ORR_OK) return s;
    const size_t n = orr_calibration_unknowns(plan);
    double value[ORR_CALIBRATION_MOST] = {0}, x[ORR_CALIBRATION_MOST];
    if (start != NULL) memcpy(value, start, n * sizeof *value);
    for (int k = 0; k < most && s == ORR_OK; k++) {
        s = one_step(plan, data, value, x, out, diag);
        if (s == ORR_OK && out->unseen > 0) s = unseen(plan, out, diag);
        if (s != ORR_OK) break;
        double moved = 0; // in sigmas
        for (size_t i = 0; i < n; i++) {
            value[i] += x[i];
            moved = fmax(moved, fabs(x[i]) / out->sigma[i]);
            if (!isfinite(value[i]))
                s = orr_diag_set(diag, ORR_E_NUMERIC, "the calibration does not converge");
        }
        out->iterations = k + 1;
        if (moved < 1e-7) break;
    }
    memcpy(out->value, value, sizeof value);
    if (s != ORR_OK) orr_calibration_result_free(out);
    return s;
}

void orr_calibration_linear_free(orr_calibration_linear *l)
{
    free(l->J);
    free(l->y);
    orr_calibration_result_free(&l->at);
    memset(l, 0, sizeof *l);
}

orr_status orr_calibration_linearise(const orr_calibration_plan *plan, const orr_calibration_data *data,
                                     const double *value, orr_calibration_linear *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    out->about = data;
    orr_status s = orr_calibration_solve(plan, data, value, 1, &out->at, diag);
    if (s == ORR_OK) s = all_rows(plan, data, value, &out->J, &out->y, &out->rows, diag);
    memcpy(out->at.value, value, orr_calibration_unknowns(plan) * sizeof *value);
    if (s != ORR_OK) orr_calibration_linear_free(out);
    return s;
}

void orr_calibration_linear_step(const orr_calibration_plan *plan, const orr_calibration_linear *l,
                                 const orr_calibration_data *data, double *value)
{
    const size_t n = l->at.n;
    double b[ORR_CALIBRATION_MOST] = {0};
    for (size_t k = 0; k < data->n; k++) {
        const double T = sqrt(data->to_s[k] - data->from_s[k]);
        const orr_vec3 g = orr_vec3_sub(data->dtheta_rad[k], l->about->dtheta_rad[k]),
                       a = orr_vec3_sub(data->dv_mps[k], l->about->dv_mps[k]);
        const double more[6] = {g.x, g.y, g.z, a.x, a.y, a.z};
        for (size_t r = 0; r < 6; r++) {
            const double sigma = T * (r < 3 ? plan->gyro_white_radps_s : plan->accel_white_mps2_s);
            const double y = l->y[6 * k + r] + more[r] / sigma, *row = l->J + (6 * k + r) * n;
            for (size_t i = 0; i < n; i++) b[i] += row[i] * y;
        }
    }
    for (size_t i = 0; i < n; i++) {
        value[i] = l->at.value[i];
        for (size_t k = 0; k < n; k++) value[i] += l->at.covariance[i * n + k] * b[k];
    }
}
