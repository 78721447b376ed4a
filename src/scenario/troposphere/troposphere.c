// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/troposphere/troposphere.h"

#include <math.h>
#include <stdlib.h>

#include "core/limb.h"
#include "src/scenario/troposphere/vmf3_series.h"

struct orr_troposphere {
    int model, mapping, gradients;
    double humidity;
    orr_gradients given;
    bool has_grid;
    orr_gpt3 grid;
    orr_vmf3_series *series;          // NULL: none
    size_t station[ORR_MAX_ANTENNAS]; // of it, where it is of stations
};

static orr_status open_files(const orr_scenario_troposphere *s, const orr_leap_table *leap,
                             orr_troposphere *o, orr_diag *diag)
{
    orr_status status = ORR_OK;
    if (s->grid != NULL) status = orr_gpt3_read(s->grid, NULL, &o->grid, diag);
    o->has_grid = s->grid != NULL && status == ORR_OK;
    if (status == ORR_OK && s->files.n > 0)
        status = orr_vmf3_series_open((const char *const *)s->files.item, s->files.n, s->orography, leap,
                                      &o->series, diag);
    if (status == ORR_OK && s->gradients == ORR_GRADIENTS_FILES && !orr_vmf3_series_has_gradients(o->series))
        status = orr_diag_set(diag, ORR_E_NODATA,
                              "troposphere.gradients: the files have none; those called V3GR have");
    return status;
}

// North or east of a pair in millimetres, m.
static double given_m(const orr_real_list *pair, size_t k) { return k < pair->n ? 1e-3 * pair->item[k] : 0; }

orr_status orr_troposphere_open(const orr_scenario_troposphere *s, const orr_leap_table *leap,
                                orr_troposphere **out, orr_diag *diag)
{
    *out = NULL;
    if (s->model == ORR_TROPOSPHERE_NONE) return ORR_OK;
    orr_troposphere *o = calloc(1, sizeof *o);
    if (o == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    o->model = s->model;
    o->mapping = s->mapping;
    if (s->mapping == ORR_TROPO_MAPPING_OWN &&
        (s->model == ORR_TROPOSPHERE_GPT3 || s->model == ORR_TROPOSPHERE_VMF3))
        o->mapping = ORR_TROPO_MAPPING_VMF3;
    o->humidity = s->humidity;
    o->gradients = s->gradients;
    const orr_real_list *dry = &s->gradient_hydrostatic_mm, *wet = &s->gradient_wet_mm;
    o->given = (orr_gradients){given_m(dry, 0), given_m(dry, 1), given_m(wet, 0), given_m(wet, 1)};
    const orr_status status = open_files(s, leap, o, diag);
    if (status == ORR_OK)
        *out = o;
    else
        orr_troposphere_close(o);
    return status;
}

void orr_troposphere_close(orr_troposphere *o)
{
    if (o == NULL) return;
    if (o->has_grid) orr_gpt3_free(&o->grid);
    orr_vmf3_series_close(o->series);
    free(o);
}

bool orr_troposphere_span(const orr_troposphere *o, orr_span *out)
{
    if (o == NULL || o->series == NULL) return false;
    *out = orr_vmf3_series_span(o->series);
    return true;
}

static orr_status stand_at_station(orr_troposphere *o, size_t antenna, const char *name, bool moves,
                                   orr_diag *diag)
{
    char listed[120];
    if (moves)
        return orr_diag_set(
            diag, ORR_E_NODATA,
            "troposphere.files: they are of stations, but antenna '%s' moves: give grids of VMF3", name);
    if (orr_vmf3_series_find(o->series, name, &o->station[antenna], listed, sizeof listed)) {
        orr_vmf3_values v;
        const orr_geodetic own = {0, 0, 0}; // a station's values are for its own place
        const orr_span span = orr_vmf3_series_span(o->series);
        for (size_t k = 1; antenna == 0 && k < ORR_MAX_ANTENNAS; k++) o->station[k] = o->station[0];
        if (orr_vmf3_series_at(o->series, o->station[antenna], own, span.from, &v) &&
            orr_vmf3_series_at(o->series, o->station[antenna], own, span.to, &v))
            return ORR_OK;
        return orr_diag_set(diag, ORR_E_NODATA,
                            "troposphere.files: station '%s' has values for less time than the others", name);
    }
    return orr_diag_set(
        diag, ORR_E_NODATA,
        "troposphere.files: they know no station '%s', as the antenna is called: they have %s ...", name,
        listed);
}

orr_status orr_troposphere_stand(orr_troposphere *o, size_t antenna, const char *name,
                                 const orr_geodetic *place, orr_diag *diag)
{
    orr_status status = ORR_OK;
    if (o != NULL && o->series != NULL && orr_vmf3_series_of_stations(o->series))
        status = stand_at_station(o, antenna, name, place == NULL, diag);
    return status == ORR_OK ? orr_troposphere_covers(o, name, place, diag) : status;
}

orr_status orr_troposphere_covers(const orr_troposphere *o, const char *name, const orr_geodetic *place,
                                  orr_diag *diag)
{
    orr_gpt3_values v;
    orr_vmf3_values w;
    if (o == NULL) return ORR_OK;
    // What moves may go anywhere: a grid of a part of the Earth lacks one of these.
    static const orr_geodetic everywhere[] = {{ORR_PI / 2, 0, 0}, {-ORR_PI / 2, 0, 0},
                                              {0, 0, 0},          {0, ORR_PI / 2, 0},
                                              {0, ORR_PI, 0},     {0, 3 * ORR_PI / 2, 0}};
    const orr_geodetic *at = place != NULL ? place : everywhere;
    const size_t n = place != NULL ? 1 : sizeof everywhere / sizeof *everywhere;
    const bool grids = o->series != NULL && !orr_vmf3_series_of_stations(o->series);
    const orr_time t = o->series != NULL ? orr_vmf3_series_span(o->series).from : 0;
    const char *lacking = NULL;
    for (size_t k = 0; lacking == NULL && k < n; k++)
        lacking = o->has_grid && !orr_gpt3_at(&o->grid, at[k], t, &v)        ? "grid"
                  : grids && !orr_vmf3_series_at(o->series, 0, at[k], t, &w) ? "files"
                                                                             : NULL;
    if (lacking == NULL) return ORR_OK;
    if (place == NULL)
        return orr_diag_set(diag, ORR_E_NODATA,
                            "troposphere.%s: covers a part of the Earth, but antenna '%s' moves: give one of "
                            "all the Earth",
                            lacking, name);
    return orr_diag_set(diag, ORR_E_NODATA, "troposphere.%s: does not cover antenna '%s' at %.4f %.4f deg",
                        lacking, name, place->lat_rad * ORR_DEG_PER_RAD, place->lon_rad * ORR_DEG_PER_RAD);
}

// What the files say of a place; zero where there are none.
typedef struct from_files {
    orr_gpt3_values grid;
    orr_vmf3_values series;
} from_files;

static orr_zenith_delay zenith(const orr_troposphere *o, orr_geodetic place, orr_time t, const from_files *f)
{
    const double h = place.height_m, lat = place.lat_rad;
    switch (o->model) {
    case ORR_TROPOSPHERE_SAASTAMOINEN:
        return orr_zenith_saastamoinen(orr_weather_standard(h, o->humidity), lat, h);
    case ORR_TROPOSPHERE_DO229:
        return orr_zenith_do229(lat, h, t);
    case ORR_TROPOSPHERE_STANAG4294:
        return orr_zenith_stanag4294(h);
    case ORR_TROPOSPHERE_GPT3: {
        const orr_gpt3_values *g = &f->grid;
        return (orr_zenith_delay){orr_zenith_saastamoinen(g->weather, lat, h).hydrostatic_m,
                                  orr_wet_askne_nordius_m(g->weather.vapour_hpa, g->mean_k, g->decrease)};
    }
    default: // of VMF3's files
        return (orr_zenith_delay){f->series.hydrostatic_m, f->series.wet_m};
    }
}

static void set_vmf3(const orr_troposphere *o, orr_geodetic place, orr_time t, const from_files *f,
                     orr_troposphere_site *out)
{
    const bool series = o->series != NULL;
    if (series && orr_vmf3_series_of_stations(o->series))
        place.height_m = 0; // they are for the station's own
    orr_mapping_vmf3_at(place, t, series ? f->series.a_hydrostatic : f->grid.a_hydrostatic,
                        series ? f->series.a_wet : f->grid.a_wet, &out->hydrostatic, &out->wet);
}

static void set_gradients(const orr_troposphere *o, const from_files *f, orr_troposphere_site *out)
{
    const orr_vmf3_values *s = &f->series;
    out->has_gradients = o->gradients != ORR_GRADIENTS_NONE;
    out->gradients =
        o->gradients == ORR_GRADIENTS_GIVEN ? o->given
        : o->gradients == ORR_GRADIENTS_GRID
            ? f->grid.gradients
            : (orr_gradients){s->north_hydrostatic_m, s->east_hydrostatic_m, s->north_wet_m, s->east_wet_m};
}

orr_troposphere_site orr_troposphere_at(const orr_troposphere *o, size_t antenna, orr_geodetic place,
                                        orr_time t)
{
    orr_troposphere_site out = {.model = o->model, .mapping = o->mapping};
    from_files f = {.series = {.wet_m = 0}};
    if (place.height_m > ORR_SPACE_HEIGHT_M || (o->has_grid && !orr_gpt3_at(&o->grid, place, t, &f.grid)) ||
        (o->series != NULL && !orr_vmf3_series_at(o->series, o->station[antenna], place, t, &f.series))) {
        out.model = ORR_TROPOSPHERE_NONE;
        return out;
    }
    out.zenith = zenith(o, place, t, &f);
    if (o->mapping == ORR_TROPO_MAPPING_NIELL)
        orr_mapping_niell_at(place.lat_rad, place.height_m, t, &out.hydrostatic, &out.wet);
    if (o->mapping == ORR_TROPO_MAPPING_GMF) orr_mapping_gmf_at(place, t, &out.hydrostatic, &out.wet);
    if (o->mapping == ORR_TROPO_MAPPING_VMF3) set_vmf3(o, place, t, &f, &out);
    set_gradients(o, &f, &out);
    return out;
}

// Mapping functions are not made for less than 0.5 deg. From 1 deg down to the horizon the elevation bends towards that, without
// a corner.
static double held_rad(double el_rad)
{
    const double least = 0.5 * ORR_RAD_PER_DEG;
    if (el_rad >= 2 * least) return el_rad;
    return least + fmax(el_rad, 0) * fmax(el_rad, 0) / (4 * least);
}

// The model's own mapping.
static double own(int model, double el_rad)
{
    switch (model) {
    case ORR_TROPOSPHERE_SAASTAMOINEN:
        return orr_mapping_cosecant(el_rad);
    case ORR_TROPOSPHERE_DO229:
        return orr_mapping_black_eisner(el_rad);
    default:
        return orr_mapping_chao(el_rad);
    }
}

static orr_zenith_delay mapped(const orr_troposphere_site *site, double el)
{
    if (site->mapping == ORR_TROPO_MAPPING_OWN) {
        const double m = own(site->model, el);
        return (orr_zenith_delay){m * site->zenith.hydrostatic_m, m * site->zenith.wet_m};
    }
    return (orr_zenith_delay){orr_mapping_fraction(&site->hydrostatic, el) * site->zenith.hydrostatic_m,
                              orr_mapping_fraction(&site->wet, el) * site->zenith.wet_m};
}

orr_zenith_delay orr_troposphere_slant(const orr_troposphere_site *site, double az_rad, double el_rad)
{
    const double el = held_rad(el_rad);
    if (site->model == ORR_TROPOSPHERE_NONE) return (orr_zenith_delay){0, 0};
    orr_zenith_delay d = mapped(site, el);
    if (site->has_gradients) {
        const orr_zenith_delay g = orr_gradients_slant(&site->gradients, az_rad, el);
        d.hydrostatic_m += g.hydrostatic_m;
        d.wet_m += g.wet_m;
    }
    return d;
}
