// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/earth.h"
#include "src/cli/service/message_show.h"
#include "src/service/text/message_text.h"

#define MAX_COLUMNS 64

typedef char cell[ORR_MESSAGE_CELL];
typedef struct column {
    const orr_field *field;
    uint16_t k; // which number of an array
    cell head;
    size_t width;
    bool is_left; // words, not numbers
} column;

static void number_text(const orr_field *f, const void *at, uint16_t k, cell out)
{
    double v = orr_field_number(f, at, k) * f->table_factor;
    if (!isfinite(v))
        snprintf(out, ORR_MESSAGE_CELL, "-");
    else if (f->digits < 0)
        snprintf(out, ORR_MESSAGE_CELL, "%.10g", v);
    else
        snprintf(out, ORR_MESSAGE_CELL, "%.*f", f->digits, v);
}

static bool is_floating(const orr_field *f)
{
    return f->length > 0 || f->kind == ORR_FIELD_F32 || f->kind == ORR_FIELD_F64;
}

static void cell_text(const orr_field *f, const void *at, uint16_t k, cell out)
{
    if (f->kind == ORR_FIELD_STRING)
        orr_wire_text_copy(*(const orr_wire_bytes *)at, out, ORR_MESSAGE_CELL);
    else if (is_floating(f))
        number_text(f, at, k, out);
    else
        orr_message_text(f, at, true, out);
}

// --- Columns ---

// "x m", "delay m@1575.42".
static void head_of(const orr_field *f, uint16_t k, const orr_field *per, double member, cell out)
{
    char buf[8];
    const char *unit = f->show == ORR_SHOW_TIME ? "" : f->table_unit; // an instant is not shown in it
    const char *gap = unit[0] != '\0' ? " " : "";
    if (per != NULL)
        snprintf(out, ORR_MESSAGE_CELL, "%s %s@%.*f", f->head, f->table_unit, per->digits,
                 member * per->table_factor);
    else if (f->length > 0)
        snprintf(out, ORR_MESSAGE_CELL, "%s%s%s%s%s", f->head, strlen(f->head) > 1 ? " " : "",
                 orr_message_axis(f, k, buf), gap, unit);
    else
        snprintf(out, ORR_MESSAGE_CELL, "%s%s%s", f->head, gap, unit);
}

static void add_column(column *c, size_t *n, const orr_field *f, uint16_t k, const orr_field *per,
                       double member)
{
    if (*n == MAX_COLUMNS) return;
    column *new = &c[(*n)++];
    *new = (column){.field = f, .k = k};
    new->is_left =
        !is_floating(f) && (f->n_words > 0 || f->kind == ORR_FIELD_STRUCT || f->kind == ORR_FIELD_STRING);
    head_of(f, k, per, member, new->head);
    new->width = strlen(new->head);
}

// The fields of a record, flags last. An array that goes with a list of the message has a column for each of
// its members.
static size_t columns_of(const orr_record *r, const orr_record *top, const void *message, column *c)
{
    size_t n = 0;
    for (int flags = 0; flags < 2; flags++)
        for (size_t i = 0; i < r->n; i++) {
            const orr_field *f = &r->field[i];
            bool shown = f->in_table && f->show != ORR_SHOW_ANSWER && f->kind != ORR_FIELD_LIST &&
                         f->kind != ORR_FIELD_BYTES;
            if (!shown || (f->show == ORR_SHOW_BITS) != (flags == 1)) continue;
            if (f->kind == ORR_FIELD_STRUCT && !f->record->is_sat) continue;
            const orr_field *per = f->per != NULL ? orr_record_field(top, f->per) : NULL;
            orr_wire_iter it = {0};
            double member = 0;
            if (f->length == 0) add_column(c, &n, f, 0, NULL, 0);
            for (uint16_t k = 0; k < f->length; k++)
                if (per == NULL || per->next(orr_message_member(per, message), &it, &member))
                    add_column(c, &n, f, k, per, member);
        }
    return n;
}

// --- Rows ---

typedef struct row {
    bool ok;
    cell *text; // a cell a column; without OK the first is the satellite, the second says why
} row;

static void print_padded(const char *text, size_t width, bool is_left, const char *between)
{
    if (is_left)
        printf("%s%-*s", between, (int)width, text);
    else
        printf("%s%*s", between, (int)width, text);
}

static void print_row(const column *c, size_t n, cell *text)
{
    size_t last = n; // nothing behind the last word
    while (last > 1 && text[last - 1][0] == '\0') last--;
    for (size_t i = 0; i < last; i++)
        print_padded(text[i], i + 1 == last && c[i].is_left ? 0 : c[i].width, c[i].is_left,
                     i == 0 ? "" : "  ");
    putchar('\n');
}

static const orr_field *answer_field(const orr_record *r)
{
    for (size_t i = 0; i < r->n; i++)
        if (r->field[i].show == ORR_SHOW_ANSWER) return &r->field[i];
    return NULL;
}

static const orr_field_word *answer_word(const orr_field *f, uint8_t answer)
{
    for (size_t i = 0; f != NULL && i < f->n_words; i++)
        if (f->word[i].value == answer) return &f->word[i];
    return NULL;
}

static void fill_row(column *c, size_t n, const orr_record *r, const void *one, row *out)
{
    uint8_t answer = orr_message_answer(r, one);
    out->ok = answer == ORR_MSG_ANSWER_OK;
    for (size_t i = 0; i < n && (out->ok || i == 0); i++) {
        cell_text(c[i].field, orr_message_member(c[i].field, one), c[i].k, out->text[i]);
        if (strlen(out->text[i]) > c[i].width) c[i].width = strlen(out->text[i]);
    }
    if (out->ok || n < 2) return;
    const orr_field_word *word = answer_word(answer_field(r), answer);
    snprintf(out->text[1], ORR_MESSAGE_CELL, "%s", word != NULL ? word->words : "unknown answer");
}

static bool print_list(const orr_field *list, const orr_record *top, const void *m, size_t n_rows)
{
    column c[MAX_COLUMNS];
    const orr_record *r = list->record;
    size_t n = columns_of(r, top, m, c), used = 0, counted[256] = {0};
    orr_message_room one;
    row *rows = calloc(n_rows + 1, sizeof *rows);
    cell *text = calloc((n_rows + 1) * (n + 1), sizeof *text), head[MAX_COLUMNS];
    orr_wire_iter it = {0};
    const bool room = rows != NULL && text != NULL;
    while (room && used < n_rows && list->next(orr_message_member(list, m), &it, &one)) {
        uint8_t answer = orr_message_answer(r, &one);
        const orr_field_word *word = answer_word(answer_field(r), answer);
        if (word != NULL && word->counted) {
            counted[answer]++;
            continue;
        }
        rows[used].text = text + used * (n + 1);
        fill_row(c, n, r, &one, &rows[used++]);
    }
    for (size_t i = 0; i < n; i++) memcpy(head[i], c[i].head, sizeof head[i]);
    if (used > 0) print_row(c, n, head);
    for (size_t k = 0; k < used; k++)
        if (rows[k].ok)
            print_row(c, n, rows[k].text);
        else
            printf("%s  %s\n", rows[k].text[0], rows[k].text[1]);
    for (size_t a = 0; a < 256; a++)
        if (counted[a] > 0)
            printf("%zu more %s\n", counted[a], answer_word(answer_field(r), (uint8_t)a)->words);
    free(rows);
    free(text);
    return room;
}

// --- What stands above the list ---

static void print_place(const orr_field *f, const void *at)
{
    orr_vec3 p = {orr_field_number(f, at, 0), orr_field_number(f, at, 1), orr_field_number(f, at, 2)};
    orr_geodetic g = orr_earth_from_ecef(p);
    printf("%s at %.6f, %.6f, %.1f m", f->head, g.lat_rad * ORR_DEG_PER_RAD, g.lon_rad * ORR_DEG_PER_RAD,
           g.height_m);
}

static void print_field(const orr_field *f, const void *at, int width)
{
    cell text;
    if (f->show == ORR_SHOW_PLACE) {
        print_place(f, at);
        return;
    }
    printf("%-*s", width, f->head);
    const uint16_t n = f->length > 0 ? f->length : 1;
    for (uint16_t k = 0; k < n; k++) {
        cell_text(f, at, k, text);
        printf(width > 0 ? " %15s" : " %s", text);
    }
    printf("%s%s", f->table_unit[0] != '\0' && f->show != ORR_SHOW_TIME ? " " : "",
           f->show != ORR_SHOW_TIME ? f->table_unit : "");
}

// Instants and answers of the epoch: the first words of a table.
static void print_epoch(const orr_record *r, const void *m)
{
    for (size_t i = 0; i < r->n; i++) {
        const orr_field *f = &r->field[i];
        const void *at = orr_message_member(f, m);
        cell text;
        if (f->kind == ORR_FIELD_STRUCT && f->record->spread) print_epoch(f->record, at);
        if (f->show == ORR_SHOW_TIME && strcmp(f->name, "t") == 0)
            printf("%s GPS", orr_message_text(f, at, true, text));
        if (f->show == ORR_SHOW_ANSWER && orr_message_answer(r, m) != ORR_MSG_ANSWER_OK)
            printf("  %s", orr_message_text(f, at, true, text));
    }
}

bool orr_message_table(const orr_record *r, const void *m, const char *frame)
{
    const orr_field *list = orr_message_rows(r);
    bool ok = orr_message_answer(r, m) == ORR_MSG_ANSWER_OK;
    print_epoch(r, m);
    size_t n_rows = 0;
    if (list != NULL && ok) {
        orr_message_room one;
        for (orr_wire_iter it = {0}; list->next(orr_message_member(list, m), &it, &one);) n_rows++;
        printf("  %zu %s, %s", n_rows, list->head, frame);
    }
    for (size_t i = 0; i < r->n; i++) {
        const orr_field *f = &r->field[i];
        bool shown = ok && f->in_table && f->kind != ORR_FIELD_LIST && f->kind != ORR_FIELD_STRUCT &&
                     f->show != ORR_SHOW_ANSWER;
        if (!shown) continue;
        fputs(list != NULL ? ", " : "\n  ", stdout);
        print_field(f, orr_message_member(f, m), list != NULL ? 0 : 20);
    }
    putchar('\n');
    return list == NULL || !ok || print_list(list, r, m, n_rows);
}
