// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/text/message_text.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/time.h"

uint8_t orr_message_answer(const orr_record *r, const void *m)
{
    for (size_t i = 0; i < r->n; i++) {
        const orr_field *f = &r->field[i];
        if (f->show == ORR_SHOW_ANSWER) return (uint8_t)orr_field_integer(f, orr_message_member(f, m));
        if (f->kind == ORR_FIELD_STRUCT && f->record->spread)
            return orr_message_answer(f->record, orr_message_member(f, m));
    }
    return ORR_MSG_ANSWER_OK;
}

const char *orr_message_name(const orr_field *f)
{
    return f->show == ORR_SHOW_TIME && strcmp(f->text_name, "t") == 0 ? "t_gps" : f->text_name;
}

const orr_field *orr_message_rows(const orr_record *r)
{
    for (size_t i = 0; i < r->n; i++)
        if (r->field[i].kind == ORR_FIELD_LIST && r->field[i].record != NULL) return &r->field[i];
    return NULL;
}

uint64_t orr_message_numbers(const orr_record *r, const void *m)
{
    const orr_field *rows = orr_message_rows(r);
    if (rows == NULL) return orr_message_answer(r, m) == ORR_MSG_ANSWER_OK;
    orr_message_room one;
    uint64_t n = 0;
    orr_wire_iter it = {0};
    while (rows->next(orr_message_member(rows, m), &it, &one))
        n += orr_message_answer(rows->record, &one) == ORR_MSG_ANSWER_OK;
    return n;
}

const char *orr_message_axis(const orr_field *f, uint16_t k, char buf[8])
{
    static const char *const three[] = {"x", "y", "z"}, *const four[] = {"w", "x", "y", "z"};
    if (f->show == ORR_SHOW_POLYNOMIAL) {
        snprintf(buf, 8, "%u", (unsigned)k);
        return buf;
    }
    if (f->per == NULL && f->length == 3 && k < 3) return three[k];
    if (f->per == NULL && f->length == 4 && k < 4) return four[k];
    snprintf(buf, 8, "%u", k + 1u);
    return buf;
}

static const orr_field_word *word_of(const orr_field *f, uint64_t value)
{
    for (size_t i = 0; i < f->n_words; i++)
        if (f->word[i].value == value) return &f->word[i];
    return NULL;
}

static char *bits_text(const orr_field *f, uint64_t bits, bool words, char cell[ORR_MESSAGE_CELL])
{
    size_t n = 0;
    cell[0] = '\0';
    for (size_t i = 0; i < f->n_words && n < ORR_MESSAGE_CELL - 1; i++) {
        const char *word = words ? f->word[i].words : f->word[i].name;
        if ((bits & f->word[i].value) == 0 || word[0] == '\0') continue;
        int add = snprintf(cell + n, ORR_MESSAGE_CELL - n, "%s%s", n == 0 ? "" : words ? ", " : " ", word);
        n += add > 0 ? (size_t)add : 0;
    }
    return cell;
}

static char *sat_text(const orr_record *r, const void *at, char cell[ORR_MESSAGE_CELL])
{
    int64_t system = orr_field_integer(&r->field[0], orr_message_member(&r->field[0], at));
    int64_t number = orr_field_integer(&r->field[1], orr_message_member(&r->field[1], at));
    if (system == 0 && number == 0) // of no satellite
        cell[0] = '\0';
    else
        snprintf(cell, ORR_MESSAGE_CELL, "%c%02d", system > ' ' && system <= '~' ? (int)system : '?',
                 (int)number);
    return cell;
}

char *orr_message_text(const orr_field *f, const void *at, bool words, char cell[ORR_MESSAGE_CELL])
{
    if (f->kind == ORR_FIELD_STRUCT) return sat_text(f->record, at, cell);
    int64_t v = orr_field_integer(f, at);
    const orr_field_word *word;
    const orr_message_info *message;
    switch (f->show) {
    case ORR_SHOW_TIME:
        if (v == ORR_TIME_NONE)
            cell[0] = '\0';
        else
            orr_time_text(v, cell);
        break;
    case ORR_SHOW_BITS:
        return bits_text(f, (uint64_t)v, words, cell);
    case ORR_SHOW_ENUM:
    case ORR_SHOW_ANSWER:
        word = word_of(f, (uint64_t)v);
        if (word != NULL)
            snprintf(cell, ORR_MESSAGE_CELL, "%s", words ? word->words : word->name);
        else
            snprintf(cell, ORR_MESSAGE_CELL, "%" PRId64, v);
        break;
    case ORR_SHOW_MESSAGE:
        message = orr_message_of((uint16_t)v);
        if (message != NULL)
            snprintf(cell, ORR_MESSAGE_CELL, "%s", message->name);
        else
            snprintf(cell, ORR_MESSAGE_CELL, "%" PRId64, v);
        break;
    case ORR_SHOW_CHAR:
        snprintf(cell, ORR_MESSAGE_CELL, "%c", v >= ' ' && v <= '~' ? (int)v : '?');
        break;
    case ORR_SHOW_HEX:
        snprintf(cell, ORR_MESSAGE_CELL, "0x%" PRIx64, (uint64_t)v);
        break;
    default:
        if (f->kind == ORR_FIELD_U64)
            snprintf(cell, ORR_MESSAGE_CELL, "%" PRIu64, (uint64_t)v);
        else
            snprintf(cell, ORR_MESSAGE_CELL, "%" PRId64, v);
    }
    return cell;
}
