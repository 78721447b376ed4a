// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/terrain.h"

#include <math.h>
#include <stdlib.h>

static const double FAR_BELOW_M = 50;
#define BIN_RAD (2 * ORR_PI / ORR_HORIZON_BINS)

struct orr_terrain {
    orr_horizon *horizon[ORR_MAX_ANTENNAS]; // NULL: the antenna moves
};

// The part of a grid around a place, and how to see it from there.
typedef struct view {
    const orr_esri_grid *grid;
    double undulation_m, range_m,
        lift_per_m; // lift_per_m: how much higher terrain appears that is a metre farther, rad
    orr_geodetic place;
    orr_vec3 from_m; // ecef
    orr_mat3 enu;
    double column, row; // of the place
    orr_horizon *out;
    double *nearest_m;
} view;

// A node as it is seen: East, North, Up of the place; not there where the file has no height.
typedef struct node {
    orr_vec3 enu_m;
    double distance_m; // along the ground
    double az_bins;    // azimuth, in bins
    bool there;
} node;

static node see(const view *v, long row, long column)
{
    const orr_esri_grid *g = v->grid;
    const bool inside = row >= 0 && row < (long)g->rows && column >= 0 && column < (long)g->columns;
    const float h = inside ? g->height_m[(size_t)row * g->columns + (size_t)column] : NAN;
    const orr_geodetic p = {(g->north_deg - (double)row * g->lat_step_deg) * ORR_RAD_PER_DEG,
                            (g->west_deg + (double)column * g->lon_step_deg) * ORR_RAD_PER_DEG,
                            isnan(h) ? v->place.height_m : (double)h + v->undulation_m};
    node x = {.enu_m = orr_mat3_apply(&v->enu, orr_vec3_sub(orr_earth_to_ecef(p), v->from_m)),
              .there = !isnan(h)};
    x.distance_m = hypot(x.enu_m.x, x.enu_m.y);
    x.az_bins = atan2(x.enu_m.x, x.enu_m.y) / BIN_RAD;
    if (!x.there && x.distance_m < *v->nearest_m) *v->nearest_m = x.distance_m;
    return x;
}

// Raises the horizon at the azimuths between the ends of an edge, by the point of the edge that is there.
static void raise(const view *v, const node *a, const node *b)
{
    if (!a->there || !b->there || fmin(a->distance_m, b->distance_m) > v->range_m) return;
    const double from = a->az_bins, turn = remainder(b->az_bins - from, ORR_HORIZON_BINS);
    const long first = (long)ceil(fmin(from, from + turn)), last = (long)floor(fmax(from, from + turn));
    for (long k = first; k <= last; k++) {
        const double az = (double)k * BIN_RAD, c = cos(az), s = sin(az);
        const double at_a = a->enu_m.x * c - a->enu_m.y * s, at_b = b->enu_m.x * c - b->enu_m.y * s;
        const double part = at_a != at_b ? fmin(fmax(at_a / (at_a - at_b), 0), 1) : 0;
        const orr_vec3 p = orr_vec3_axpy(part, orr_vec3_sub(b->enu_m, a->enu_m), a->enu_m);
        const double distance_m = hypot(p.x, p.y);
        const float el = (float)(atan2(p.z, distance_m) + v->lift_per_m * distance_m);
        float *have = &v->out->el_rad[(k % ORR_HORIZON_BINS + ORR_HORIZON_BINS) % ORR_HORIZON_BINS];
        if (el > *have) *have = el;
    }
}

// Whether a node is one of the four around the place, or beside them: there the terrain is flatter than its nodes tell.
static bool is_own(const view *v, long row, long column)
{
    return fabs((double)row - v->row) < 1 && fabs((double)column - v->column) < 1;
}

static orr_status march(const view *v)
{
    const orr_esri_grid *g = v->grid;
    const double deg_m = 111e3, cosine = fmax(cos(v->place.lat_rad), 0.01);
    const long rows = (long)ceil(v->range_m / (deg_m * g->lat_step_deg)) + 1,
               columns = (long)ceil(v->range_m / (deg_m * cosine * g->lon_step_deg)) + 1;
    const long top = (long)floor(v->row) - rows, left = (long)floor(v->column) - columns;
    const size_t wide = (size_t)(2 * columns + 2);
    node *line[2] = {calloc(wide, sizeof(node)), calloc(wide, sizeof(node))};
    const bool room = line[0] != NULL && line[1] != NULL;
    for (long i = 0; room && i < 2 * rows + 2; i++) {
        node *now = line[i % 2], *before = line[(i + 1) % 2];
        for (size_t j = 0; j < wide; j++) {
            const long column = left + (long)j;
            now[j] = see(v, top + i, column);
            if (is_own(v, top + i, column)) now[j].there = false;
            if (j > 0) raise(v, &now[j - 1], &now[j]);
            if (i > 0) raise(v, &before[j], &now[j]);
        }
    }
    free(line[0]);
    free(line[1]);
    return room ? ORR_OK : ORR_E_MEMORY;
}

// The terrain below the place, linear between the four nodes around; NAN where the grid has none.
static double ground_m(const view *v)
{
    const orr_esri_grid *g = v->grid;
    double sum = 0;
    if (!(v->row >= 0 && v->row <= (double)g->rows - 1 && v->column >= 0 &&
          v->column <= (double)g->columns - 1))
        return (double)NAN;
    const size_t i = (size_t)fmin(v->row, (double)g->rows - 2),
                 j = (size_t)fmin(v->column, (double)g->columns - 2);
    for (size_t k = 0; k < 4; k++) {
        const double y = v->row - (double)i, x = v->column - (double)j;
        sum += (k / 2 == 0 ? 1 - y : y) * (k % 2 == 0 ? 1 - x : x) *
               (double)g->height_m[(i + k / 2) * g->columns + j + k % 2];
    }
    return sum + v->undulation_m;
}

// Elevation of a satellite whose bent ray just passes terrain at this apparent elevation.
static double bent_rad(double el_rad)
{
    const double el = fmax(el_rad * ORR_DEG_PER_RAD, -1);
    const double bending_deg = 1.13 / 60 / tan((el + 7.31 / (el + 4.4)) * ORR_RAD_PER_DEG);
    return el_rad - fmax(bending_deg, 0) * ORR_RAD_PER_DEG;
}

orr_status orr_horizon_of(const orr_esri_grid *grid, double undulation_m, orr_geodetic place, double range_m,
                          bool refraction, orr_horizon *out, double *nearest_m, double *below_m,
                          orr_diag *diag)
{
    view v = {.grid = grid,
              .undulation_m = undulation_m,
              .range_m = range_m,
              .lift_per_m = refraction ? 1 / (8 * ORR_EARTH_MEAN_RADIUS_M) : 0,
              .place = place,
              .out = out,
              .nearest_m = nearest_m};
    // The place's longitude as the grid counts them.
    const double west = place.lon_rad * ORR_DEG_PER_RAD - grid->west_deg;
    v.column = (west - 360 * floor(west / 360)) / grid->lon_step_deg;
    v.row = (grid->north_deg - place.lat_rad * ORR_DEG_PER_RAD) / grid->lat_step_deg;
    const double ground = ground_m(&v);
    if (isnan(ground))
        return orr_diag_set(diag, ORR_E_NODATA, "no height of the terrain at %.4f %.4f deg",
                            place.lat_rad * ORR_DEG_PER_RAD, place.lon_rad * ORR_DEG_PER_RAD);
    *below_m = fmax(ground - place.height_m, 0);
    v.place.height_m += *below_m;
    v.from_m = orr_earth_to_ecef(v.place);
    v.enu = orr_earth_enu_from_ecef(place.lat_rad, place.lon_rad);
    *nearest_m = range_m;
    for (int k = 0; k < ORR_HORIZON_BINS; k++) out->el_rad[k] = (float)(-ORR_PI / 2);
    if (march(&v) != ORR_OK) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (int k = 0; refraction && k < ORR_HORIZON_BINS; k++)
        out->el_rad[k] = (float)bent_rad((double)out->el_rad[k]);
    return ORR_OK;
}

double orr_horizon_at(const orr_horizon *h, double az_rad)
{
    const double bins = az_rad / BIN_RAD, below = floor(bins);
    const int k = (int)below % ORR_HORIZON_BINS, next = (k + 1) % ORR_HORIZON_BINS;
    const double part = bins - below;
    return (1 - part) * (double)h->el_rad[k] + part * (double)h->el_rad[next];
}

// The horizon of one antenna.
static orr_status stand(const orr_scenario_terrain *s, const orr_esri_grid *grid, const orr_antenna *a,
                        orr_horizon *out, orr_warnings *warnings, orr_diag *diag)
{
    double nearest_m, below_m;
    orr_diag why = {.text = ""};
    const orr_status status = orr_horizon_of(grid, s->undulation_m, orr_earth_from_ecef(a->fixed.r_m),
                                             s->range_m, s->refraction, out, &nearest_m, &below_m, &why);
    if (status != ORR_OK)
        return orr_diag_set(diag, status, "obstacles.terrain: antenna '%s': %.*s", a->name, 150, why.text);
    if (below_m > FAR_BELOW_M)
        return orr_diag_set(
            diag, ORR_E_NODATA,
            "obstacles.terrain: antenna '%s' is %.0f m below the terrain: heights of the file are above "
            "the sea, undulation brings them above the ellipsoid",
            a->name, below_m);
    if (below_m > 0)
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "obstacles.terrain: antenna '%s' is %.1f m below the terrain: its horizon is that of the "
            "terrain's surface there",
            a->name, below_m);
    if (nearest_m < s->range_m)
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "obstacles.terrain: the file has no heights from %.1f km of antenna '%s' on, where range is "
            "%.1f km: what is there hides nothing",
            nearest_m / 1e3, a->name, s->range_m / 1e3);
    return ORR_OK;
}

orr_status orr_terrain_open(const orr_scenario *s, const orr_antenna *antenna, size_t n, orr_terrain **out,
                            orr_warnings *warnings, orr_diag *diag)
{
    const orr_scenario_terrain *t = &s->obstacles.terrain;
    orr_esri_grid grid;
    size_t standing = 0;
    *out = NULL;
    if (t->file == NULL) return ORR_OK;
    orr_status status = orr_esri_grid_read(t->file, NULL, &grid, diag);
    if (status != ORR_OK) return status;
    orr_terrain *o = calloc(1, sizeof *o);
    for (size_t k = 0; o != NULL && status == ORR_OK && k < n; k++) {
        if (antenna[k].motion != NULL) continue;
        standing++;
        o->horizon[k] = malloc(sizeof *o->horizon[k]);
        status = o->horizon[k] != NULL ? stand(t, &grid, &antenna[k], o->horizon[k], warnings, diag)
                                       : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    orr_esri_grid_free(&grid);
    if (o == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (status == ORR_OK && standing == 0)
        status = orr_diag_set(diag, ORR_E_NODATA,
                              "obstacles.terrain: has an effect on antennas that stand alone, and all move");
    if (status == ORR_OK)
        *out = o;
    else
        orr_terrain_close(o);
    return status;
}

void orr_terrain_close(orr_terrain *o)
{
    if (o == NULL) return;
    for (size_t k = 0; k < ORR_MAX_ANTENNAS; k++) free(o->horizon[k]);
    free(o);
}

bool orr_terrain_hides(const orr_terrain *o, size_t antenna, double az_rad, double el_rad)
{
    return o != NULL && o->horizon[antenna] != NULL && el_rad < orr_horizon_at(o->horizon[antenna], az_rad);
}
