// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario texts of anyone: the tree, the table, and what must hold of whatever is accepted.
#include <stdlib.h>
#include <string.h>

#include "src/config/scenario.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

// libfyaml 0.7.12 loses a block of 2 KiB for a quoted text with dozens of escaped quotes. Once a file at
// start, bounded by the file's size, and not ours to mend: our own leaks are still found.
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) { return "leak:libfyaml.so"; }

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_scenario s;
    orr_diag diag = {0};
    orr_status status = orr_scenario_parse("fuzz.yaml", (const char *)data, n, "folder", &s, &diag);
    if (status == ORR_OK) {
        if (s.orbit.product != NULL && s.orbit.sp3.n > 0) abort();
        if (s.orbit.product == NULL && s.orbit.sp3.n == 0 && s.motion.trajectory.kind == ORR_MOTION_NONE)
            abort();
        for (size_t i = 0; i < s.orbit.exclude.n; i++)
            if (s.orbit.exclude.item[i].to < s.orbit.exclude.item[i].from) abort();
        orr_scenario_free(&s);
    } else if (diag.text[0] == '\0' || s.orbit.sp3.item != NULL || s.title != NULL) {
        abort(); // a refusal has its sentence, and holds nothing
    }
    return 0;
}
