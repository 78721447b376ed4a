// SPDX-License-Identifier: GPL-3.0-or-later
// Readings as a table.
#include <errno.h>
#include <string.h>

#include "inertial/readings/imu_file.h"

orr_status orr_imu_write_csv(FILE *f, const orr_imu *imu, orr_imu_axes axes, orr_diag *diag)
{
    char t_gps[ORR_TIME_TEXT];
    const bool frd = axes == ORR_AXES_FRD;
    fprintf(f,
            "t_s,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad,dv_x_mps,dv_y_mps,dv_z_mps,lat_deg,lon_deg,height_m,"
            "%s,heading_deg,pitch_deg,roll_deg%s%s,t_gps\n",
            frd ? "v_north_mps,v_east_mps,v_down_mps" : "v_east_mps,v_north_mps,v_up_mps",
            imu->measured_dtheta_rad != NULL
                ? ",measured_dtheta_x_rad,measured_dtheta_y_rad,measured_dtheta_z_rad,"
                  "measured_dv_x_mps,measured_dv_y_mps,measured_dv_z_mps"
                : "",
            imu->gyro_radps != NULL ? ",gyro_x_radps,gyro_y_radps,gyro_z_radps,accel_x_mps2,accel_y_mps2,"
                                      "accel_z_mps2"
                                    : "");
    if (imu->truth_every != 1)
        return orr_diag_set(diag, ORR_E_ARG, "CSV needs the truth at every sample, not at every %zu-th",
                            imu->truth_every);
    for (size_t j = 0; j <= imu->n; j++) {
        orr_motion m = {.r_m = imu->r_m[j], .v_mps = imu->v_mps[j], .q_be = imu->q_be[j]};
        orr_geodetic g = orr_earth_from_ecef(m.r_m);
        orr_vec3 v = orr_motion_velocity_enu(&m), th = {0, 0, 0}, dv = {0, 0, 0};
        orr_angles a = orr_motion_angles(&m);
        if (j > 0) {
            th = imu->dtheta_rad[j - 1];
            dv = imu->dv_mps[j - 1];
        }
        if (frd) {
            th = orr_axes_swapped(th);
            dv = orr_axes_swapped(dv);
            v = orr_axes_swapped(v); // East, North, Up to North, East, Down is the same swap
        }
        fprintf(f, "%.9f,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.11f,%.11f,%.6f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f",
                orr_imu_edge_s(imu, j), th.x, th.y, th.z, dv.x, dv.y, dv.z, g.lat_rad * ORR_DEG_PER_RAD,
                g.lon_rad * ORR_DEG_PER_RAD, g.height_m, v.x, v.y, v.z,
                orr_heading_shown_deg(a.heading_rad, 9), a.pitch_rad * ORR_DEG_PER_RAD,
                a.roll_rad * ORR_DEG_PER_RAD);
        if (imu->measured_dtheta_rad != NULL) {
            orr_vec3 w = {0, 0, 0}, a_f = {0, 0, 0};
            if (j > 0) {
                w = frd ? orr_axes_swapped(imu->measured_dtheta_rad[j - 1]) : imu->measured_dtheta_rad[j - 1];
                a_f = frd ? orr_axes_swapped(imu->measured_dv_mps[j - 1]) : imu->measured_dv_mps[j - 1];
            }
            fprintf(f, ",%.17g,%.17g,%.17g,%.17g,%.17g,%.17g", w.x, w.y, w.z, a_f.x, a_f.y, a_f.z);
        }
        if (imu->gyro_radps != NULL) {
            orr_vec3 w = frd ? orr_axes_swapped(imu->gyro_radps[j]) : imu->gyro_radps[j],
                     a_f = frd ? orr_axes_swapped(imu->accel_mps2[j]) : imu->accel_mps2[j];
            fprintf(f, ",%.17g,%.17g,%.17g,%.17g,%.17g,%.17g", w.x, w.y, w.z, a_f.x, a_f.y, a_f.z);
        }
        fprintf(f, ",%s\n", orr_time_text(orr_time_add_s(imu->t0, orr_imu_edge_s(imu, j)), t_gps));
    }
    return ferror(f) ? orr_diag_set(diag, ORR_E_IO, "the readings could not be written: %s", strerror(errno))
                     : ORR_OK;
}
