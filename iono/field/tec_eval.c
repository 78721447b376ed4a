// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation of TEC fields: what depends on time alone once an epoch, then rays without a trigonometric
// function but those of their own pierce point.
#include <string.h>

#include "core/constants.h"
#include "core/nan.h"
#include "iono/broadcast/bdgim.h"
#include "iono/field/tec_field_private.h"

// Into [-pi, pi].
static double wrapped(double a) { return a - 2 * ORR_PI * floor((a + ORR_PI) / (2 * ORR_PI)); }

// Largest k with t[k] <= t; 0 when there is none.
static size_t epoch_before(const orr_tec_field *f, orr_time t)
{
    size_t lo = 0, hi = f->n;
    while (hi - lo > 1) {
        size_t mid = lo + (hi - lo) / 2;
        if (f->t[mid] <= t)
            lo = mid;
        else
            hi = mid;
    }
    return lo;
}

static orr_status not_covered(const orr_tec_field *f, orr_time t, orr_diag *diag)
{
    if (diag == NULL) return ORR_E_RANGE;
    char at[ORR_TIME_TEXT], from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    return orr_diag_set(diag, ORR_E_RANGE, "%s covers %s to %s, not %s", f->source,
                        orr_time_text(f->from, from), orr_time_text(f->to, to), orr_time_text(t, at));
}

orr_status orr_tec_field_at(const orr_tec_field *f, orr_time t, orr_tec_instant *out, orr_diag *diag)
{
    if (t < f->from || t > f->to) return not_covered(f, t, diag);
    out->field = f;
    out->t = t;
    if (f->kind == TEC_BROADCAST) {
        size_t k = 0;
        while (k + 1 < f->n && f->set[k + 1].t <= t) k++;
        out->i0 = out->i1 = k;
        return ORR_OK;
    }
    size_t k = epoch_before(f, t);
    out->i0 = out->i1 = k;
    out->w = 0;
    orr_tec_temporal how = f->options.temporal;
    if (f->t1[k] == ORR_TIME_NONE || t > f->t1[k]) {
        if (f->t1[k] == ORR_TIME_NONE && k + 1 < f->n && f->t1[k + 1] == ORR_TIME_NONE) {
            // Before the first epoch its values are held.
            out->w = t > f->t[k] ? (double)(t - f->t[k]) / (double)(f->t[k + 1] - f->t[k]) : 0;
            if (how == ORR_TEC_NEAREST) {
                if (out->w > 0.5) out->i0 = out->i1 = k + 1;
                out->w = 0;
            } else
                out->i1 = k + 1;
        } else if (t > f->t[k] && k + 1 < f->n)
            return not_covered(f, t, diag); // between sets that hold for intervals of their own
    }
    // Sets that hold for an interval are sun-fixed by their own definition; between snapshots it is a matter
    // of choice.
    double p = f->t1[k] != ORR_TIME_NONE ? 1 : how == ORR_TEC_ROTATED ? f->options.rotation : 0;
    double east = orr_mean_sun_lon(t, f->options.leap);
    out->one = out->i0 == out->i1 || p == 1;
    out->turn0_rad = p * wrapped(f->sun_east[out->i0] - east);
    out->turn1_rad = p * wrapped(f->sun_east[out->i1] - east);
    if (f->kind == TEC_HARMONICS || f->rms.sun_fixed) {
        double sun = orr_geomagnetic_lon_of_equator(&f->geomagnetic, east);
        double s0 = f->sun[out->i0], s1 = f->sun[out->i1];
        out->axes0 = orr_axes_turned(&f->geomagnetic, p == 1 ? sun : s0 + p * wrapped(sun - s0));
        out->axes1 = out->one ? out->axes0 : orr_axes_turned(&f->geomagnetic, s1 + p * wrapped(sun - s1));
    }
    if (f->kind == TEC_HARMONICS && out->one) {
        const double *restrict a = f->coef + out->i0 * f->basis.size, *restrict b =
                                                                          f->coef + out->i1 * f->basis.size;
        double w1 = out->w, w0 = 1 - w1;
        double *restrict c = out->coef;
        for (size_t i = 0; i < f->basis.size; i++) c[i] = w0 * a[i] + w1 * b[i];
    }
    return ORR_OK;
}

// Row of a latitude and how far it is to the next; false outside a regional map.
static bool grid_row(const tec_grid *g, double lat, size_t *row, double *part)
{
    double r = (lat - g->lat0) * g->per_lat, last = (double)(g->n_lat - 1);
    if (r < 0) { // beyond the last row but this side of the pole: the row's own values
        if (!g->north_cap && r < -1e-6) return false;
        r = 0;
    } else if (r > last) {
        if (!g->south_cap && r > last + 1e-6) return false;
        r = last;
    }
    *row = (size_t)r;
    if (*row > g->n_lat - 2) *row = g->n_lat - 2;
    *part = r - (double)*row;
    return true;
}

static bool grid_col(const tec_grid *g, double lon, size_t *c0, size_t *c1, double *part)
{
    double c = (lon - g->lon0) * g->per_lon;
    c -= g->turn * floor(c * g->per_turn + 1e-12);
    if (c < 0) c = 0;
    if (!g->round && c > (double)(g->n_lon - 1)) {
        if (c > (double)(g->n_lon - 1) + 1e-6) return false;
        c = (double)(g->n_lon - 1);
    }
    size_t k = (size_t)c;
    if (!g->round && k > g->n_lon - 2) k = g->n_lon - 2;
    if (k >= g->n_lon) k = g->n_lon - 1;
    *c0 = k;
    *c1 = k + 1 < g->n_lon ? k + 1 : 0;
    *part = c - (double)k;
    return true;
}

// Bilinear in one map. NAN in a hole, -1 outside a regional map.
static double grid_at(const tec_grid *g, size_t map, size_t r0, double p, double lon)
{
    size_t c0, c1;
    double q;
    if (!grid_col(g, lon, &c0, &c1, &q)) return -1;
    const float *row0 = g->value + (map * g->n_lat + r0) * g->n_lon, *row1 = row0 + g->n_lon;
    double a = (double)row0[c0], b = (double)row0[c1], c = (double)row1[c0], d = (double)row1[c1];
    if (!g->holes) return (1 - p) * ((1 - q) * a + q * b) + p * ((1 - q) * c + q * d);
    double v = 0; // a neighbour without weight may be a hole
    if (p < 1 && q < 1) v += (1 - p) * (1 - q) * a;
    if (p < 1 && q > 0) v += (1 - p) * q * b;
    if (p > 0 && q < 1) v += p * (1 - q) * c;
    if (p > 0 && q > 0) v += p * q * d;
    return v;
}

static double grid_between(const tec_grid *g, const orr_tec_instant *at, double lat, double lon, double turn0,
                           double turn1)
{
    size_t r0;
    double p;
    if (!grid_row(g, lat, &r0, &p)) return -1;
    double v0 = grid_at(g, at->i0, r0, p, lon + turn0);
    if (at->w == 0 || v0 < 0 || isnan(v0)) return v0;
    double v1 = grid_at(g, at->i1, r0, p, lon + turn1);
    return v1 < 0 || isnan(v1) ? v1 : (1 - at->w) * v0 + at->w * v1;
}

static double harmonic(const orr_harm_basis *b, const double *coef, const orr_mat3 *axes, orr_vec3 unit)
{
    orr_vec3 v = orr_mat3_apply(axes, unit);
    double c2 = v.x * v.x + v.y * v.y;
    if (c2 < 1e-24) return orr_harm_eval(b, coef, v.z > 0 ? 1 : -1, 0, 0, 1);
    double c = sqrt(c2);
    return orr_harm_eval(b, coef, v.z, c, v.y / c, v.x / c);
}

static orr_status refuse(const orr_tec_instant *at, double v, double lat, double lon, orr_diag *diag)
{
    const char *source = at->field->source;
    lat *= ORR_DEG_PER_RAD;
    lon *= ORR_DEG_PER_RAD;
    if (isnan(v))
        return orr_diag_set(diag, ORR_E_NODATA, "%s has a hole at latitude %.2f, longitude %.2f", source, lat,
                            lon);
    return orr_diag_set(diag, ORR_E_RANGE, "%s does not reach latitude %.2f, longitude %.2f", source, lat,
                        lon);
}

static orr_klobuchar eight(const double *value)
{
    return (orr_klobuchar){{value[0], value[1], value[2], value[3]},
                           {value[4], value[5], value[6], value[7]}};
}

#define B1I_HZ 1561.098e6
#define NEQUICK_TOP_M 20.2e6

static double broadcast_vertical(const orr_tec_field *f, const double *value, orr_time t, double lat,
                                 double lon)
{
    const orr_klobuchar k = eight(value);
    switch (f->algorithm) {
    case ORR_TEC_BEIDOU:
        return orr_klobuchar_beidou_vertical_m(&k, t, lat, lon) /
               orr_iono_delay_m(1, B1I_HZ, ORR_MEASURES_CODE);
    case ORR_TEC_BDGIM:
        return orr_bdgim_vertical_tecu(value, t, lat, lon);
    case ORR_TEC_NEQUICK:
        return orr_nequick_slant_tecu(f->nequick, value, t, f->options.leap, (orr_geodetic){lat, lon, 0},
                                      (orr_geodetic){lat, lon, NEQUICK_TOP_M});
    default:
        return orr_klobuchar_vertical_m(&k, t, lat, lon) / orr_iono_delay_m(1, ORR_L1_HZ, ORR_MEASURES_CODE);
    }
}

static double broadcast_slant(const orr_tec_field *f, const double *value, orr_time t, orr_geodetic site,
                              double az, double el)
{
    const orr_klobuchar k = eight(value);
    switch (f->algorithm) {
    case ORR_TEC_BEIDOU:
        return orr_klobuchar_beidou_delay_m(&k, t, site.lat_rad, site.lon_rad, az, el) /
               orr_iono_delay_m(1, B1I_HZ, ORR_MEASURES_CODE);
    case ORR_TEC_BDGIM:
        return orr_bdgim_slant_tecu(value, t, site, az, el);
    case ORR_TEC_NEQUICK:
        return orr_nequick_slant_tecu(f->nequick, value, t, f->options.leap, site,
                                      orr_nequick_upper_end(site, az, el, NEQUICK_TOP_M));
    default:
        return orr_klobuchar_delay_m(&k, t, site.lat_rad, site.lon_rad, az, el) /
               orr_iono_delay_m(1, ORR_L1_HZ, ORR_MEASURES_CODE);
    }
}

static orr_status vertical(const orr_tec_instant *at, orr_vec3 unit, double lat, double lon,
                           orr_tec_value *out, orr_diag *diag)
{
    const orr_tec_field *f = at->field;
    double v;
    *out = (orr_tec_value){.sigma_tecu = ORR_NAN};
    switch (f->kind) {
    case TEC_BROADCAST:
        v = broadcast_vertical(f, f->set[at->i0].value, at->t, lat, lon);
        if (isnan(v)) return refuse(at, v, lat, lon, diag);
        if (v < 0) {
            v = 0;
            out->flags |= ORR_TEC_CLIPPED;
        }
        break;
    case TEC_GRID:
        v = grid_between(&f->tec, at, lat, lon, at->turn0_rad, at->turn1_rad);
        if (v < 0 || isnan(v)) return refuse(at, v, lat, lon, diag);
        break;
    default:
        if (f->tec.holes) { // an expansion says something everywhere; the maps it comes from did not
            double seen = grid_between(&f->tec, at, lat, lon, at->turn0_rad, at->turn1_rad);
            if (isnan(seen)) return refuse(at, seen, lat, lon, diag);
        }
        if (at->one)
            v = harmonic(&f->basis, at->coef, &at->axes0, unit);
        else
            v = (1 - at->w) * harmonic(&f->basis, f->coef + at->i0 * f->basis.size, &at->axes0, unit) +
                at->w * harmonic(&f->basis, f->coef + at->i1 * f->basis.size, &at->axes1, unit);
        if (v < 0) {
            v = 0;
            out->flags |= ORR_TEC_CLIPPED;
        }
        break;
    }
    out->vtec_tecu = v;
    if (f->rms.value != NULL) {
        double s;
        if (f->rms.sun_fixed) {
            orr_vec3 p = orr_mat3_apply(&at->axes0, unit);
            s = grid_between(&f->rms, at, atan2(p.z, sqrt(p.x * p.x + p.y * p.y)), atan2(p.y, p.x), 0, 0);
        } else
            s = grid_between(&f->rms, at, lat, lon, at->turn0_rad, at->turn1_rad);
        if (s >= 0) out->sigma_tecu = s;
    }
    return ORR_OK;
}

orr_status orr_tec_vertical(const orr_tec_instant *at, orr_vec3 unit, orr_tec_value *out, orr_diag *diag)
{
    double lat = atan2(unit.z, sqrt(unit.x * unit.x + unit.y * unit.y)), lon = atan2(unit.y, unit.x);
    return vertical(at, unit, lat, lon, out, diag);
}

orr_status orr_tec_look_through(const orr_tec_instant *at, const orr_iono_site *site,
                                const orr_pierce *pierce, orr_tec_ray *out, orr_diag *diag)
{
    const orr_tec_field *f = at->field;
    orr_tec_value v;
    out->pierce = *pierce;
    orr_status s = vertical(at, pierce->unit, pierce->lat_rad, pierce->lon_rad, &v, diag);
    if (s != ORR_OK) return s;
    out->vtec_tecu = v.vtec_tecu;
    out->flags = v.flags;
    out->mapping = orr_mapping_factor(&f->mapping, pierce->el_rad);
    if (f->kind == TEC_BROADCAST) {
        out->stec_tecu =
            broadcast_slant(f, f->set[at->i0].value, at->t, site->geodetic, pierce->az_rad, pierce->el_rad);
        if (isnan(out->stec_tecu))
            return orr_diag_set(diag, ORR_E_NODATA, "%s: its model says nothing along this ray", f->source);
        if (v.vtec_tecu > 0) out->mapping = out->stec_tecu / v.vtec_tecu;
    } else {
        out->stec_tecu = out->mapping * v.vtec_tecu;
    }
    out->sigma_tecu = out->mapping * v.sigma_tecu;
    return ORR_OK;
}
