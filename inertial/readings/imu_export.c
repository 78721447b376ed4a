// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/readings/imu_export.h"

#include <errno.h>
#include <string.h>

// One reading in axes and units of SI.
typedef struct reading {
    double from_s, to_s;
    orr_vec3 dtheta, dv; // right, forward, up
} reading;

static reading reading_at(const orr_imu *imu, bool measured, size_t j)
{
    return (reading){orr_imu_edge_s(imu, j), orr_imu_edge_s(imu, j + 1),
                     measured ? imu->measured_dtheta_rad[j] : imu->dtheta_rad[j],
                     measured ? imu->measured_dv_mps[j] : imu->dv_mps[j]};
}

// --- Texts ---

static void put_pyins(FILE *f, const orr_imu *imu, bool measured)
{
    fputs("time,gyro_x,gyro_y,gyro_z,accel_x,accel_y,accel_z\n", f);
    for (size_t k = 0; k <= imu->n; k++) {
        // pyins pairs each increment with that before it: the first has itself.
        const reading r = reading_at(imu, measured, k == 0 ? 0 : k - 1);
        const orr_vec3 g = orr_axes_swapped(r.dtheta), a = orr_axes_swapped(r.dv);
        fprintf(f, "%.9f,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", k == 0 ? r.from_s : r.to_s, g.x, g.y, g.z,
                a.x, a.y, a.z);
    }
}

static void put_instinct(FILE *f, const orr_imu *imu, bool measured)
{
    fputs("Time [s],GpsCycle,GpsWeek,GpsToW [s],TimeStartup [ns],UnCompAccX [m/s^2],UnCompAccY "
          "[m/s^2],UnCompAccZ [m/s^2],"
          "UnCompGyroX [rad/s],UnCompGyroY [rad/s],UnCompGyroZ [rad/s]\n",
          f);
    for (size_t j = 0; j < imu->n; j++) {
        const reading r = reading_at(imu, measured, j);
        const double middle = 0.5 * (r.from_s + r.to_s);
        const orr_vec3 w = orr_axes_swapped(orr_vec3_scale(imu->rate_hz, r.dtheta)),
                       a = orr_axes_swapped(orr_vec3_scale(imu->rate_hz, r.dv));
        int32_t week;
        int64_t ns;
        orr_time_week(orr_time_add_s(imu->t0, middle), &week, &ns);
        fprintf(f, "%.9f,%d,%d,%.9f,%.0f,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n",
                middle - orr_imu_edge_s(imu, 0), week / 1024, week % 1024, (double)ns * 1e-9,
                (middle - orr_imu_edge_s(imu, 0)) * 1e9, a.x, a.y, a.z, w.x, w.y, w.z);
    }
}

static void put_psins(FILE *f, const orr_imu *imu, bool measured)
{
    for (size_t j = 0; j < imu->n; j++) {
        const reading r = reading_at(imu, measured, j);
        fprintf(f, "%.17g %.17g %.17g %.17g %.17g %.17g %.9f\n", r.dtheta.x, r.dtheta.y, r.dtheta.z, r.dv.x,
                r.dv.y, r.dv.z, r.to_s);
    }
}

static void put_navego(FILE *f, const orr_imu *imu, bool measured)
{
    for (size_t j = 0; j < imu->n; j++) {
        const reading r = reading_at(imu, measured, j);
        const orr_vec3 w = orr_axes_swapped(orr_vec3_scale(imu->rate_hz, r.dtheta)),
                       a = orr_axes_swapped(orr_vec3_scale(imu->rate_hz, r.dv));
        fprintf(f, "%.9f,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", r.to_s, a.x, a.y, a.z, w.x, w.y, w.z);
    }
}

// --- Messages ---

// Little-endian bytes of a message.
typedef struct message {
    uint8_t byte[80];
    size_t n;
} message;

static void put(message *m, uint64_t v, int bytes)
{
    for (int k = 0; k < bytes; k++) m->byte[m->n++] = (uint8_t)(v >> (8 * k));
}
static void put_bits(message *m, const void *v, size_t bytes)
{
    uint64_t bits = 0;
    if (bytes == 8) {
        memcpy(&bits, v, 8);
    } else {
        uint32_t four;
        memcpy(&four, v, 4);
        bits = four;
    }
    put(m, bits, (int)bytes);
}
static void put_double(message *m, double v) { put_bits(m, &v, sizeof v); }
static void put_float(message *m, double v)
{
    const float single = (float)v;
    put_bits(m, &single, sizeof single);
}

// NovAtel's CRC-32: polynomial 0xEDB88320 from 0, not inverted at the end.
static uint32_t crc_novatel(const message *m)
{
    uint32_t crc = 0;
    for (size_t k = 0; k < m->n; k++) {
        crc ^= m->byte[k];
        for (int b = 0; b < 8; b++) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320U : 0U);
    }
    return crc;
}
// VectorNav's CRC-16 (CCITT, polynomial 0x1021 from 0) of what follows the sync byte.
static uint16_t crc_vectornav(const message *m)
{
    uint32_t crc = 0;
    for (size_t k = 1; k < m->n; k++) {
        crc ^= (uint32_t)m->byte[k] << 8;
        for (int b = 0; b < 8; b++) crc = ((crc << 1) ^ ((crc & 0x8000U) != 0 ? 0x1021U : 0U)) & 0xFFFFU;
    }
    return (uint16_t)crc;
}

// Counts of a quantum; what is left over is carried on. False where 31 bits do not hold them.
static bool count(double value, double quantum, double *left, int32_t *out)
{
    const double exact = value / quantum + *left, whole = nearbyint(exact);
    if (!(fabs(whole) < 2147483647.0)) return false;
    *left = exact - whole;
    *out = (int32_t)whole;
    return true;
}

#define NOVATEL_ID 1462    // RAWIMUSX
#define NOVATEL_ISA100C 26 // IMU type
#define NOVATEL_RAD 1e-9   // a count of its angle
#define NOVATEL_MPS 2e-8   // and of its velocity
#define NOVATEL_BODY 40    // bytes between header and CRC

static orr_status put_novatel(FILE *f, const orr_imu *imu, bool measured, orr_diag *diag)
{
    double left[6] = {0, 0, 0, 0, 0, 0};
    for (size_t j = 0; j < imu->n; j++) {
        const reading r = reading_at(imu, measured, j);
        const double v[6] = {r.dv.z, -r.dv.y, r.dv.x, r.dtheta.z, -r.dtheta.y, r.dtheta.x};
        int32_t week;
        int64_t ns;
        orr_time_week(orr_time_add_s(imu->t0, r.to_s), &week, &ns);
        if (week < 0 || week > 65535)
            return orr_diag_set(diag, ORR_E_RANGE, "week %d has no place in RAWIMUSX", week);
        message m = {.n = 0};
        put(&m, 0x1344AA, 3); // sync of short headers
        put(&m, NOVATEL_BODY, 1);
        put(&m, NOVATEL_ID, 2);
        put(&m, (uint64_t)week, 2);
        put(&m, (uint64_t)(ns / 1000000), 4);
        put(&m, 0, 1); // no error, no time tag of another clock
        put(&m, NOVATEL_ISA100C, 1);
        put(&m, (uint64_t)week, 2);
        put_double(&m, (double)ns * 1e-9);
        put(&m, 0, 4); // status
        for (int k = 0; k < 6; k++) {
            int32_t counts;
            if (!count(v[k], k < 3 ? NOVATEL_MPS : NOVATEL_RAD, &left[k], &counts))
                return orr_diag_set(diag, ORR_E_RANGE, "reading %zu is too large for the counts of RAWIMUSX",
                                    j + 1);
            put(&m, (uint32_t)counts, 4);
        }
        put(&m, crc_novatel(&m), 4);
        fwrite(m.byte, 1, m.n, f);
    }
    return ORR_OK;
}

static orr_status put_vectornav(FILE *f, const orr_imu *imu, bool measured, orr_diag *diag)
{
    for (size_t j = 0; j < imu->n; j++) {
        const reading r = reading_at(imu, measured, j);
        const orr_time at = orr_time_add_s(imu->t0, r.to_s);
        if (at < 0) return orr_diag_set(diag, ORR_E_RANGE, "TimeGps has no instants before 1980-01-06");
        const orr_vec3 g = orr_axes_swapped(orr_vec3_scale(ORR_DEG_PER_RAD, r.dtheta)),
                       a = orr_axes_swapped(r.dv);
        message m = {.n = 0};
        put(&m, 0xFA, 1);
        put(&m, 0x06, 1);   // groups 2 (time) and 3 (IMU)
        put(&m, 0x0002, 2); // TimeGps
        put(&m, 0x00C0, 2); // DeltaTheta, DeltaVel
        put(&m, (uint64_t)at, 8);
        put_float(&m, r.to_s - r.from_s);
        put_float(&m, g.x);
        put_float(&m, g.y);
        put_float(&m, g.z);
        put_float(&m, a.x);
        put_float(&m, a.y);
        put_float(&m, a.z);
        const uint16_t crc = crc_vectornav(&m);
        put(&m, (uint64_t)(crc >> 8), 1); // most significant first
        put(&m, (uint64_t)(crc & 0xFF), 1);
        fwrite(m.byte, 1, m.n, f);
    }
    return ORR_OK;
}

static orr_status written(FILE *f, orr_diag *diag)
{
    return ferror(f) ? orr_diag_set(diag, ORR_E_IO, "the readings could not be written: %s", strerror(errno))
                     : ORR_OK;
}

orr_status orr_imu_export_write(FILE *f, const orr_imu *imu, orr_imu_export to, bool measured, orr_diag *diag)
{
    orr_status s = ORR_OK;
    if (measured && imu->measured_dtheta_rad == NULL)
        return orr_diag_set(diag, ORR_E_ARG,
                            "there are no readings with errors ('orrery imu --errors' makes them)");
    switch (to) {
    case ORR_EXPORT_PYINS:
        put_pyins(f, imu, measured);
        break;
    case ORR_EXPORT_INSTINCT:
        put_instinct(f, imu, measured);
        break;
    case ORR_EXPORT_PSINS:
        put_psins(f, imu, measured);
        break;
    case ORR_EXPORT_NAVEGO:
        put_navego(f, imu, measured);
        break;
    case ORR_EXPORT_NOVATEL:
        s = put_novatel(f, imu, measured, diag);
        break;
    case ORR_EXPORT_VECTORNAV:
        s = put_vectornav(f, imu, measured, diag);
        break;
    }
    return s == ORR_OK ? written(f, diag) : s;
}

orr_status orr_imu_export_truth(FILE *f, const orr_imu *imu, orr_diag *diag)
{
    fputs("time,lat,lon,alt,VN,VE,VD,roll,pitch,heading\n", f);
    for (size_t k = 0; k * imu->truth_every <= imu->n; k++) {
        const orr_motion m = {.r_m = imu->r_m[k], .v_mps = imu->v_mps[k], .q_be = imu->q_be[k]};
        const orr_geodetic g = orr_earth_from_ecef(m.r_m);
        const orr_vec3 v = orr_motion_velocity_enu(&m);
        const orr_angles a = orr_motion_angles(&m);
        fprintf(f, "%.9f,%.14f,%.14f,%.9f,%.12f,%.12f,%.12f,%.14f,%.14f,%.14f\n",
                orr_imu_edge_s(imu, k * imu->truth_every), g.lat_rad * ORR_DEG_PER_RAD,
                g.lon_rad * ORR_DEG_PER_RAD, g.height_m, v.y, v.x, -v.z, a.roll_rad * ORR_DEG_PER_RAD,
                a.pitch_rad * ORR_DEG_PER_RAD, orr_heading_shown_deg(a.heading_rad, 14));
    }
    return written(f, diag);
}
