// SPDX-License-Identifier: GPL-3.0-or-later
// SCPI without an instrument: headers in both forms, the error queue, the status registers, the lines of IEEE 488.2.
#include "src/service/text/scpi.h"

#include "testing.h"

static int twice(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)s, (void)n;
    fprintf(out, "%s%s", p[0], p[0]);
    return 0;
}
static int act(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n, (void)out;
    (*(int *)s->user)++;
    return 0;
}
static int range(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n, (void)out;
    snprintf(s->detail, sizeof s->detail, "says \"no\"");
    return ORR_SCPI_RANGE;
}

static const orr_scpi_command commands[] = {
    {"SATellite:TWICe?", 1, 1, twice, false},
    {"SATellite:ACT", 0, 2, act, true},
    {"SATellite:RANGe[:NOW]", 0, 0, range, false},
};

static int acted;
static orr_scpi instrument(void)
{
    acted = 0;
    return (orr_scpi){.table = {{commands, 3}}, .user = &acted, .identity = "A,B,0,1"};
}

static const char *say(orr_scpi *s, const char *line)
{
    static char answer[5000];
    char copy[2000];
    snprintf(copy, sizeof copy, "%s", line);
    memset(answer, 0, sizeof answer);
    FILE *out = fmemopen(answer, sizeof answer, "w");
    orr_scpi_line(s, copy, out);
    fclose(out);
    return answer;
}

static void headers(void **state)
{
    (void)state;
    static const char *const good[] = {"SAT:TWIC?", "satellite:twice?", ":SAT:TWICe?", "Sat:Twic?"};
    for (int k = 0; k < 4; k++) assert_true(orr_scpi_matches("SATellite:TWICe?", good[k]));
    static const char *const bad[] = {"SATE:TWIC?", "SAT:TWIC", "SAT:TWIC?X", "SAT",       "TWIC?",
                                      "SAT::TWIC?", "",         ":",          "SAT:TWIC?:"};
    for (int k = 0; k < 9; k++) assert_false(orr_scpi_matches("SATellite:TWICe?", bad[k]));
    assert_true(orr_scpi_matches("SYSTem:ERRor[:NEXT]?", "syst:err?"));
    assert_true(orr_scpi_matches("SYSTem:ERRor[:NEXT]?", "SYST:ERROR:NEXT?"));
    assert_false(orr_scpi_matches("SYSTem:ERRor[:NEXT]?", "SYST:ERR:NEX?"));
    assert_true(orr_scpi_matches("*IDN?", "*idn?"));
    static const char *const numbered[] = {"BB:REC:LAT?", "SOUR1:BB:RECEIVER2:LAT?",
                                           ":source:bb:rec:latency?", "SOURCE12:BB:REC:LAT?"};
    for (int k = 0; k < 4; k++) assert_true(orr_scpi_matches("[SOURce#:]BB:RECeiver#:LATency?", numbered[k]));
    assert_false(orr_scpi_matches("[SOURce#:]BB:RECeiver#:LATency?", "SOURX:BB:REC:LAT?"));
    assert_false(orr_scpi_matches("[SOURce#:]BB:RECeiver#:LATency?", "SOUR1:BB:REC:LAT2?"));
}

static void lines(void **state)
{
    (void)state;
    orr_scpi s = instrument();
    assert_string_equal(say(&s, "*IDN?"), "A,B,0,1\n");
    assert_string_equal(say(&s, "SAT:TWIC? ab"), "abab\n");
    assert_string_equal(say(&s, "SAT:TWIC? \"a;b\";TWIC? 'x,y';*OPC?;:SYST:VERS?"),
                        "a;ba;b;x,yx,y;1;1999.0\n");
    assert_string_equal(say(&s, "SAT:ACT;ACT 1,2; SAT:ACT"), "");
    assert_int_equal(acted, 3);
    assert_string_equal(say(&s, ";; ;"), "");
    assert_string_equal(say(&s, "SYST:ERR?"), "0,\"No error\"\n");
}

static void errors(void **state)
{
    (void)state;
    orr_scpi s = instrument();
    say(&s, "NONSENSE;SAT:TWIC?;SAT:TWIC? 1,2;SAT:RANG;*ESE 300;*ESE x");
    assert_string_equal(say(&s, "*STB?"), "4\n");
    assert_string_equal(say(&s, "SYST:ERR:COUN?"), "6\n");
    assert_string_equal(say(&s, "SYST:ERR?;ERR?"),
                        "-113,\"Undefined header;NONSENSE\";-109,\"Missing parameter;SAT:TWIC?\"\n");
    assert_string_equal(say(&s, "SYST:ERR?"), "-108,\"Parameter not allowed;SAT:TWIC?\"\n");
    assert_string_equal(say(&s, "SYST:ERR?"), "-222,\"Data out of range;says \"\"no\"\"\"\n");
    assert_string_equal(say(&s, "SYST:ERR?"), "-222,\"Data out of range\"\n");
    assert_string_equal(say(&s, "SYST:ERR?"), "-224,\"Illegal parameter value\"\n");
    assert_string_equal(say(&s, "SYST:ERR?"), "0,\"No error\"\n");
    assert_string_equal(say(&s, "*ESR?"), "48\n"); // command and execution errors
    assert_string_equal(say(&s, "*ESR?"), "0\n");
    for (int k = 0; k < 40; k++) say(&s, "X");
    for (int k = 0; k < ORR_SCPI_QUEUE - 1; k++) assert_memory_equal(say(&s, "SYST:ERR?"), "-113", 4);
    assert_string_equal(say(&s, "SYST:ERR?"), "-350,\"Queue overflow\"\n");
    assert_string_equal(say(&s, "SYST:ERR?"), "0,\"No error\"\n");
    s.read_only = true;
    say(&s, "SAT:ACT");
    assert_int_equal(acted, 0);
    assert_memory_equal(say(&s, "SYST:ERR?"), "-203", 4);
    say(&s, "X;*CLS");
    assert_string_equal(say(&s, "SYST:ERR?"), "0,\"No error\"\n");
}

static void status(void **state)
{
    (void)state;
    orr_scpi s = instrument();
    assert_string_equal(say(&s, "*ESE 1;*SRE 32;*ESE?;*SRE?"), "1;32\n");
    assert_string_equal(say(&s, "*OPC;*STB?"), "96\n"); // event summary, and service
    assert_string_equal(say(&s, "*ESR?;*STB?"), "1;0\n");
    orr_scpi_condition(&s.operation, 0x100);
    orr_scpi_condition(&s.operation, 0);
    assert_string_equal(say(&s, "STAT:OPER:COND?;ENAB 256;ENAB?;*STB?"), "0;256;128\n");
    assert_string_equal(say(&s, "*STB?"), "128\n");
    assert_string_equal(say(&s, "STAT:OPER?;OPER:EVEN?"), "256;0\n");
    assert_string_equal(say(&s, "STAT:QUES:ENAB 65535;ENAB?;:STAT:PRES;:STAT:QUES:ENAB?"), "32767;0\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(headers),
        cmocka_unit_test(lines),
        cmocka_unit_test(errors),
        cmocka_unit_test(status),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
