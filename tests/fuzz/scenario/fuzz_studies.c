// SPDX-License-Identifier: GPL-3.0-or-later
// The other roots of YAML files: studies, sensor errors, access. The first byte chooses which; whatever is refused says why and holds nothing,
// whatever is accepted is told again by its own table.
#include <stdlib.h>
#include <string.h>

#include "src/config/access.h"
#include "src/config/sensor_file.h"
#include "src/config/study_aiding.h"
#include "src/config/study_alignment.h"
#include "src/config/study_calibration.h"
#include "src/config/study_crossovers.h"
#include "src/config/study_error_equations.h"
#include "src/config/study_vibration.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

// As in fuzz_scenario.c.
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) { return "leak:libfyaml.so"; }

static void judge(orr_status status, const orr_diag *diag)
{
    if ((status == ORR_OK) != (diag->text[0] == '\0')) abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    const orr_schema *const root[] = {
        &orr_study_aiding_schema,     &orr_study_alignment_schema, &orr_study_calibration_schema,
        &orr_study_crossovers_schema, &orr_study_errors_schema,    &orr_study_vibration_schema,
        orr_access_schema()};
    enum { ROOTS = sizeof root / sizeof root[0] };
    if (n == 0) return 0;
    const size_t which = (data[0] - (size_t)'0') % (ROOTS + 1);
    const char *text = (const char *)data + 1;
    orr_diag diag = {0};
    if (which == ROOTS) {
        orr_sensor_errors e = {0};
        const orr_status s = orr_sensor_errors_parse("folder/fuzz.yaml", text, n - 1, &e, &diag);
        judge(s, &diag);
        if (s == ORR_OK) orr_sensor_errors_free(&e);
        return 0;
    }
    void *base = malloc(root[which]->size);
    if (base == NULL) return 0;
    const orr_status s = orr_study_parse(root[which], "folder/fuzz.yaml", text, n - 1, NULL, base, &diag);
    judge(s, &diag);
    if (s == ORR_OK) orr_schema_free(root[which], base);
    free(base);
    return 0;
}
