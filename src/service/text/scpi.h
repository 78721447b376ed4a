// SPDX-License-Identifier: GPL-3.0-or-later
// What any instrument that speaks SCPI-1999 over IEEE 488.2 has: headers in long and short form, the error queue, the status registers,
// the common commands. What this one measures and does comes from a table of its owner.
#ifndef ORR_SERVICE_TEXT_SCPI_H
#define ORR_SERVICE_TEXT_SCPI_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

// Numbers of SCPI-1999, volume 2, chapter 21.
enum {
    ORR_SCPI_SYNTAX = -102,
    ORR_SCPI_NOT_ALLOWED = -108, // a parameter too many
    ORR_SCPI_MISSING = -109,     // a parameter is missing
    ORR_SCPI_HEADER = -113,
    ORR_SCPI_EXECUTION = -200,
    ORR_SCPI_PROTECTED = -203,
    ORR_SCPI_CONFLICT = -221, // settings conflict
    ORR_SCPI_RANGE = -222,
    ORR_SCPI_ILLEGAL = -224, // illegal parameter value
    ORR_SCPI_OVERFLOW = -350,
    ORR_SCPI_OVERRUN = -363,
};
enum { ORR_SCPI_QUEUE = 16, ORR_SCPI_PARAMETERS = 32, ORR_SCPI_TABLES = 4, ORR_SCPI_SENTENCE = 256 };

// A pair of status registers below the status byte.
typedef struct orr_scpi_register {
    uint16_t condition, event, enable;
} orr_scpi_register;

typedef struct orr_scpi orr_scpi;
// Does what a header says with its parameters (texts without quotes), and writes what a query answers to out, without a line's end.
// 0, or an error's number, whose detail it may leave in s->detail.
typedef struct orr_scpi_command {
    const char *
        header; // as documents write it: "SATellite:STATe?", "SYSTem:ERRor[:NEXT]?"; # stands for a number or none
    size_t least, most; // parameters
    int (*run)(orr_scpi *s, char *const *parameter, size_t n, FILE *out);
    bool controls; // needs permission
} orr_scpi_command;

struct orr_scpi {
    struct { // the owner's, behind the common ones
        const orr_scpi_command *command;
        size_t n;
    } table[ORR_SCPI_TABLES];
    void *user;
    const char *identity; // of *IDN?
    bool read_only;
    char detail[ORR_SCPI_SENTENCE];
    // Zero at first.
    struct {
        int number;
        char detail[ORR_SCPI_SENTENCE];
    } error[ORR_SCPI_QUEUE];
    size_t n_errors;
    uint8_t esr, ese, sre;
    orr_scpi_register operation, questionable;
    char path[64]; // where headers of the same line go on
};

// One line without its end: commands divided by semicolons. What queries answer goes to out, divided by semicolons, with one line's
// end behind the last; nothing without a query. The line is changed.
void orr_scpi_line(orr_scpi *s, char *line, FILE *out);
// Puts an error into the queue; the last place of a full one is taken by -350.
void orr_scpi_fail(orr_scpi *s, int number, const char *detail);
// Sets the condition of a register; what becomes true is latched as an event.
void orr_scpi_condition(orr_scpi_register *r, uint16_t condition);
// Whether a header as it came is that of a table, in long or short form, whatever its case.
bool orr_scpi_matches(const char *pattern, const char *header);

#endif
