// SPDX-License-Identifier: MIT
#include "proto/fields.h"

const orr_field *orr_record_field(const orr_record *r, const char *name)
{
    for (size_t i = 0; i < r->n; i++)
        if (strcmp(r->field[i].name, name) == 0) return &r->field[i];
    return NULL;
}

#define LOAD(type)                                                                                           \
    type v;                                                                                                  \
    memcpy(&v, (const unsigned char *)at + k * sizeof v, sizeof v)

static int64_t integer(orr_field_kind kind, const void *at, uint16_t k)
{
    switch (kind) {
    case ORR_FIELD_U8: {
        LOAD(uint8_t);
        return v;
    }
    case ORR_FIELD_U16: {
        LOAD(uint16_t);
        return v;
    }
    case ORR_FIELD_U32: {
        LOAD(uint32_t);
        return v;
    }
    case ORR_FIELD_I8: {
        LOAD(int8_t);
        return v;
    }
    case ORR_FIELD_I16: {
        LOAD(int16_t);
        return v;
    }
    case ORR_FIELD_I32: {
        LOAD(int32_t);
        return v;
    }
    default: {
        LOAD(int64_t);
        return v;
    }
    }
}

int64_t orr_field_integer(const orr_field *f, const void *at) { return integer(f->kind, at, 0); }
uint64_t orr_field_bits(const orr_field *f, const void *at) { return (uint64_t)integer(f->kind, at, 0); }

double orr_field_number(const orr_field *f, const void *at, uint16_t k)
{
    orr_field_kind kind = f->kind == ORR_FIELD_LIST ? f->element : f->kind;
    if (kind == ORR_FIELD_F32) {
        LOAD(float);
        return (double)v;
    }
    if (kind == ORR_FIELD_F64) {
        LOAD(double);
        return v;
    }
    if (kind == ORR_FIELD_U64) return (double)(uint64_t)integer(kind, at, k);
    return (double)integer(kind, at, k);
}
