// SPDX-License-Identifier: GPL-3.0-or-later
// Ranging codes against what the interface documents print of them: first and last chips, states of registers, and what is
// true of a whole code (balance, autocorrelation).
#include "testing.h"

#include "src/generator/codes/codes.h"

static int8_t chips[ORR_GEN_CHIPS_LARGEST];

// n chips from `from` on as a number, the first the highest bit; 1 for -1.
static unsigned long bits(size_t from, size_t n)
{
    unsigned long v = 0;
    for (size_t k = 0; k < n; k++) v = v << 1 | (chips[from + k] < 0);
    return v;
}

static void fill(orr_gen_code code, unsigned prn)
{
    memset(chips, 0, sizeof chips);
    assert_true(orr_gen_code_fill(code, prn, chips));
    for (size_t k = 0; k < orr_gen_code_chips(code); k++) assert_int_equal(abs(chips[k]), 1);
}

static long sum(size_t n)
{
    long s = 0;
    for (size_t k = 0; k < n; k++) s += chips[k];
    return s;
}

// Periodic autocorrelation.
static long correlation(size_t n, size_t lag)
{
    long s = 0;
    for (size_t k = 0; k < n; k++) s += chips[k] * chips[(k + lag) % n];
    return s;
}

// IS-GPS-200N table 3-Ia, "First 10 Chips Octal, C/A", PRN 1 to 37; IS-QZSS-PNT-005 table 3.2.2-1, PRN 193 to 202; DO-229E table
// A-1, PRN 120 to 125.
static void ca_first_chips(void **state)
{
    (void)state;
    static const uint16_t gps[] = {01440, 01620, 01710, 01744, 01133, 01455, 01131, 01454, 01626, 01504,
                                   01642, 01750, 01764, 01772, 01775, 01776, 01156, 01467, 01633, 01715,
                                   01746, 01763, 01063, 01706, 01743, 01761, 01770, 01774, 01127, 01453,
                                   01625, 01712, 01745, 01713, 01134, 01456, 01713};
    static const uint16_t qzss[] = {00727, 00170, 00030, 00472, 01237, 00414, 01050, 01630, 00571, 00732};
    static const uint16_t sbas[] = {00671, 00536, 01510, 01545, 00160, 00701};
    for (unsigned k = 0; k < 37; k++) {
        fill(ORR_GEN_L1CA, k + 1);
        assert_int_equal(bits(0, 10), gps[k]);
        for (size_t lag = 1; lag < 1023; lag += 17) { // a Gold code of 10 stages: three values
            const long c = correlation(1023, lag);
            assert_true(c == -1 || c == 63 || c == -65);
        }
    }
    for (unsigned k = 0; k < 10; k++) fill(ORR_GEN_L1CA, 193 + k), assert_int_equal(bits(0, 10), qzss[k]);
    for (unsigned k = 0; k < 6; k++) fill(ORR_GEN_L1CA, 120 + k), assert_int_equal(bits(0, 10), sbas[k]);
    assert_false(orr_gen_code_fill(ORR_GEN_L1CA, 64, chips));
    assert_false(orr_gen_code_fill(ORR_GEN_L1CA, 0, chips));
}

// IS-GPS-705J tables 3-Ia, 3-Ib print the state that XB begins with; XA begins with ones, so that the first 13 chips are the
// complement of that state, the rightmost bit first.
static void l5_first_chips(void **state)
{
    (void)state;
    static const struct {
        unsigned prn;
        const char *i, *q;
    } row[] = {{1, "0101011100100", "1001011001100"},  {2, "1100000110101", "0100011110110"},
               {3, "0100000001000", "1111000100011"},  {4, "1011000100110", "0011101101010"},
               {10, "0111111011110", "0010010000110"}, {17, "0100110001111", "1110011001000"},
               {24, "1100010110100", "0110111110011"}, {32, "0000010111001", "1001000101010"},
               {37, "0011010010000", "0010011010001"}, {46, "0111000111101", "0000000010011"},
               {63, "0101111001011", "0010001101001"}};
    for (size_t r = 0; r < sizeof row / sizeof row[0]; r++)
        for (int q = 0; q < 2; q++) {
            fill(q ? ORR_GEN_L5Q : ORR_GEN_L5I, row[r].prn);
            const char *text = q ? row[r].q : row[r].i;
            for (size_t k = 0; k < 13; k++) assert_int_equal(chips[k], text[12 - k] == '1' ? 1 : -1);
        }
    for (unsigned prn = 1; prn <= 37; prn++) { // no two alike
        fill(ORR_GEN_L5I, prn);
        assert_true(labs(sum(10230)) < 500);
    }
}

// IS-GPS-200N tables 3-IIa, 3-IIb print the register's state at the last chip; that chip is its lowest bit, and the 26
// chips after it, had the register gone on, are known by it. Here: the last 27 chips of the short cycle, run backward.
static uint32_t backward(size_t n)
{
    uint32_t s = 0; // a state whose next 27 chips are chips[n - 27 ..]
    const uint32_t polynomial = 0x494953c;
    uint32_t trial[27];
    for (unsigned b = 0; b < 27; b++) { // 27 chips of each unit state: linear over GF(2)
        uint32_t x = 1u << b;
        trial[b] = 0;
        for (unsigned k = 0; k < 27; k++) {
            trial[b] |= (x & 1) << k;
            x = (x >> 1) ^ (polynomial & (0u - (x & 1)));
        }
    }
    uint32_t wanted = (uint32_t)0;
    for (unsigned k = 0; k < 27; k++) wanted |= (uint32_t)(chips[n - 27 + k] < 0) << k;
    uint32_t row[27], unit[27];
    for (unsigned b = 0; b < 27; b++) row[b] = trial[b], unit[b] = 1u << b;
    for (unsigned k = 0; k < 27; k++) { // eliminate
        unsigned p = k;
        while (p < 27 && !(row[p] >> k & 1)) p++;
        if (p == 27) {
            fail_msg("the states are not independent");
            return 0;
        }
        uint32_t t = row[p];
        row[p] = row[k], row[k] = t;
        t = unit[p], unit[p] = unit[k], unit[k] = t;
        for (unsigned o = 0; o < 27; o++)
            if (o != k && (row[o] >> k & 1)) row[o] ^= row[k], unit[o] ^= unit[k];
    }
    for (unsigned k = 0; k < 27; k++)
        if (wanted >> k & 1) s ^= unit[k];
    for (unsigned k = 0; k < 26; k++) s = (s >> 1) ^ (polynomial & (0u - (s & 1)));
    return s;
}

static void l2c_end_states(void **state)
{
    (void)state;
    static const uint32_t cm[] = {0552566002, 0034445034, 0723443711, 0511222013, 0463055213, 0667044524,
                                  0652322653, 0505703344, 0520302775, 0244205506, 0236174002, 0654305531,
                                  0435070571, 0630431251, 0234043417, 0535540745, 0043056734, 0731304103};
    static const uint32_t cl[] = {0267724236, 0167516066, 0771756405, 0047202624};
    for (unsigned k = 0; k < sizeof cm / sizeof cm[0]; k++) {
        fill(ORR_GEN_L2CM, k + 1);
        assert_int_equal(backward(10230), cm[k]);
    }
    fill(ORR_GEN_L2CM, 63);
    assert_int_equal(backward(10230), 0602375063);
    for (unsigned k = 0; k < sizeof cl / sizeof cl[0]; k++) {
        fill(ORR_GEN_L2CL, k + 1);
        assert_int_equal(backward(767250), cl[k]);
    }
}

// GLONASS ICD 5.1, 3.3.2.1: an m-sequence whose first nine chips are 111111100.
static void glonass(void **state)
{
    (void)state;
    fill(ORR_GEN_GLONASS, 1);
    assert_int_equal(bits(0, 9), 0x1fc);
    assert_int_equal(sum(511), -1);
    for (size_t lag = 1; lag < 511; lag++) assert_int_equal(correlation(511, lag), -1);
}

// Galileo OS SIS ICD 2.1 tables 16 and 17, "first 24 chips" of E5a-I and E5a-Q, code 1 to 50 by pairs; annex C's first words of E1.
static void galileo(void **state)
{
    (void)state;
    static const uint32_t e5a[50][2] = {
        {0x3CEA9D, 0x515537}, {0x9D8CF1, 0xD67539}, {0x45D1C8, 0x58B2E5}, {0x7A0133, 0x305914},
        {0x64D423, 0x442710}, {0x23300D, 0x593CF8}, {0x91CEF2, 0x214AD7}, {0xAA82DC, 0x435EA6},
        {0xF2A17D, 0xC1A7D5}, {0x3D84AE, 0xF0E94A}, {0x446D38, 0xA8C239}, {0xC514F2, 0x2EB63B},
        {0x0C0184, 0x8F0A46}, {0x8767E0, 0x896DD4}, {0xCB8EFF, 0x0245F1}, {0x93EBCD, 0xEB0160},
        {0x5D55CE, 0xED28B3}, {0xB19B7C, 0xCB9F5B}, {0x5805FC, 0x576592}, {0xF99EA1, 0xA88811},
        {0xB23CE5, 0xDD3649}, {0x8515E8, 0xB59F42}, {0x436822, 0xFF81F6}, {0x30F77B, 0xCE8128},
        {0xA7D629, 0xDCD55C}, {0x9BFAC7, 0x79E450}, {0x18A25B, 0xB63460}, {0x69A39F, 0x6D562B},
        {0x39B27D, 0x3A9010}, {0x454598, 0x59CD72}, {0xF2BC62, 0xC0211A}, {0x9DDBC6, 0x28EB96},
        {0x332827, 0xD7554B}, {0x6E2FCA, 0x425126}, {0x22C6D5, 0xE0DAFB}, {0xE881D9, 0xEF79F2},
        {0x74C4DB, 0x18085D}, {0x13AB03, 0xD50CD8}, {0x119323, 0x0447B9}, {0x594886, 0x8DE877},
        {0x9F4D89, 0x0D1FA0}, {0x47A3C0, 0xC9FCF7}, {0xC9ED53, 0x48116D}, {0x334994, 0x840BCC},
        {0x1B2A30, 0x152004}, {0x5513F3, 0x0D4897}, {0x7831C1, 0xAF6D25}, {0x30B93A, 0x4B7593},
        {0x84D5B4, 0x71BB1B}, {0xA5029C, 0x53DA0E}};
    for (unsigned k = 0; k < 50; k++) {
        fill(ORR_GEN_E5AI, k + 1);
        assert_int_equal(bits(0, 24), e5a[k][0]);
        fill(ORR_GEN_E5AQ, k + 1);
        assert_int_equal(bits(0, 24), e5a[k][1]);
    }
    static const struct {
        unsigned number;
        uint32_t b, c;
    } e1[] = {{1, 0xF5D71013, 0xB39340CA},
              {2, 0x96B856A6, 0xA64F94BB},
              {25, 0xBF8903A3, 0x92D87BF3},
              {50, 0x97051FC6, 0xADDCEDB5}};
    for (size_t k = 0; k < 4; k++) {
        fill(ORR_GEN_E1B, e1[k].number);
        assert_int_equal(bits(0, 32), e1[k].b);
        fill(ORR_GEN_E1C, e1[k].number);
        assert_int_equal(bits(0, 32), e1[k].c);
    }
    for (unsigned k = 1; k <= 50; k++) // memory codes are balanced to a few chips and repeat nowhere
        for (int c = 0; c < 2; c++) {
            fill(c ? ORR_GEN_E1C : ORR_GEN_E1B, k);
            assert_true(labs(sum(4092)) <= 32);
            for (size_t lag = 1; lag < 4092; lag += 131) assert_true(labs(correlation(4092, lag)) < 400);
        }
    assert_false(orr_gen_code_fill(ORR_GEN_E1B, 51, chips));
}

// BDS-SIS-ICD-B1C-1.0 tables 5-2, 5-3: first and last 24 chips, octal.
static void b1c(void **state)
{
    (void)state;
    static const uint32_t data[63][2] = {
        {053773116, 042711657}, {032235341, 017306122}, {017633713, 001145221}, {041551514, 005307430},
        {017205134, 046341377}, {004254545, 060604443}, {070663435, 050500234}, {016701045, 027476454},
        {032132263, 070555612}, {025432015, 043004057}, {031711760, 007100551}, {025604267, 015703521},
        {065705054, 012615632}, {024700370, 014267226}, {072405456, 025330122}, {002621063, 015741134},
        {000506754, 062665617}, {044317266, 007251312}, {014463723, 026526763}, {070234110, 033737311},
        {062002462, 034564677}, {052312612, 030142557}, {034500023, 052015335}, {077312776, 056550366},
        {003712305, 004531416}, {002501573, 000717773}, {066632544, 065070030}, {000447425, 065742570},
        {050643132, 047674377}, {075652754, 045534064}, {040610704, 003636755}, {060523643, 052040645},
        {030522043, 036645510}, {006337743, 054551553}, {041375664, 026065254}, {020200053, 003373656},
        {022017103, 015754234}, {067327102, 036032344}, {007154144, 000456573}, {045367715, 020772116},
        {046775773, 004657766}, {037123271, 011652043}, {034054132, 063673657}, {036632600, 006140620},
        {043776172, 042103455}, {013675272, 071143561}, {053755564, 007122624}, {060621674, 032065524},
        {022415634, 047205733}, {037363473, 071732000}, {077262176, 011057010}, {057132462, 060447016},
        {013314107, 077551540}, {054474504, 054256322}, {076023074, 061777241}, {060652454, 037175533},
        {031371623, 000254400}, {052134040, 051277171}, {041013755, 057767521}, {020323763, 060063316},
        {052445270, 012771226}, {050735662, 051142373}, {027571255, 047160627},
    };
    static const uint32_t pilot[63][2] = {
        {071676756, 013053205}, {060334021, 046604773}, {024562714, 060007065}, {061011650, 023616424},
        {067337730, 066243127}, {023762642, 033630334}, {025365366, 043456307}, {057226722, 076521063},
        {072643175, 052465264}, {000236125, 076142064}, {012071371, 060232627}, {061136116, 005607727},
        {036261215, 077737367}, {013607013, 016031533}, {031010541, 055416670}, {073163062, 033076260},
        {030250537, 073355574}, {056226421, 042437243}, {026205736, 066470710}, {002450570, 054366756},
        {066511327, 023666556}, {006323465, 074622250}, {010633350, 016402734}, {010544206, 054230354},
        {043714115, 037167223}, {055641056, 056136734}, {026572456, 062211315}, {075123401, 040615033},
        {070041254, 063213062}, {053034467, 003066540}, {050733517, 030062510}, {073077145, 034360276},
        {055454316, 045431517}, {037137206, 047647044}, {045724432, 033773217}, {055560467, 077620561},
        {013467065, 017327352}, {024245150, 062223375}, {022265044, 067665257}, {010003471, 027515010},
        {036537736, 037705710}, {057706617, 076736116}, {076411007, 077202566}, {061643153, 025334277},
        {050125760, 070220333}, {066657234, 022376763}, {001350500, 031043217}, {043621551, 020166102},
        {042435620, 016423062}, {074327566, 031245527}, {044553226, 037160613}, {052231514, 003414402},
        {046576047, 004003162}, {046312270, 054703562}, {004717127, 025225202}, {050407031, 031643432},
        {010044104, 027063234}, {036610123, 040756155}, {073470741, 024774305}, {024072445, 051507057},
        {007765425, 012225744}, {032242545, 062104320}, {003210227, 056250500},
    };
    for (unsigned k = 0; k < 63; k++) {
        fill(ORR_GEN_B1C_DATA, k + 1);
        assert_int_equal(bits(0, 24), data[k][0]);
        assert_int_equal(bits(10206, 24), data[k][1]);
        fill(ORR_GEN_B1C_PILOT, k + 1);
        assert_int_equal(bits(0, 24), pilot[k][0]);
        assert_int_equal(bits(10206, 24), pilot[k][1]);
    }
}

// BDS-SIS-ICD-B2a-1.0 tables 5-2, 5-3: first and last 24 chips, octal.
static void b2a(void **state)
{
    (void)state;
    static const struct {
        orr_gen_code code;
        unsigned prn;
        uint32_t first, last;
    } row[] = {{ORR_GEN_B2A_DATA, 1, 026771056, 042646672},
               {ORR_GEN_B2A_DATA, 2, 064771737, 043261240},
               {ORR_GEN_B2A_DATA, 63, 055037136, 006147764},
               {ORR_GEN_B2A_PILOT, 1, 026772435, 005133452},
               {ORR_GEN_B2A_PILOT, 63, 025236023, 001076040}};
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        fill(row[k].code, row[k].prn);
        assert_int_equal(bits(0, 24), row[k].first);
        assert_int_equal(bits(10206, 24), row[k].last);
    }
}

// BDS-SIS-ICD-B1I-3.0 4.3: balanced Gold codes of 2047 chips less the last. The document prints no chips of theirs; the three values
// of a Gold code's correlation, of the untruncated code, hold within what the lost chip can change.
static void b1i(void **state)
{
    (void)state;
    for (unsigned prn = 1; prn <= 63; prn++) {
        fill(ORR_GEN_B1I, prn);
        assert_true(labs(sum(2046)) <= 2);
        for (size_t lag = 1; lag < 40; lag++) {
            long c = 0; // aperiodic tail left out
            for (size_t k = 0; k + lag < 2046; k++) c += chips[k] * chips[k + lag];
            assert_true(labs(c) < 65 + 4 * 40);
        }
    }
    assert_true(orr_gen_b1i_is_d2(5) && !orr_gen_b1i_is_d2(6) && orr_gen_b1i_is_d2(59) &&
                !orr_gen_b1i_is_d2(58));
}

static void secondary(void **state)
{
    (void)state;
    int8_t s[ORR_GEN_SECONDARY_LARGEST];
    assert_int_equal(orr_gen_secondary_fill(ORR_GEN_L1CA, 1, s), 1);
    assert_int_equal(s[0], 1);
    static const struct {
        orr_gen_code code;
        const char *text;
    } row[] = {{ORR_GEN_L5I, "0000110101"},                // IS-GPS-705J 3.3.2.2
               {ORR_GEN_L5Q, "00000100110101001110"},      // 3.3.2.3
               {ORR_GEN_B1I, "00000100110101001110"},      // BDS-SIS-ICD-B1I-3.0 5.1.2
               {ORR_GEN_B2A_DATA, "00010"},                // BDS-SIS-ICD-B2a-1.0 5.2.2
               {ORR_GEN_E1C, "0011100000001010110110010"}, // Galileo OS SIS ICD 2.1 3.5.1
               {ORR_GEN_E5AI, "10000100001011101001"}};    // 842E9
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        assert_int_equal(orr_gen_secondary_fill(row[k].code, 3, s), strlen(row[k].text));
        for (size_t i = 0; row[k].text[i] != 0; i++) assert_int_equal(s[i], row[k].text[i] == '1' ? -1 : 1);
    }
    assert_int_equal(orr_gen_secondary_fill(ORR_GEN_E5AQ, 7, s), 100);
    unsigned long head = 0;
    for (size_t i = 0; i < 28; i++) head = head << 1 | (s[i] < 0);
    assert_int_equal(head, 0x537785D); // CS100_7 = 537785DE...
    assert_int_equal(orr_gen_secondary_fill(ORR_GEN_E5AQ, 51, s), 0);
    assert_int_equal(orr_gen_secondary_fill(ORR_GEN_B1C_PILOT, 1, s), 1800);
    assert_int_equal(orr_gen_secondary_fill(ORR_GEN_B2A_PILOT, 63, s), 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ca_first_chips),
        cmocka_unit_test(l5_first_chips),
        cmocka_unit_test(l2c_end_states),
        cmocka_unit_test(glonass),
        cmocka_unit_test(galileo),
        cmocka_unit_test(b1c),
        cmocka_unit_test(b2a),
        cmocka_unit_test(b1i),
        cmocka_unit_test(secondary),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
