// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdio.h>
#include <string.h>

#include "src/cli/report/figure.h"

#define MOST_COLUMNS 64

void figure_field(const char *row, int k, char *out, size_t n)
{
    for (; k > 0 && *row != '\0'; row++) k -= *row == ',';
    snprintf(out, n, "%.*s", (int)strcspn(row, ",\r\n"), row);
}

int figure_column(const char *head, const char *name)
{
    char text[128];
    for (int k = 0; name != NULL && k < MOST_COLUMNS; k++) {
        figure_field(head, k, text, sizeof text);
        if (strcmp(text, name) == 0) return k;
    }
    return -1;
}
