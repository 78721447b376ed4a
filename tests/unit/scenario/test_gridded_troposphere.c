// SPDX-License-Identifier: GPL-3.0-or-later
// GPT3, VMF3 and gradients: values that TU Wien's own routines give, closed forms, what files do not cover, and terms of channels.
#include <unistd.h>

#include "core/constants.h"
#include "src/scenario/troposphere/troposphere.h"
#include "src/scenario/troposphere/vmf3_series.h"
#include "testing.h"
#include "unit/scenario/made_channels.h"

#define FILE_OF(name) ORR_BINARY_DIR "/" ORR_TEST_NAME "_" name
#define SKY "signals: [G, E]\nmask: {elevation: 3}\nantennas: [{name: BASE, position: [52, 17, 124]}]\n"

// The header and four points of gpt3_5.grd, around Vienna (TU Wien, vmf.geo.tuwien.ac.at/codes).
static const char gpt3_text[] =
    "%  lat    lon   p:a0    A1   B1   A2   B2  T:a0   A1    B1   A2   B2  Gn_h:a0\n"
    "52.5 12.5 100913 30 -28 9 -14 283.4 -9.1 -2.9 -0.0 0.3 6.02 -2.61 -1.33 0.29 0.32 -4.6 1.0 "
    "-0.3 -0.1 -0.0 41.28 52.71 1.22768 -0.02232 -0.01085 0.00077 0.00113 0.55419 -0.01247 -0.01289 "
    "0.00358 0.00111 2.8767 0.0357 0.0804 -0.0901 0.0136 273.1 -6.7 -2.9 0.1 0.2 -27.15 -3.14 1.22 "
    "-1.71 0.40 -5.87 -5.13 -1.88 0.01 -1.18 -5.83 3.29 -0.06 -0.44 1.21 -0.13 -2.45 -0.50 0.99 "
    "0.69\n"
    "52.5 17.5 100434 46 -48 -8 -16 282.7 -10.0 -3.0 0.0 0.2 5.88 -2.85 -1.38 0.39 0.36 -4.3 1.1 "
    "-0.2 -0.2 0.1 34.11 93.18 1.22616 -0.02387 -0.01116 0.00091 0.00091 0.55353 -0.01236 -0.01138 "
    "0.00495 0.00177 2.8441 -0.0315 0.0574 -0.1257 0.0012 272.5 -7.3 -3.1 0.2 0.1 -27.20 -4.19 1.01 "
    "-1.26 0.82 -8.20 -4.46 -2.46 0.05 -0.99 -5.65 2.42 0.18 -0.50 0.72 -0.05 -0.66 0.10 0.60 -0.11\n"
    "47.5 12.5 89942 -161 -172 56 16 281.0 -8.4 -3.1 0.1 0.1 5.13 -2.91 -1.20 0.34 0.34 -6.5 0.6 "
    "-0.2 0.2 -0.1 47.30 1024.64 1.23150 -0.02207 -0.01128 0.00094 0.00117 0.52028 -0.00629 "
    "-0.01043 0.00399 0.00109 2.7298 -0.1177 0.0419 -0.0809 0.0315 270.2 -7.1 -3.1 0.2 0.1 -19.32 "
    "-2.57 0.36 -0.79 -0.44 -4.78 -3.43 -1.22 -0.74 -1.67 -10.46 9.84 2.57 -1.57 -1.27 -0.75 -0.44 "
    "0.20 0.46 0.59\n"
    "47.5 17.5 99762 183 -97 41 -6 284.8 -10.5 -2.7 -0.3 0.1 6.21 -3.28 -1.34 0.41 0.22 -5.4 1.6 "
    "-0.0 0.0 0.1 44.86 160.75 1.23260 -0.02330 -0.01094 0.00076 0.00085 0.55990 -0.00898 -0.00981 "
    "0.00444 0.00265 2.6067 -0.1332 0.0308 -0.0796 -0.0208 273.9 -7.8 -3.0 0.1 -0.1 -18.61 -3.39 "
    "0.19 -0.53 -0.20 -6.21 -1.92 -2.05 -0.80 -2.00 -4.88 1.04 0.16 1.44 0.43 -1.97 2.79 0.96 -0.35 "
    "-0.80\n";

static void write_file(const char *path, const char *text)
{
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    assert_true(fputs(text, f) >= 0);
    assert_int_equal(fclose(f), 0);
}

// What TU Wien's gpt3_5.m gives for 48.20 N 16.37 E, 156 m, MJD 56141 (as Orekit's tests print it).
static void gpt3_is_tu_wiens(void **state)
{
    (void)state;
    orr_gpt3 grid;
    orr_gpt3_values v;
    orr_diag diag = {0};
    ASSERT_OK(orr_gpt3_parse("gpt3_5.grd", gpt3_text, sizeof gpt3_text - 1, NULL, &grid, &diag), diag);
    const orr_geodetic vienna = {48.20 * ORR_RAD_PER_DEG, 16.37 * ORR_RAD_PER_DEG, 156};
    assert_true(orr_gpt3_at(&grid, vienna, orr_time_from_mjd(56141, 0, ORR_SCALE_UTC, NULL), &v));
    // Figures of the grid are floats: 6e-8 of each.
    ASSERT_NEAR(v.weather.pressure_hpa, 1002.577297099, 1e-4);
    ASSERT_NEAR(v.weather.temperature_k, 273.15 + 22.060239452, 2e-5);
    ASSERT_NEAR(v.weather.vapour_hpa, 16.676583415, 3e-6);
    ASSERT_NEAR(v.mean_k, 281.064766962, 2e-5);
    ASSERT_NEAR(v.decrease, 2.697732327, 3e-7);
    ASSERT_NEAR(v.a_hydrostatic, 0.001258154, 6e-10);
    ASSERT_NEAR(v.a_wet, 0.000568212, 6e-10);
    ASSERT_NEAR(v.gradients.north_hydrostatic_m, -0.000177344, 6e-10);
    ASSERT_NEAR(v.gradients.east_hydrostatic_m, -0.000048308, 6e-10);
    ASSERT_NEAR(v.gradients.north_wet_m, -0.000085318, 6e-10);
    ASSERT_NEAR(v.gradients.east_wet_m, -0.000035866, 6e-10);
    assert_false(orr_gpt3_at(&grid, (orr_geodetic){0.8, 0.1, 0}, 0, &v)); // 45.8 N
    orr_gpt3_free(&grid);
}

// The example that TU Wien prints with asknewet: 0.1176 m.
static void the_wet_delay_is_the_published_one(void **state)
{
    (void)state;
    ASSERT_NEAR(orr_wet_askne_nordius_m(10.9621, 273.8720, 2.8071), 0.1176, 5e-5);
}

// What TU Wien's vmf3.m gives for 37.5 N 277.5 E, 25 November 2018, 0 h (as Orekit's tests print it, whose coefficients
// are those of that hour's file), to its last digit.
static void vmf3_is_tu_wiens(void **state)
{
    (void)state;
    static const struct {
        double el_deg, hydrostatic, wet;
    } published[] = {{5, 10.132802, 10.879154}, {38, 1.621024, 1.623023}, {85, 1.003810, 1.003816}};
    orr_mapping_fractions h, w;
    const orr_geodetic place = {37.5 * ORR_RAD_PER_DEG, 277.5 * ORR_RAD_PER_DEG, 0};
    orr_mapping_vmf3_at(place, orr_time_from_mjd(58447, 0, ORR_SCALE_UTC, NULL), 0.00123462, 0.00047101, &h,
                        &w);
    for (size_t k = 0; k < sizeof published / sizeof *published; k++) {
        const double el = published[k].el_deg * ORR_RAD_PER_DEG;
        ASSERT_NEAR(orr_mapping_fraction(&h, el), published[k].hydrostatic, 1e-6);
        ASSERT_NEAR(orr_mapping_fraction(&w, el), published[k].wet, 1e-6);
    }
    ASSERT_NEAR(orr_mapping_fraction(&h, ORR_PI / 2), 1, 1e-12);
}

// Values that are linear in latitude and longitude come back as they are, over the meridian where a turn closes too; beyond the
// last parallel they hold.
static void a_lattice_is_linear_and_closes(void **state)
{
    (void)state;
    enum { ROWS = 4, COLUMNS = 8 };
    orr_lattice_point p[ROWS * COLUMNS];
    double v[ROWS * COLUMNS];
    orr_lattice l;
    orr_lattice_cell c;
    size_t bad;
    for (size_t k = 0; k < ROWS * COLUMNS; k++) {
        const double lat = 67.5 - 45.0 * (double)(k / COLUMNS), lon = 22.5 + 45.0 * (double)(k % COLUMNS);
        p[k] = (orr_lattice_point){lat, lon > 180 ? lon - 360 : lon}; // as GPT3's grids count
        v[k] = lat + 0.1 * (double)(k % COLUMNS);
    }
    assert_true(orr_lattice_learn(p, ROWS * COLUMNS, &l, &bad) && l.around);
    for (double lat = -90; lat <= 90; lat += 7)
        for (double lon = -720; lon <= 720; lon += 5) {
            assert_true(orr_lattice_find(&l, lat, lon, &c));
            double x = 0, sum = 0;
            for (int k = 0; k < 4; k++) {
                x += c.weight[k] * v[c.at[k]];
                sum += c.weight[k];
                assert_true(c.weight[k] >= -1e-6);
            }
            double steps = fmod(lon - 22.5 + 1440, 360) / 45;
            if (steps > 7) steps = 7 * (8 - steps); // from the last column back to the first
            ASSERT_NEAR(x, fmax(fmin(lat, 67.5), -67.5) + 0.1 * steps, 1e-9);
            ASSERT_NEAR(sum, 1, 1e-12);
        }
    p[9].lon_deg += 0.01;
    assert_false(orr_lattice_learn(p, ROWS * COLUMNS, &l, &bad));
    assert_int_equal(bad, 9);
    p[9].lon_deg -= 0.01;
    assert_false(orr_lattice_learn(p, ROWS * COLUMNS - 1, &l, &bad));
    assert_true(orr_lattice_learn(p, 3 * COLUMNS, &l, &bad)); // the southernmost row is gone
    assert_false(orr_lattice_find(&l, -30, 0, &c));
}

// Values of the made files: linear in hours after midnight UTC and in degrees from 50 N 15 E.
static orr_vmf3_values made_at(double hour, double lat, double lon)
{
    const double x = 1e-3 * (0.1 * hour + (lat - 50) + 2 * (lon - 15));
    return (orr_vmf3_values){1.2e-3 + 1e-3 * x, 6e-4 - 1e-3 * x, 2.2 + x,        0.1 + x,
                             -1e-3 + 0.1 * x,   1e-4 + 0.1 * x,  5e-4 - 0.1 * x, -2e-4 + 0.1 * x};
}

static void write_values(FILE *f, const orr_vmf3_values *v, bool weather)
{
    fprintf(f, " %.12f %.12f %.9f %.9f", v->a_hydrostatic, v->a_wet, v->hydrostatic_m, v->wet_m);
    if (weather) fprintf(f, " 1000.00 5.00 7.00");
    fprintf(f, " %.9f %.9f %.9f %.9f\n", 1e3 * v->north_hydrostatic_m, 1e3 * v->east_hydrostatic_m,
            1e3 * v->north_wet_m, 1e3 * v->east_wet_m);
}

static const char *const grid_file[] = {FILE_OF("V3GR_20240204.H12"), FILE_OF("V3GR_20240204.H00"),
                                        FILE_OF("V3GR_20240204.H06")};
static const int grid_hour[] = {12, 0, 6};
#define SITES FILE_OF("2024035.v3gr_g")
#define HEIGHTS FILE_OF("orography")
#define GRIDS                                                                                                \
    "[" FILE_OF("V3GR_20240204.H12") ", " FILE_OF("V3GR_20240204.H00") ", " FILE_OF("V3GR_20240204.H06") "]"
#define GPT3 FILE_OF("gpt3.grd")

static int make_files(void **state)
{
    for (size_t k = 0; k < 3; k++) {
        FILE *f = fopen(grid_file[k], "w");
        assert_non_null(f);
        fprintf(f,
                "! Version:            1.0\n! Data_types:         V3GR (lat lon ah aw zhd zwd Gn_h ...)\n"
                "! Epoch:              2024 02 04 %02d 00  0.0\n! Scale_factor:       1.e+00\n",
                grid_hour[k]);
        for (int p = 0; p < 4; p++) {
            const double lat = p < 2 ? 52.5 : 47.5, lon = p % 2 == 0 ? 12.5 : 17.5;
            fprintf(f, " %.1f %.1f", lat, lon);
            const orr_vmf3_values v = made_at(grid_hour[k], lat, lon);
            write_values(f, &v, false);
        }
        assert_int_equal(fclose(f), 0);
    }
    FILE *f = fopen(SITES, "w");
    assert_non_null(f);
    for (int hour = 0; hour <= 18; hour += 6) {
        const orr_vmf3_values v = made_at(hour, 52, 17);
        fprintf(f, "BASE      %.2f", 60344 + hour / 24.0);
        write_values(f, &v, true);
        if (hour == 6 || hour == 12) {
            fprintf(f, "SHORT     %.2f", 60344 + hour / 24.0);
            write_values(f, &v, true);
        }
    }
    assert_int_equal(fclose(f), 0);
    write_file(HEIGHTS, "100 200\n0 300\n");
    write_file(GPT3, gpt3_text);
    return set_up(state);
}

static void assert_values(const orr_vmf3_values *a, const orr_vmf3_values *b)
{
    ASSERT_NEAR(a->a_hydrostatic, b->a_hydrostatic, 1e-11);
    ASSERT_NEAR(a->a_wet, b->a_wet, 1e-11);
    ASSERT_NEAR(a->north_hydrostatic_m, b->north_hydrostatic_m, 1e-11);
    ASSERT_NEAR(a->east_hydrostatic_m, b->east_hydrostatic_m, 1e-11);
    ASSERT_NEAR(a->north_wet_m, b->north_wet_m, 1e-11);
    ASSERT_NEAR(a->east_wet_m, b->east_wet_m, 1e-11);
}

static void files_of_vmf3_are_linear_in_time_and_place(void **state)
{
    (void)state;
    orr_vmf3_series *v;
    orr_vmf3_values got;
    orr_diag diag = {0};
    const orr_time midnight = orr_time_from_mjd(60344, 0, ORR_SCALE_UTC, NULL);
    ASSERT_OK(orr_vmf3_series_open(grid_file, 3, HEIGHTS, NULL, &v, &diag), diag);
    for (double hour = 0; hour <= 12; hour += 0.7)
        for (double lat = 47.5; lat <= 52.5; lat += 1.3) {
            const orr_geodetic place = {lat * ORR_RAD_PER_DEG, 14 * ORR_RAD_PER_DEG, 150};
            assert_true(orr_vmf3_series_at(v, 0, place, orr_time_add_s(midnight, hour * 3600), &got));
            const orr_vmf3_values want = made_at(hour, lat, 14);
            assert_values(&got, &want);
        }
    // At a point and its own height the delays are the file's; higher up there is less pressure, as the weight of the air between
    // has it: 0.1 % of the hydrostatic delay is 1 hPa, which 8 m of air at 1.25 kg/m^3 and 9.81 m/s^2 weigh.
    orr_geodetic place = {52.5 * ORR_RAD_PER_DEG, 17.5 * ORR_RAD_PER_DEG, 200};
    const orr_vmf3_values point = made_at(0, 52.5, 17.5);
    assert_true(orr_vmf3_series_at(v, 0, place, midnight, &got));
    ASSERT_NEAR(got.hydrostatic_m, point.hydrostatic_m, 1e-9);
    ASSERT_NEAR(got.wet_m, point.wet_m, 1e-9);
    place.height_m = 1200;
    assert_true(orr_vmf3_series_at(v, 0, place, midnight, &got));
    ASSERT_NEAR(got.wet_m, point.wet_m * exp(-0.5), 1e-9);
    ASSERT_NEAR(got.hydrostatic_m / point.hydrostatic_m, exp(-1000 / 8300.0), 4e-3);
    assert_false(orr_vmf3_series_at(v, 0, place, orr_time_add_s(midnight, -1), &got));
    assert_false(orr_vmf3_series_at(v, 0, (orr_geodetic){0.8, 0.25, 0}, midnight, &got));
    orr_vmf3_series_close(v);
    const char *const sites[] = {SITES};
    size_t station;
    char listed[20];
    ASSERT_OK(orr_vmf3_series_open(sites, 1, NULL, NULL, &v, &diag), diag);
    assert_true(orr_vmf3_series_find(v, "base", &station, listed, sizeof listed));
    for (double hour = 0; hour <= 18; hour += 0.7) {
        assert_true(orr_vmf3_series_at(v, station, place, orr_time_add_s(midnight, hour * 3600), &got));
        const orr_vmf3_values want = made_at(hour, 52, 17);
        assert_values(&got, &want);
        ASSERT_NEAR(got.hydrostatic_m, want.hydrostatic_m, 1e-9);
    }
    orr_vmf3_series_close(v);
}

// Chen and Herring's mapping: what a gradient adds is opposite on both sides, nothing across, and at the zenith.
static void gradients_have_their_closed_form(void **state)
{
    (void)state;
    const orr_gradients north = {1e-3, 0, 0, 0}, east_wet = {0, 0, 0, 1e-3};
    const double el = 10 * ORR_RAD_PER_DEG, m = 1e-3 / (sin(el) * tan(el) + 0.0031);
    ASSERT_NEAR(orr_gradients_slant(&north, 0, el).hydrostatic_m, m, 1e-15);
    ASSERT_NEAR(orr_gradients_slant(&north, ORR_PI, el).hydrostatic_m, -m, 1e-15);
    ASSERT_NEAR(orr_gradients_slant(&north, ORR_PI / 2, el).hydrostatic_m, 0, 1e-15);
    ASSERT_NEAR(orr_gradients_slant(&east_wet, ORR_PI / 2, el).wet_m, 1e-3 / (sin(el) * tan(el) + 0.0007),
                1e-15);
    ASSERT_NEAR(orr_gradients_slant(&north, 0, ORR_PI / 2).hydrostatic_m, 0, 1e-15);
}

// The delays of channels are these: zenith delay times mapping, and the gradients' share by azimuth.
static void channels_have_them(void **state)
{
    (void)state;
    static orr_channel c[ROOM];
    static const char *const section[] = {
        ("troposphere: {model: gpt3, mapping: vmf3, gradients: grid, grid: " GPT3 "}\n"),
        ("troposphere: {model: vmf3, mapping: own, gradients: files, files: " GRIDS ", orography: " HEIGHTS
         "}\n"),
        ("troposphere: {model: vmf3, mapping: vmf3, gradients: files, files: " SITES "}\n"),
        ("troposphere: {model: saastamoinen, gradients: given, gradient_hydrostatic: [1, -0.5], "
         "gradient_wet: "
         "[0, 2]}\n"),
    };
    const orr_time t = at(5000);
    const orr_geodetic place = {52 * ORR_RAD_PER_DEG, 17 * ORR_RAD_PER_DEG, 124};
    orr_scenario_troposphere s[] = {
        {.model = ORR_TROPOSPHERE_GPT3, .mapping = ORR_TROPO_MAPPING_VMF3, .gradients = ORR_GRADIENTS_GRID},
        {.model = ORR_TROPOSPHERE_VMF3, .mapping = ORR_TROPO_MAPPING_VMF3, .gradients = ORR_GRADIENTS_FILES},
        {.model = ORR_TROPOSPHERE_VMF3, .mapping = ORR_TROPO_MAPPING_VMF3, .gradients = ORR_GRADIENTS_FILES},
        {.mapping = ORR_TROPO_MAPPING_NIELL, .gradients = ORR_GRADIENTS_GIVEN, .humidity = 0.7},
    };
    char gpt3[] = GPT3, heights[] = HEIGHTS;
    char a[] = FILE_OF("V3GR_20240204.H12"), b[] = FILE_OF("V3GR_20240204.H00"),
         d[] = FILE_OF("V3GR_20240204.H06");
    char *grids[] = {a, b, d}, sites[] = SITES, *stations[] = {sites};
    double hydrostatic[] = {1, -0.5}, wet[] = {0, 2};
    s[0].grid = gpt3;
    s[1].files = (orr_text_list){3, grids};
    s[1].orography = heights;
    s[2].files = (orr_text_list){1, stations};
    s[3].gradient_hydrostatic_mm = (orr_real_list){2, hydrostatic};
    s[3].gradient_wet_mm = (orr_real_list){2, wet};
    for (size_t k = 0; k < sizeof section / sizeof *section; k++) {
        char text[2000];
        orr_troposphere *o;
        orr_diag diag = {0};
        snprintf(text, sizeof text, SKY "%s", section[k]);
        open_with(text);
        const size_t n = all_at(t, 0, c);
        assert_true(n > 5);
        ASSERT_OK(orr_troposphere_open(&s[k], NULL, &o, &diag), diag);
        const orr_troposphere_site site = orr_troposphere_at(o, 0, place, t);
        for (size_t i = 0; i < n; i++) {
            const orr_zenith_delay want = orr_troposphere_slant(&site, c[i].az_rad, c[i].el_rad);
            ASSERT_NEAR(c[i].term_m[ORR_TERM_TROPOSPHERE_HYDROSTATIC], want.hydrostatic_m, 1e-5);
            ASSERT_NEAR(c[i].term_m[ORR_TERM_TROPOSPHERE_WET], want.wet_m, 1e-5);
        }
        orr_troposphere_close(o);
        tear_down(NULL);
    }
}

static void what_files_lack_is_said(void **state)
{
    (void)state;
    refused_with(SKY "troposphere: {model: gpt3}\n", "gpt3 needs troposphere.grid");
    refused_with(SKY "troposphere: {mapping: vmf3}\n", "VMF3 needs troposphere.grid or troposphere.files");
    refused_with(SKY "troposphere: {grid: " GPT3 "}\n", "have to take something of it");
    refused_with(SKY "troposphere: {model: vmf3, files: " GRIDS "}\n", "need the heights of their points");
    refused_with(SKY "troposphere: {model: vmf3, files: " SITES ", orography: " HEIGHTS "}\n",
                 "no effect with files of stations");
    refused_with(SKY "troposphere: {gradients: given, gradient_wet: [80, 0]}\n", "80");
    static const char elsewhere[] = "signals: [G, E]\nantennas: [{name: FAR, position: [40, 17, 124]}]\n";
    char text[2000];
    snprintf(text, sizeof text, "%stroposphere: {model: gpt3, grid: " GPT3 "}\n", elsewhere);
    refused_with(text, "troposphere.grid: does not cover antenna 'FAR' at 40.0000 17.0000");
    snprintf(text, sizeof text, "%stroposphere: {model: vmf3, files: " GRIDS ", orography: " HEIGHTS "}\n",
             elsewhere);
    refused_with(text, "troposphere.files: does not cover antenna 'FAR'");
    snprintf(text, sizeof text, "%stroposphere: {model: vmf3, files: " SITES "}\n", elsewhere);
    refused_with(text, "no station 'FAR', as the antenna is called: they have BASE");
    refused_with("signals: [G]\nantennas: [{name: SHORT, position: [52, 17, 124]}]\ntroposphere: {model: "
                 "vmf3, files: " SITES "}\n",
                 "station 'SHORT' has values for less time than the others");
    refused_with("signals: [G]\nantennas: [{name: BODY}]\ntrajectory: {kind: survey, start: "
                 "2024-02-04T01:00:00, duration: 4000, "
                 "lat: 52, lon: 17, height: 500}\ntroposphere: {model: gpt3, grid: " GPT3 "}\n",
                 "covers a part of the Earth, but antenna 'BODY' moves");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gpt3_is_tu_wiens),
        cmocka_unit_test(the_wet_delay_is_the_published_one),
        cmocka_unit_test(vmf3_is_tu_wiens),
        cmocka_unit_test(a_lattice_is_linear_and_closes),
        cmocka_unit_test(files_of_vmf3_are_linear_in_time_and_place),
        cmocka_unit_test(gradients_have_their_closed_form),
        cmocka_unit_test_teardown(channels_have_them, tear_down),
        cmocka_unit_test_teardown(what_files_lack_is_said, tear_down),
    };
    return cmocka_run_group_tests(tests, make_files, NULL);
}
