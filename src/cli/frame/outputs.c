// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs never destroy inputs: what a command is told to write is looked at before it begins. An output that is an
// input, or another output, is refused by its inode, whatever it is called. An existing file that is read-only, or that
// Orrery did not write, is replaced with --force alone. A folder where nothing can be written is told at once.
#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/ncfile.h"
#include "core/path.h"
#include "src/cli/frame/frame.h"

enum { HEAD = 4096 };

// How text that Orrery writes begins, where it does not name its maker.
static const char *const beginnings[] = {"t_gps,",
                                         "sat,element,period_d,",
                                         "sat,penumbra_entry,",
                                         "t_s,dxi1_m,",
                                         "t_s,lat_deg,",
                                         "t_s,recovered_mgal,",
                                         "t_s,dtheta_x_rad,",
                                         "t_s,baro_height_m,",
                                         "cycle,t_s,stand_deg,",
                                         "seed,nees,",
                                         "seed,heading_error_arcsec,",
                                         "seed,crossovers,",
                                         "line_a,line_b,",
                                         "method,product_rad2ps,",
                                         "channel,tau_s,"};

static bool begins(const char *text, const char *with) { return strncmp(text, with, strlen(with)) == 0; }

// JSON of rows or of an object; its first key is one of ours.
static bool is_our_json(const char *text)
{
    if (text[0] != '[' && text[0] != '{') return false;
    text += strcspn(text, "\"]");
    return *text == ']' || begins(text, "\"t_gps\"") || begins(text, "\"sat\"");
}

static bool is_our_text(const char *text)
{
    if (strstr(text, "orrery") != NULL || strstr(text, "ORRERY") != NULL || is_our_json(text)) return true;
    for (size_t i = 0; i < sizeof beginnings / sizeof beginnings[0]; i++)
        if (begins(text, beginnings[i])) return true;
    return false;
}

// A receiver's bytes, RTCM 3 or UBX, that name their maker.
static bool is_our_stream(const char *head, size_t n)
{
    static const char maker[] = "ORRERY";
    if (n < sizeof maker || (memcmp(head, "\xd3", 1) != 0 && memcmp(head,
                                                                    "\xb5"
                                                                    "b",
                                                                    2) != 0))
        return false;
    for (size_t k = 0; k + strlen(maker) <= n; k++)
        if (memcmp(head + k, maker, strlen(maker)) == 0) return true;
    return false;
}

// Whether Orrery wrote the file, or it is empty; a file that cannot be read is somebody's.
static bool is_ours(const char *path)
{
    char head[HEAD + 1];
    FILE *f = fopen(path, "rb");
    if (f == NULL) return false;
    const size_t n = fread(head, 1, HEAD, f);
    const bool bad = ferror(f) != 0;
    fclose(f);
    head[n] = '\0';
    if (bad) return false;
    if (n == 0 || orr_nc_is_sealed(path)) return true;
    return is_our_stream(head, n) || (memchr(head, '\0', n) == NULL && is_our_text(head));
}

// One output: an option, the path that it was given or has by default, and what stands there.
typedef struct output {
    const orr_option *option;
    const char *path;
    bool exists;
    struct stat st, folder;
} output;

static bool same_file(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

// The folder of a path: whether a file can be made there.
static int look_at_folder(const orr_cli *c, output *o)
{
    char folder[4096] = ".";
    const size_t n = (size_t)(orr_base_name(o->path) - o->path);
    if (n >= sizeof folder) return orr_cli_failf(c, "%s: the name is too long", o->path);
    if (n > 0) snprintf(folder, sizeof folder, "%.*s", (int)n, o->path);
    if (stat(folder, &o->folder) != 0 || (!o->exists && access(folder, W_OK) != 0))
        return orr_cli_failf(c, "%s: cannot be written: %s", o->path, strerror(errno));
    return ORR_EXIT_OK;
}

static int meets_input(const orr_cli *c, const output *o, const char *input, const char *what)
{
    struct stat st;
    if (!o->exists || stat(input, &st) != 0 || !S_ISREG(st.st_mode) || !same_file(&st, &o->st))
        return ORR_EXIT_OK;
    return orr_cli_usage(c, "--%s %s would overwrite %s, which is read: name another file", o->option->name,
                         o->path, what);
}

static int check_inputs(const orr_cli *c, const output *o)
{
    for (int i = 0; i < c->n_operands; i++)
        if (meets_input(c, o, c->operand[i], c->operand[i]) != ORR_EXIT_OK) return ORR_EXIT_USAGE;
    for (size_t k = 0; k < c->command->n_options; k++) {
        const orr_option *in = &c->command->option[k];
        if (in->kind != ORR_OPT_TEXT || in->writes) continue;
        const size_t n = orr_cli_count(c, in->name);
        for (size_t i = 0; i < n; i++) {
            const char *path = orr_cli_text_at(c, in->name, i);
            if (meets_input(c, o, path, path) != ORR_EXIT_OK) return ORR_EXIT_USAGE;
        }
    }
    return ORR_EXIT_OK;
}

static int check_existing(const orr_cli *c, const output *o)
{
    if (!o->exists) return ORR_EXIT_OK;
    const bool force = orr_cli_given(c, "force"), read_only = (o->st.st_mode & 0222) == 0;
    if (!force && read_only) return orr_cli_failf(c, "%s: is read-only; --force replaces it", o->path);
    if (!force && !is_ours(o->path))
        return orr_cli_failf(c, "%s: is there already and was not written by Orrery; --force replaces it",
                             o->path);
    // A file that takes the place of a read-only one is begun with its rights, and needs that of writing.
    if (read_only && chmod(o->path, (o->st.st_mode & 0777) | 0200) != 0)
        return orr_cli_failf(c, "%s: cannot be replaced: %s", o->path, strerror(errno));
    return ORR_EXIT_OK;
}

int orr_cli_outputs_check(const orr_cli *c)
{
    enum { MOST = 8 };
    output list[MOST];
    int n = 0, status = ORR_EXIT_OK;
    if (orr_cli_n_common(c->command) < ORR_CLI_COMMON_OPTIONS) return ORR_EXIT_OK;
    bool writes = false;
    for (size_t i = 0; i < c->command->n_options && status == ORR_EXIT_OK && n < MOST; i++) {
        const orr_option *o = &c->command->option[i];
        writes = writes || o->fills;
        if (!o->writes) continue;
        const char *path = orr_cli_text(c, o->name, o->fallback);
        if (path == NULL) continue;
        writes = true;
        output *out = &list[n];
        *out = (output){.option = o, .path = path};
        if (strcmp(path, "-") == 0) continue;
        out->exists = stat(path, &out->st) == 0;
        if (out->exists && !S_ISREG(out->st.st_mode)) continue; // a device, a pipe: nothing to lose
        status = look_at_folder(c, out);
        for (int k = 0; k < n && status == ORR_EXIT_OK; k++)
            if ((out->exists && list[k].exists && same_file(&out->st, &list[k].st)) ||
                (same_file(&out->folder, &list[k].folder) &&
                 strcmp(orr_base_name(path), orr_base_name(list[k].path)) == 0))
                status =
                    orr_cli_usage(c, "--%s and --%s are one file, %s", list[k].option->name, o->name, path);
        if (status == ORR_EXIT_OK) status = check_inputs(c, out);
        if (status == ORR_EXIT_OK) status = check_existing(c, out);
        n++;
    }
    if (status == ORR_EXIT_OK && !writes && orr_cli_given(c, "force"))
        return orr_cli_usage(c, "--force has no effect without a file to write");
    return status;
}

// --- files that a scenario or a study names ---

typedef struct meeting {
    struct stat st;
    char with[4096]; // the file that is met
} meeting;

static bool apart(void *user, const char *path)
{
    meeting *m = user;
    struct stat st;
    if (stat(path, &st) != 0 || !S_ISREG(st.st_mode) || !same_file(&st, &m->st)) return true;
    snprintf(m->with, sizeof m->with, "%s", path);
    return false;
}

orr_status orr_cli_tree_check(const orr_cli *c, const orr_schema *schema, const void *base, orr_diag *diag)
{
    for (size_t i = 0; i < c->command->n_options; i++) {
        const orr_option *o = &c->command->option[i];
        const char *path = o->writes ? orr_cli_text(c, o->name, o->fallback) : NULL;
        meeting m = {.with = ""};
        if (path == NULL || strcmp(path, "-") == 0 || stat(path, &m.st) != 0) continue;
        if (!orr_schema_files(schema, base, apart, &m))
            return orr_diag_set(diag, ORR_E_ARG,
                                "--%s %s would overwrite %s, which %s names: name another file", o->name,
                                path, m.with, c->n_operands > 0 ? c->operand[0] : "its input");
    }
    return ORR_OK;
}

orr_status orr_cli_file_check(const orr_cli *c, const char *path, const orr_schema *schema, const void *base,
                              orr_diag *diag)
{
    meeting m = {.with = ""};
    if (stat(path, &m.st) != 0) return ORR_OK;
    bool free_of = true;
    for (int i = 0; i < c->n_operands; i++) free_of = free_of && apart(&m, c->operand[i]);
    if (!free_of || (schema != NULL && !orr_schema_files(schema, base, apart, &m)))
        return orr_diag_set(diag, ORR_E_ARG, "%s would overwrite %s, which is read: name another folder",
                            path, m.with);
    const bool force = orr_cli_given(c, "force"), read_only = (m.st.st_mode & 0222) == 0;
    if (!force && read_only)
        return orr_diag_set(diag, ORR_E_ARG, "%s: is read-only; --force replaces it", path);
    if (!force && !is_ours(path))
        return orr_diag_set(diag, ORR_E_ARG,
                            "%s: is there already and was not written by Orrery; --force replaces it", path);
    if (read_only && chmod(path, (m.st.st_mode & 0777) | 0200) != 0)
        return orr_diag_set(diag, ORR_E_IO, "%s: cannot be replaced: %s", path, strerror(errno));
    return ORR_OK;
}

static void warn_of(const orr_cli *c, const char *path)
{
    if (orr_nc_lacks_seal(path))
        orr_cli_failf(c, "warning: %s: has no seal of Orrery at its end, so that damage to it is not noticed",
                      path);
}

void orr_cli_seals_warn(const orr_cli *c)
{
    for (int i = 0; i < c->n_operands; i++) warn_of(c, c->operand[i]);
    for (size_t k = 0; k < c->command->n_options; k++) {
        const orr_option *o = &c->command->option[k];
        const size_t n = o->kind == ORR_OPT_TEXT && !o->writes ? orr_cli_count(c, o->name) : 0;
        for (size_t i = 0; i < n; i++) warn_of(c, orr_cli_text_at(c, o->name, i));
    }
}
