// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/text/json_line.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "src/service/text/json_value.h"
#include "src/service/text/message_text.h"

static void put_error(FILE *out, const char *name, const char *sentence)
{
    json_t *j = json_object();
    json_object_set_new(j, "error", json_string(name));
    json_object_set_new(j, "sentence", orr_json_text(sentence));
    json_dumpf(j, out, JSON_COMPACT);
    putc('\n', out);
    json_decref(j);
}

// A request while it is filled; lists are owned.
typedef struct filling {
    const orr_asked *a;
    orr_msg_any request;
    void *list[4];
    size_t n_lists;
    char wrong[200];
} filling;

static bool fail(filling *x, const orr_field *f, const char *what)
{
    snprintf(x->wrong, sizeof x->wrong, "%s: %.150s", f->name, what);
    return false;
}

static bool store(filling *x, const orr_field *f, void *at, double v, int64_t i)
{
    switch (f->kind) {
    case ORR_FIELD_F64:
        memcpy(at, &v, sizeof v);
        return true;
    case ORR_FIELD_U8: {
        const uint8_t u = (uint8_t)i;
        memcpy(at, &u, sizeof u);
        return i == u || fail(x, f, "out of range");
    }
    case ORR_FIELD_U16: {
        const uint16_t u = (uint16_t)i;
        memcpy(at, &u, sizeof u);
        return i == u || fail(x, f, "out of range");
    }
    case ORR_FIELD_U32: {
        const uint32_t u = (uint32_t)i;
        memcpy(at, &u, sizeof u);
        return i == u || fail(x, f, "out of range");
    }
    case ORR_FIELD_I64:
    case ORR_FIELD_U64:
        memcpy(at, &i, sizeof i);
        return true;
    default:
        return fail(x, f, "cannot be given as text");
    }
}

static bool set_scalar(filling *x, const orr_field *f, void *at, const json_t *j)
{
    orr_diag diag = {0};
    orr_time t;
    if (json_is_string(j) && f->show == ORR_SHOW_TIME) {
        if (orr_time_parse(json_string_value(j), x->a->leap, &t, &diag) != ORR_OK)
            return fail(x, f, diag.text);
        return store(x, f, at, 0, t);
    }
    if (json_is_string(j)) {
        for (size_t k = 0; k < f->n_words; k++)
            if (strcmp(f->word[k].name, json_string_value(j)) == 0)
                return store(x, f, at, (double)f->word[k].value, (int64_t)f->word[k].value);
        return fail(x, f, "there is no such word");
    }
    if (json_is_integer(j)) return store(x, f, at, (double)json_integer_value(j), json_integer_value(j));
    if (json_is_boolean(j)) return store(x, f, at, json_is_true(j), json_is_true(j));
    if (json_is_real(j)) {
        const double v = json_real_value(j);
        if (f->kind != ORR_FIELD_F64 && !(v == rint(v) && fabs(v) <= 9e18))
            return fail(x, f, "is no whole number");
        return store(x, f, at, v, f->kind != ORR_FIELD_F64 ? llrint(v) : 0);
    }
    return fail(x, f, "is neither a number nor a text");
}

static bool set_array(filling *x, const orr_field *f, void *at, const json_t *j)
{
    if (!json_is_array(j) || json_array_size(j) != f->length)
        return fail(x, f, "is no list of that many numbers");
    double *to = at;
    for (uint16_t k = 0; k < f->length; k++) {
        const json_t *v = json_array_get(j, k);
        if (!json_is_null(v) && !json_is_number(v)) return fail(x, f, "is no list of that many numbers");
        to[k] = json_is_null(v) ? (double)NAN : json_number_value(v);
    }
    return true;
}

// "G05": a letter and one or two digits, whether or not anybody knows the satellite.
static bool set_sat(const json_t *v, orr_msg_sat_id *sat)
{
    const char *name = json_is_string(v) ? json_string_value(v) : "";
    char *end = NULL;
    const bool begins = name[0] >= 'A' && name[0] <= 'Z' && name[1] >= '0' && name[1] <= '9';
    const unsigned long number = begins ? strtoul(name + 1, &end, 10) : 0;
    if (!begins || *end != '\0' || end - name > 3) return false;
    *sat = (orr_msg_sat_id){(uint8_t)name[0], (uint8_t)number};
    return true;
}

static bool set_list(filling *x, const orr_field *f, void *at, const json_t *j)
{
    const size_t n = json_array_size(j);
    if (!json_is_array(j)) return fail(x, f, "is no list");
    if (n > f->limit) return fail(x, f, "has too many members");
    void *items = calloc(n + 1, sizeof(double));
    if (items == NULL || x->n_lists == sizeof x->list / sizeof x->list[0]) {
        free(items);
        return fail(x, f, "out of memory");
    }
    x->list[x->n_lists++] = items;
    for (size_t k = 0; k < n; k++) {
        const json_t *v = json_array_get(j, k);
        if (f->record != NULL && f->record->is_sat) {
            if (!set_sat(v, (orr_msg_sat_id *)items + k))
                return fail(x, f, "holds what is no satellite: \"G05\" is wanted");
        } else if (f->element == ORR_FIELD_F64) {
            if (!json_is_number(v)) return fail(x, f, "holds what is no number");
            ((double *)items)[k] = json_number_value(v);
        } else if (f->element == ORR_FIELD_U16) {
            if (!json_is_integer(v) || json_integer_value(v) < 0 || json_integer_value(v) > UINT16_MAX)
                return fail(x, f, "holds what is no whole number from 0 to 65535");
            ((uint16_t *)items)[k] = (uint16_t)json_integer_value(v);
        } else {
            return fail(x, f, "cannot be given as text");
        }
    }
    if (f->record != NULL)
        *(orr_msg_sat_id_list *)at = (orr_msg_sat_id_list){.count = (uint16_t)n, .item = items};
    else if (f->element == ORR_FIELD_F64)
        *(orr_msg_f64_list *)at = (orr_msg_f64_list){.count = (uint16_t)n, .item = items};
    else
        *(orr_msg_u16_list *)at = (orr_msg_u16_list){.count = (uint16_t)n, .item = items};
    return true;
}

static bool set_field(filling *x, const orr_field *f, void *at, const json_t *j)
{
    if (f->kind == ORR_FIELD_LIST) return set_list(x, f, at, j);
    return f->length > 0 ? set_array(x, f, at, j) : set_scalar(x, f, at, j);
}

// How many members of the object belong to the record; false where one does not fit.
static bool fill(filling *x, const orr_record *r, void *m, const json_t *j, size_t *known)
{
    for (size_t k = 0; k < r->n; k++) {
        const orr_field *f = &r->field[k];
        void *at = (char *)m + f->offset;
        if (f->kind == ORR_FIELD_STRUCT) {
            if (!fill(x, f->record, at, j, known)) return false;
            continue;
        }
        const json_t *v = json_object_get(j, f->name);
        if (v == NULL) continue;
        (*known)++;
        if (!set_field(x, f, at, v)) return false;
    }
    return true;
}

// What is not given: now, one epoch, no receiver.
static void set_defaults(filling *x, uint16_t type)
{
    orr_msg_epochs *e = orr_ask_epochs(type, &x->request);
    orr_msg_time now = {.t = 0};
    if (e != NULL && x->a->streams != NULL) orr_streams_time(x->a->streams, &now);
    if (e != NULL) *e = (orr_msg_epochs){now.t, 0, 1};
    if (type == ORR_MSG_TYPE_POLL_DELAYS)
        for (int k = 0; k < 3; k++) x->request.poll_delays.receiver_m[k] = (double)NAN;
    if (type == ORR_MSG_TYPE_CONTROL) x->request.control.t = x->request.control.at = ORR_TIME_NONE;
}

static void answer(const filling *x, uint16_t type, uint32_t count, FILE *out)
{
    orr_server_refusal why = {""};
    const orr_message_info *info;
    orr_msg_any m;
    for (uint32_t k = 0; k < count; k++) {
        const uint16_t code = orr_ask(x->a, type, &x->request, k, &info, &m, &why);
        if (code != 0) {
            const char *name = orr_msg_error_code_name(code);
            put_error(out, name != NULL ? name : "?", why.sentence);
            return;
        }
        if (info != NULL) (void)orr_message_json(info->record, &m, out);
    }
}

static const orr_message_info *kind_of(const char *name)
{
    for (uint16_t type = 1; type < 1000; type++) {
        const orr_message_info *info = orr_message_of(type);
        if (info != NULL && info->from_client && strcmp(info->name, name) == 0) return info;
    }
    return NULL;
}

static void answer_object(const orr_asked *a, const json_t *j, FILE *out)
{
    const json_t *name = json_object_get(j, "request");
    const orr_message_info *info = json_is_string(name) ? kind_of(json_string_value(name)) : NULL;
    filling x = {.a = a};
    size_t known = 1;
    if (info == NULL) {
        put_error(out, "UNKNOWN_TYPE", "\"request\" names no message that clients send");
        return;
    }
    const uint32_t most = a->most_epochs > 0 ? a->most_epochs : ORR_JSON_LINE_EPOCHS;
    char too_many[64];
    snprintf(too_many, sizeof too_many, "more than %u epochs in one line", (unsigned)most);
    set_defaults(&x, info->type);
    orr_msg_epochs *e = orr_ask_epochs(info->type, &x.request);
    if (!fill(&x, info->record, &x.request, j, &known))
        put_error(out, "BAD_PAYLOAD", x.wrong);
    else if (known != json_object_size(j))
        put_error(out, "BAD_PAYLOAD", "a member that this request does not have");
    else if (e != NULL && e->count > most)
        put_error(out, "LIMIT", too_many);
    else
        answer(&x, info->type, e != NULL && e->count > 0 ? e->count : 1, out);
    for (size_t k = 0; k < x.n_lists; k++) free(x.list[k]);
}

void orr_json_line(const orr_asked *a, const char *line, FILE *out)
{
    json_error_t error;
    json_t *j = json_loads(line, JSON_REJECT_DUPLICATES, &error);
    if (!json_is_object(j))
        put_error(out, "BAD_PAYLOAD", j == NULL ? error.text : "a line is one object");
    else
        answer_object(a, j, out);
    json_decref(j);
}
