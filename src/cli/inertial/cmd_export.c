// SPDX-License-Identifier: GPL-3.0-or-later
// orrery export: readings in the formats of other tools.
#include <string.h>

#include "core/outfile.h"
#include "inertial/readings/imu_export.h"
#include "inertial/readings/imu_file.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"

static const struct {
    const char *name;
    orr_imu_export format;
} formats[] = {{"pyins", ORR_EXPORT_PYINS},     {"instinct", ORR_EXPORT_INSTINCT},
               {"psins", ORR_EXPORT_PSINS},     {"navego", ORR_EXPORT_NAVEGO},
               {"novatel", ORR_EXPORT_NOVATEL}, {"vectornav", ORR_EXPORT_VECTORNAV}};

static orr_status write_readings(const orr_cli *c, const orr_imu *imu, orr_diag *diag)
{
    orr_outfile out;
    size_t k = 0;
    while (strcmp(formats[k].name, orr_cli_text(c, "to", "pyins")) != 0) k++;
    const bool measured = orr_cli_says(c, "of", "measured");
    orr_status s = orr_outfile_open(orr_cli_text(c, "output", "-"), &out, diag);
    if (s != ORR_OK) return s;
    s = orr_imu_export_write(out.stream, imu, formats[k].format, measured, diag);
    return orr_outfile_end(&out, s, diag);
}

static orr_status write_truth(const orr_cli *c, const orr_imu *imu, orr_diag *diag)
{
    orr_outfile out;
    const char *path = orr_cli_text(c, "truth", NULL);
    if (path == NULL) return ORR_OK;
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    s = orr_imu_export_truth(out.stream, imu, diag);
    return orr_outfile_end(&out, s, diag);
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    orr_imu_file f;
    orr_status s = orr_imu_read(c->operand[0], orr_cli_text(c, "gravity-folder", NULL), &f, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    s = write_readings(c, &f.imu, &diag);
    if (s == ORR_OK) s = write_truth(c, &f.imu, &diag);
    orr_imu_file_free(&f);
    return s == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    {.name = "to",
     .kind = ORR_OPT_CHOICE,
     .value = "pyins|instinct|psins|navego|novatel|vectornav",
     .required = true,
     .help = "The tool, or the receiver whose messages are written."},
    {.name = "of",
     .kind = ORR_OPT_CHOICE,
     .value = "ideal|measured",
     .fallback = "ideal",
     .help = "Ideal readings (default), or those with the errors of sensors."},
    {.writes = true,
     .name = "truth",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "The true motion as CSV: time,lat,lon,alt,VN,VE,VD,roll,pitch,heading in s, deg, m, m/s; "
             "navigators start "
             "from its first row."},
    {.name = "gravity-folder",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .help = "Where a gravity model's files are now."},
    ORR_OPTION_OUTPUT,
};

const orr_command orr_cmd_export = {
    .name = "export",
    .group = "Inertial",
    .summary = "readings in the formats of other tools",
    .operands = "IMU",
    .min_operands = 1,
    .max_operands = 1,
    .about = "Writes a file of readings for pyins, INSTINCT, PSINS or NaveGo, or as messages of a receiver: "
             "NovAtel RAWIMUSX, "
             "VectorNav binary. samples/exports has a script for each that runs it or reads it back.",
    .example = "orrery imu samples/survey.yaml -o imu.nc\n"
               "orrery export imu.nc --to pyins -o imu-pyins.csv --truth truth.csv",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
