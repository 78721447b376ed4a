// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/scenario.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define AT(member) offsetof(orr_scenario, member)

#include "src/config/motion_records.def"

static const orr_key keys[] = {
    {.path = "title",
     .kind = ORR_KEY_TEXT,
     .offset = AT(title),
     .help = "what this scenario is, in a line; clients are told"},
    {.path = "orbit.product",
     .kind = ORR_KEY_FILE,
     .offset = AT(orbit.product),
     .help = "orbit product made by 'orrery orbit' (NetCDF). Either this or orbit.sp3"},
    {.path = "orbit.sp3",
     .kind = ORR_KEY_FILE,
     .list = true,
     .offset = AT(orbit.sp3),
     .help = "precise orbit files, smoothed jointly when the service starts (seconds)"},
    {.path = "orbit.erp",
     .kind = ORR_KEY_FILE,
     .list = true,
     .offset = AT(orbit.erp),
     .help = "of orbit.sp3: Earth rotation parameters; without them IERS' secular pole, and UT1 by the leap "
             "seconds"},
    {.path = "orbit.nodes",
     .kind = ORR_KEY_REAL,
     .offset = AT(orbit.nodes_s),
     .min = 0,
     .max = 86400,
     .unit = "s",
     .fallback = "0",
     .help = "of orbit.sp3: use only epochs that are multiples of this; 0 for all"},
    {.path = "orbit.exclude",
     .kind = ORR_KEY_INTERVAL,
     .list = true,
     .offset = AT(orbit.exclude),
     .help = "of orbit.sp3: stretches of time whose epochs are not used"},
    {.path = "navdata.window",
     .kind = ORR_KEY_CHOICE,
     .offset = AT(navdata.window),
     .choices = "2h|4h|none",
     .fallback = "2h",
     .help = "how much of the orbit one fitted GPS set describes; none: no broadcast data, the service "
             "starts sooner"},
    {.path = "navdata.antex",
     .kind = ORR_KEY_FILE,
     .offset = AT(navdata.antex),
     .help = "ANTEX file: broadcast data describe the antennas' phase centres; without it the centres of "
             "mass, as STATES does"},
    {.path = "navdata.bias",
     .kind = ORR_KEY_FILE,
     .offset = AT(navdata.bias),
     .help = "Bias-SINEX or DCB file: group delays; without it they are sent as zero"},
    {.path = "navdata.nav",
     .kind = ORR_KEY_FILE,
     .list = true,
     .offset = AT(navdata.nav),
     .help = "RINEX navigation files to take GLONASS' frequency channels and Klobuchar's coefficients from; "
             "without them "
             "the nominal channels, and the coefficients of ionosphere.field if it has them"},
    {.path = "navdata.zero_clocks",
     .kind = ORR_KEY_BOOL,
     .offset = AT(navdata.zero_clocks),
     .fallback = "no",
     .help = "send a clock of zero for satellites whose clock the orbits do not know; they are left out "
             "otherwise"},
    {.path = "ionosphere.field",
     .kind = ORR_KEY_FILE,
     .offset = AT(iono.field),
     .help = "TEC field: IONEX maps, Bernese coefficients (.ION), or a RINEX navigation file (Klobuchar)"},
    {.path = "ionosphere.session",
     .kind = ORR_KEY_FILE,
     .offset = AT(iono.session),
     .help = "session made by 'orrery iono' (NetCDF); it holds its field. Either this or ionosphere.field"},
    {.path = "ionosphere.seed",
     .kind = ORR_KEY_INT,
     .offset = AT(iono.seed),
     .min = 0,
     .max = 9007199254740992.0,
     .fallback = "1",
     .help = "of ionosphere.session: seed of the noise; the same seed gives the same delays"},
    {.path = "ionosphere.noise",
     .kind = ORR_KEY_BOOL,
     .offset = AT(iono.noise),
     .fallback = "yes",
     .help =
         "of ionosphere.session: fill what the station did not see with noise of the structure that it saw"},
    {.path = "receiver.position",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = AT(receiver),
     .min = -500000,
     .max = 500000,
     .help = "receiver that questions without one mean: latitude and longitude in degrees (geodetic), height "
             "in metres. "
             "Default: the trajectory's point at each epoch, or else the station of ionosphere.session"},
    {.path = "receiver.unit",
     .kind = ORR_KEY_INT,
     .offset = AT(receiver_unit),
     .min = 0,
     .max = ORR_MOTION_MAX_UNITS - 1,
     .fallback = "0",
     .help = "of a trajectory: the inertial unit at whose point that receiver's antenna is; 0 is the "
             "trajectory's own"},
#include "src/config/motion.def"
    {.path = "serve.listen",
     .kind = ORR_KEY_TEXT,
     .list = true,
     .offset = AT(listen),
     .help = "where to listen: tcp://HOST:PORT (port 0: any free one) or unix:PATH. 'orrery serve --listen' "
             "overrules it"},
};

static const orr_schema schema = {keys, sizeof keys / sizeof keys[0], sizeof(orr_scenario)};

const orr_schema *orr_scenario_schema(void) { return &schema; }

// What the table cannot say: which keys exclude or need each other.
static orr_status check(const orr_scenario *s, const orr_yaml *y, orr_diag *diag)
{
    const orr_scenario_orbit *o = &s->orbit;
    if (o->product != NULL && o->sp3.n > 0)
        return orr_diag_at(diag, ORR_E_FORMAT, y->name, 0, 0,
                           "orbit.product and orbit.sp3 exclude each other");
    // A flight alone is a scenario too: for inertial readings without satellites.
    if (o->product == NULL && o->sp3.n == 0 && s->motion.kind == ORR_MOTION_NONE)
        return orr_diag_at(
            diag, ORR_E_FORMAT, y->name, 0, 0,
            "no orbits and no trajectory: name an orbit.product or orbit.sp3, or a trajectory.kind");
    if (o->product != NULL && (o->nodes_s > 0 || o->exclude.n > 0 || o->erp.n > 0))
        return orr_diag_at(
            diag, ORR_E_FORMAT, y->name, 0, 0,
            "orbit.nodes, orbit.exclude and orbit.erp belong to orbit.sp3; a product is smoothed already");
    const orr_scenario_navdata *n = &s->navdata;
    if (n->window == ORR_NAVDATA_NONE &&
        (n->antex != NULL || n->bias != NULL || n->nav.n > 0 || n->zero_clocks))
        return orr_diag_at(diag, ORR_E_FORMAT, y->name, 0, 0,
                           "navdata.window is none, the other keys of navdata have nothing to act on");
    if (s->iono.field != NULL && s->iono.session != NULL)
        return orr_diag_at(
            diag, ORR_E_FORMAT, y->name, 0, 0,
            "ionosphere.field and ionosphere.session exclude each other; a session holds its field");
    const orr_real_list *r = &s->receiver;
    if (r->n != 0 && r->n != 3)
        return orr_diag_at(diag, ORR_E_FORMAT, y->name, 0, 0,
                           "receiver.position has %zu numbers; latitude, longitude and height are wanted",
                           r->n);
    if (r->n == 3 && (fabs(r->item[0]) > 90 || fabs(r->item[1]) > 360))
        return orr_diag_at(diag, ORR_E_FORMAT, y->name, 0, 0,
                           "receiver.position: latitude %g, longitude %g is no place", r->item[0],
                           r->item[1]);
    const int64_t unit = s->receiver_unit;
    if (unit > 0 && r->n == 3)
        return orr_diag_at(diag, ORR_E_FORMAT, y->name, 0, 0,
                           "receiver.position and receiver.unit exclude each other");
    if (unit > 0 && s->motion.kind == ORR_MOTION_NONE)
        return orr_diag_at(diag, ORR_E_FORMAT, y->name, 0, 0,
                           "receiver.unit is a unit of a trajectory, and there is none (trajectory.kind)");
    if (unit > (int64_t)s->motion.units.n)
        return orr_diag_at(diag, ORR_E_FORMAT, y->name, 0, 0,
                           "receiver.unit: there is no unit %lld, the scenario has 0 to %zu", (long long)unit,
                           s->motion.units.n);
    return ORR_OK;
}

static orr_status bind(const orr_yaml *y, const char *folder, orr_scenario *out, orr_diag *diag)
{
    orr_status s = orr_schema_read(&schema, y, folder, out, diag);
    if (s != ORR_OK) return s;
    s = check(out, y, diag);
    if (s != ORR_OK) orr_scenario_free(out);
    return s;
}

orr_status orr_scenario_parse(const char *name, const char *text, size_t n, const char *folder,
                              orr_scenario *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_yaml y;
    orr_status s = orr_yaml_parse(name, text, n, &y, diag);
    if (s != ORR_OK) return s;
    s = bind(&y, folder, out, diag);
    orr_yaml_free(&y);
    return s;
}

orr_status orr_scenario_read(const char *path, orr_scenario *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_yaml y;
    orr_status s = orr_yaml_read(path, &y, diag);
    if (s != ORR_OK) return s;
    const char *slash = strrchr(path, '/');
    char *folder = strndup(path, slash == NULL ? 0 : slash == path ? 1 : (size_t)(slash - path));
    if (folder == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    else
        s = bind(&y, folder, out, diag);
    free(folder);
    orr_yaml_free(&y);
    return s;
}

orr_status orr_scenario_of_product(const char *path, orr_scenario *out, orr_diag *diag)
{
    const orr_yaml empty = {0};
    orr_status s = orr_schema_read(&schema, &empty, NULL, out, diag);
    if (s != ORR_OK) return s;
    out->orbit.product = strdup(path);
    if (out->orbit.product != NULL) return ORR_OK;
    orr_scenario_free(out);
    return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

void orr_scenario_free(orr_scenario *s) { orr_schema_free(&schema, s); }
