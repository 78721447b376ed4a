// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in for libFuzzer where a test replays seeds: every file of the folders named, as it is, and
// with a fixed set of mutations: those by bytes below, and as many of the target's own where it has some (mutate_*.c); of folders behind
// --as-it-is without mutations. Nothing is judged here; a fault ends the program (under the sanitizers), a hang meets ctest's limit.
#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz/mutate.h"

#define MUTATIONS 150
#define MAX_SEED ((size_t)1 << 20)

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerInitialize(int *argc, char ***argv);

static uint64_t state;
static uint64_t next_random(void) // splitmix64
{
    uint64_t z = (state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

// One of: a byte changed, a stretch removed, a stretch doubled, a digit put in, the end cut.
static size_t mutate(uint8_t *p, size_t n, size_t capacity)
{
    static const uint8_t spice[] = "0123456789 -.EeDd&>\n\r\t\0\xff";
    if (n == 0) return 0;
    size_t at = (size_t)(next_random() % n), len = (size_t)(next_random() % 64) + 1;
    if (len > n - at) len = n - at;
    switch (next_random() % 5) {
    case 0:
        p[at] = (uint8_t)next_random();
        return n;
    case 1:
        memmove(p + at, p + at + len, n - at - len);
        return n - len;
    case 2:
        if (n + len > capacity) return n;
        memmove(p + at + len, p + at, n - at);
        return n + len;
    case 3:
        p[at] = spice[next_random() % (sizeof spice - 1)];
        return n;
    default:
        return at;
    }
}

size_t LLVMFuzzerMutate(uint8_t *data, size_t n, size_t most)
{
    return n == 0 || n > most / 2 ? n : mutate(data, n, most);
}

#ifndef ORR_FUZZ_STRUCTURED
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t n, size_t most, unsigned seed)
{
    (void)seed;
    return LLVMFuzzerMutate(data, n, most);
}
#endif

static int replay(const char *path, int mutations, size_t *n_run)
{
    static uint8_t seed[MAX_SEED], work[2 * MAX_SEED];
    FILE *f = fopen(path, "rb");
    if (f == NULL) return perror(path), 1;
    size_t n = fread(seed, 1, sizeof seed, f);
    fclose(f);
    LLVMFuzzerTestOneInput(seed, n);
    (*n_run)++;
    for (int i = 0; i < mutations; i++) {
        size_t m = n;
        memcpy(work, seed, n);
        for (uint64_t k = next_random() % 4; k < 4; k++)
            m = i % 2 == 0 ? mutate(work, m, sizeof work)
                           : LLVMFuzzerCustomMutator(work, m, sizeof work, (unsigned)next_random());
        LLVMFuzzerTestOneInput(work, m);
        (*n_run)++;
    }
    return 0;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

int main(int argc, char **argv)
{
    (void)LLVMFuzzerInitialize(&argc, &argv);
    size_t n_run = 0, n_files = 0;
    int bad = 0, mutations = MUTATIONS;
    for (int a = 1; a < argc; a++) {
        if (strcmp(argv[a], "--as-it-is") == 0) {
            mutations = 0;
            continue;
        }
        char *name[4096];
        size_t n = 0;
        DIR *d = opendir(argv[a]);
        if (d == NULL) return perror(argv[a]), 1;
        for (struct dirent *e; n < 4096 && (e = readdir(d)) != NULL;)
            if (e->d_name[0] != '.') name[n++] = strdup(e->d_name);
        closedir(d);
        qsort(name, n, sizeof name[0], compare_names); // the same order, so the same mutations, everywhere
        for (size_t i = 0; i < n; i++) {
            char path[4096];
            snprintf(path, sizeof path, "%s/%s", argv[a], name[i]);
            state = i;
            bad |= replay(path, mutations, &n_run);
            free(name[i]);
        }
        n_files += n;
    }
    printf("%zu seeds, %zu inputs\n", n_files, n_run);
    return bad || n_files == 0;
}
