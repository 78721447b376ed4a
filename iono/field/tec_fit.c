// SPDX-License-Identifier: GPL-3.0-or-later
// Refit of maps to spherical harmonics. The functions of one degree are closed under rotation, so all maps
// are fitted in one set of axes that does not move (geomagnetic) and turned to the Sun afterwards: one normal
// matrix serves them all, less the few cells that a map leaves out.
#include <stdlib.h>
#include <string.h>

#include "core/linalg.h"
#include "iono/field/tec_field_private.h"

#define MAX_DESIGN 50000000 // doubles of the design matrix: 400 MB
#define MAX_ROUNDS 25

typedef struct work {
    size_t n, rows, cols, n_cells; // coefficients; grid without a doubled meridian
    double *design;                // [cell][n]
    double *normal, *full, *rhs;   // lower triangles, row-major
    double *x;
    unsigned char *state; // of a cell in the map that is fitted
} work;
enum { CELL_USED, CELL_CLIPPED, CELL_HELD, CELL_HOLE };

static void work_free(work *w)
{
    free(w->design);
    free(w->normal);
    free(w->full);
    free(w->rhs);
    free(w->x);
    free(w->state);
}

// normal += sign row row^T, lower triangle.
static void add_row(const work *w, double *normal, const double *row, double sign)
{
    for (size_t i = 0; i < w->n; i++) {
        double r = sign * row[i];
        double *restrict line = normal + i * w->n;
        for (size_t j = 0; j <= i; j++) line[j] += r * row[j];
    }
}

static orr_status work_init(const orr_tec_maps *maps, const orr_tec_field *f, work *w, orr_diag *diag)
{
    double span = maps->dlon_deg * (double)(maps->n_lon - 1);
    *w = (work){.n = f->basis.n_coef, .rows = maps->n_lat, .cols = maps->n_lon - (span > 360 - 1e-6 ? 1 : 0)};
    w->n_cells = w->rows * w->cols;
    if (w->n_cells > MAX_DESIGN / w->n)
        return orr_diag_set(diag, ORR_E_LIMIT,
                            "%s: a grid of %zu cells is too large to refit to degree %d; "
                            "the bilinear mode takes it",
                            f->source, w->n_cells, f->basis.degree);
    w->design = malloc(w->n_cells * w->n * sizeof *w->design);
    w->normal = malloc(w->n * w->n * sizeof *w->normal);
    w->full = calloc(w->n * w->n, sizeof *w->full);
    w->rhs = malloc(w->n * sizeof *w->rhs);
    w->x = malloc(w->n * sizeof *w->x);
    w->state = malloc(w->n_cells);
    if (!w->design || !w->normal || !w->full || !w->rhs || !w->x || !w->state)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory to refit maps");
    for (size_t r = 0; r < w->rows; r++)
        for (size_t c = 0; c < w->cols; c++) {
            double lat = (maps->lat0_deg + (double)r * maps->dlat_deg) * ORR_RAD_PER_DEG;
            double lon = (maps->lon0_deg + (double)c * maps->dlon_deg) * ORR_RAD_PER_DEG;
            orr_vec3 v = orr_mat3_apply(&f->geomagnetic,
                                        (orr_vec3){cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat)});
            double cb = sqrt(v.x * v.x + v.y * v.y);
            double *row = w->design + (r * w->cols + c) * w->n;
            orr_harm_row(&f->basis, v.z, cb, cb > 0 ? v.y / cb : 0, cb > 0 ? v.x / cb : 1, row);
            add_row(w, w->full, row, 1);
        }
    return ORR_OK;
}

static double value_of(const orr_tec_maps *maps, const work *w, size_t map, size_t cell)
{
    return maps->tec[(map * maps->n_lat + cell / w->cols) * maps->n_lon + cell % w->cols];
}

static double predicted(const work *w, size_t cell)
{
    const double *row = w->design + cell * w->n;
    double sum = 0;
    for (size_t i = 0; i < w->n; i++) sum += row[i] * w->x[i];
    return sum;
}

// Solves the normal equations of the cells in use into w->x.
static orr_status solve(work *w, double *scratch)
{
    memcpy(scratch, w->normal, w->n * w->n * sizeof *scratch);
    memcpy(w->x, w->rhs, w->n * sizeof *w->x);
    orr_status s =
        orr_cholesky_factor(scratch, w->n, 1e-10); // less tells a coefficient that nothing determines
    return s == ORR_OK ? orr_cholesky_solve(scratch, w->n, w->x) : s;
}

static orr_status fit_one(const orr_tec_maps *maps, orr_tec_field *f, size_t map, work *w, double *scratch,
                          double *sum_sq, orr_diag *diag)
{
    size_t n = w->n, used = 0;
    char when[ORR_TIME_TEXT];
    for (size_t i = 0; i < n; i++) w->rhs[i] = 0;
    for (size_t c = 0; c < w->n_cells; c++) {
        double y = value_of(maps, w, map, c);
        w->state[c] = isnan(y) || y < 0 ? CELL_HOLE : y == 0 ? CELL_CLIPPED : CELL_USED;
        if (w->state[c] == CELL_USED) used++;
        f->fit.n_holes += isnan(y) ? 1 : 0;
        f->fit.n_negative += y < 0 ? 1 : 0;
        f->fit.n_clipped += w->state[c] == CELL_CLIPPED;
    }
    bool from_full = used > w->n_cells / 2;
    for (size_t i = 0; i < n * n; i++) w->normal[i] = from_full ? w->full[i] : 0;
    for (size_t c = 0; c < w->n_cells; c++) {
        const double *row = w->design + c * n;
        if (w->state[c] == CELL_USED) {
            double y = value_of(maps, w, map, c);
            for (size_t i = 0; i < n; i++) w->rhs[i] += row[i] * y;
            if (!from_full) add_row(w, w->normal, row, 1);
        } else if (from_full)
            add_row(w, w->normal, row, -1);
    }
    // What is printed as 0 is only known to be at most half a unit: such a cell counts, with that value, as
    // long as the fit would say more (Newton's method for the one-sided sum of squares).
    double bound = maps->unit_tecu / 2;
    for (int round = 0; round < MAX_ROUNDS; round++) {
        if (solve(w, scratch) != ORR_OK)
            return orr_diag_set(diag, ORR_E_NUMERIC,
                                "%s: the map of %s has too few values (%zu) for harmonics of degree %d; "
                                "a lower degree or the bilinear mode may do",
                                f->source, orr_time_text(maps->t[map], when), used, f->basis.degree);
        size_t changed = 0;
        for (size_t c = 0; c < w->n_cells; c++) {
            if (w->state[c] != CELL_CLIPPED && w->state[c] != CELL_HELD) continue;
            bool hold = predicted(w, c) > bound;
            if (hold == (w->state[c] == CELL_HELD)) continue;
            const double *row = w->design + c * n;
            w->state[c] = hold ? CELL_HELD : CELL_CLIPPED;
            add_row(w, w->normal, row, hold ? 1 : -1);
            for (size_t i = 0; i < n; i++) w->rhs[i] += (hold ? bound : -bound) * row[i];
            changed++;
        }
        if (changed == 0) break;
    }
    for (size_t c = 0; c < w->n_cells; c++) f->fit.n_held += w->state[c] == CELL_HELD;
    for (size_t c = 0; c < w->n_cells; c++) {
        if (w->state[c] != CELL_USED) continue;
        double r = predicted(w, c) - value_of(maps, w, map, c);
        *sum_sq += r * r;
        if (fabs(r) > f->fit.max_tecu) f->fit.max_tecu = fabs(r);
        f->fit.n_cells++;
    }
    double *coef = f->coef + map * f->basis.size;
    orr_harm_unpack(&f->basis, w->x, coef);
    orr_harm_turn(&f->basis, f->sun[map], coef, coef);
    return ORR_OK;
}

orr_status tec_fit_maps(const orr_tec_maps *maps, orr_tec_field *f, orr_diag *diag)
{
    work w;
    orr_status s = work_init(maps, f, &w, diag);
    double *scratch = NULL, sum_sq = 0;
    if (s == ORR_OK) {
        scratch = malloc(w.n * w.n * sizeof *scratch);
        if (scratch == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "no memory to refit maps");
    }
    f->fit = (orr_tec_fit){.degree = f->basis.degree};
    for (size_t k = 0; s == ORR_OK && k < maps->n_maps; k++)
        s = fit_one(maps, f, k, &w, scratch, &sum_sq, diag);
    if (s == ORR_OK && f->fit.n_cells > 0) f->fit.rms_tecu = sqrt(sum_sq / (double)f->fit.n_cells);
    f->fitted = s == ORR_OK;
    free(scratch);
    work_free(&w);
    return s;
}
