// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/generator/feed/navigation.h"

#include <stdlib.h>
#include <string.h>

#include "src/generator/feed/subscription.h"

#define NS_PER_S 1000000000
#define FRAME_NS (30 * (int64_t)NS_PER_S) // where nobody says how long frames are
#define EVERY_MESSAGE                                                                                        \
    (ORR_MSG_NAV_MESSAGES_LNAV | ORR_MSG_NAV_MESSAGES_CNAV | ORR_MSG_NAV_MESSAGES_CNV1 |                     \
     ORR_MSG_NAV_MESSAGES_CNV2 | ORR_MSG_NAV_MESSAGES_CNV3 | ORR_MSG_NAV_MESSAGES_INAV |                     \
     ORR_MSG_NAV_MESSAGES_FNAV | ORR_MSG_NAV_MESSAGES_D1 | ORR_MSG_NAV_MESSAGES_D2 |                         \
     ORR_MSG_NAV_MESSAGES_FDMA | ORR_MSG_NAV_MESSAGES_SBAS)
#define CREDIT 4 // answers on the way
#define KEPT_NS (60 * (int64_t)NS_PER_S)
#define PAGES 256   // of a message, held at once
#define BYTES 256   // of a page's symbols
#define MESSAGES 12 // of a satellite

typedef struct page {
    int64_t t_ns, length_ns; // the k-th of n symbols begins at t + k length / n
    uint16_t n;
    uint8_t symbol[BYTES]; // as on the wire, the first the highest bit
} page;

// One message of a satellite, which one or more signals carry with the same bits.
typedef struct message {
    uint8_t kind;
    char names[17];   // of those signals, as NAVDATA has them
    uint64_t signals; // places in service->signal, a bit each
    size_t n;
    int64_t begin_ns[PAGES]; // in order
    page *page[PAGES];       // likewise
} message;

typedef struct satellite {
    message *message[MESSAGES];
} satellite;

struct orr_gen_navigation {
    orr_gen_link *link;
    const orr_gen_service *service;
    orr_gen_subscription stream;
    bool polls;               // the service knows no streams
    int64_t until_ns;         // pages are held up to there
    int64_t forget_before_ns; // and not those that ended before this
    size_t used;              // answers that came since credit was given
    orr_gen_fault fault;      // why one could not be kept
    satellite sat[128][100];
};

static void free_message(message *m)
{
    if (m == NULL) return;
    for (size_t k = 0; k < m->n; k++) free(m->page[k]);
    free(m);
}

void orr_gen_navigation_close(orr_gen_navigation *navigation)
{
    if (navigation == NULL) return;
    for (size_t k = 0; k < 128; k++)
        for (size_t n = 0; n < 100; n++)
            for (size_t m = 0; m < MESSAGES; m++) free_message(navigation->sat[k][n].message[m]);
    free(navigation);
}

static int bit(const uint8_t *data, size_t k) { return data[k / 8] >> (7 - k % 8) & 1; }

// How many pages begin at or before an instant.
static size_t begun(const message *m, int64_t t_ns)
{
    size_t low = 0, high = m->n;
    while (low < high) {
        const size_t middle = (low + high) / 2;
        if (m->begin_ns[middle] <= t_ns)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static void drop_first(message *m)
{
    free(m->page[0]);
    m->n--;
    memmove(m->page, m->page + 1, m->n * sizeof(page *));
    memmove(m->begin_ns, m->begin_ns + 1, m->n * sizeof m->begin_ns[0]);
}

// The place of a page: that of the same instant, else a new one in order. NULL where there is no memory.
static page *place(message *m, int64_t t_ns)
{
    const size_t k = begun(m, t_ns);
    if (k > 0 && m->begin_ns[k - 1] == t_ns) return m->page[k - 1];
    if (m->n == PAGES) {
        drop_first(m);
        return place(m, t_ns);
    }
    page *p = calloc(1, sizeof *p);
    if (p == NULL) return NULL;
    memmove(m->page + k + 1, m->page + k, (m->n - k) * sizeof(page *));
    memmove(m->begin_ns + k + 1, m->begin_ns + k, (m->n - k) * sizeof m->begin_ns[0]);
    m->page[k] = p;
    m->begin_ns[k] = t_ns;
    m->n++;
    return p;
}

static bool keep_page(const orr_msg_nav_page *p, page *out, orr_gen_fault *fault)
{
    if (p->data.size > BYTES || (size_t)p->data.size * 8 < p->bits || p->bits == 0 || p->length <= 0)
        return orr_gen_fail(fault, "NAVDATA: a page of %u symbols in %zu bytes does not fit", p->bits,
                            (size_t)p->data.size);
    memcpy(out->symbol, p->data.data, p->data.size);
    out->t_ns = p->t;
    out->n = p->bits;
    out->length_ns = p->length;
    return true;
}

// Places in service->signal of signals that are named, divided by blanks.
static uint64_t carriers(const orr_gen_service *s, char system, orr_wire_bytes names)
{
    uint64_t mask = 0;
    for (size_t k = 0; k < s->n_signals; k++) {
        const size_t length = strlen(s->signal[k].name);
        for (size_t at = 0; s->signal[k].system == system && at + length <= names.size; at++)
            if (memcmp(names.data + at, s->signal[k].name, length) == 0 &&
                (at == 0 || names.data[at - 1] == ' ') &&
                (at + length == names.size || names.data[at + length] == ' '))
                mask |= (uint64_t)1 << k;
    }
    return mask;
}

static bool keep(orr_gen_navigation *v, const orr_msg_sat_navdata *d, orr_gen_fault *fault)
{
    if (d->answer != ORR_MSG_ANSWER_OK || d->message == ORR_MSG_NAV_MESSAGE_NONE) return true;
    if (d->sat.system >= 128 || d->sat.number >= 100) return true;
    satellite *s = &v->sat[d->sat.system][d->sat.number];
    size_t m = 0;
    char names[17];
    orr_wire_text_copy(d->signals, names, sizeof names);
    while (m < MESSAGES && s->message[m] != NULL &&
           (s->message[m]->kind != d->message || strcmp(s->message[m]->names, names) != 0))
        m++;
    if (m == MESSAGES) return true;
    if (s->message[m] == NULL) {
        s->message[m] = calloc(1, sizeof **s->message);
        if (s->message[m] == NULL) return orr_gen_fail(fault, "out of memory");
        s->message[m]->kind = d->message;
        memcpy(s->message[m]->names, names, sizeof names);
        s->message[m]->signals = carriers(v->service, (char)d->sat.system, d->signals);
    }
    orr_msg_nav_page p;
    orr_wire_iter it = {0};
    while (orr_msg_nav_page_next(&d->pages, &it, &p)) {
        page *out = place(s->message[m], p.t);
        if (out == NULL) return orr_gen_fail(fault, "out of memory");
        if (!keep_page(&p, out, fault)) return false;
    }
    while (s->message[m]->n > 0 &&
           s->message[m]->begin_ns[0] + s->message[m]->page[0]->length_ns < v->forget_before_ns)
        drop_first(s->message[m]);
    return true;
}

// All of an answer, which is held until the first of its frames ends.
static bool keep_answer(orr_gen_navigation *v, const orr_msg_navdata *m, orr_gen_fault *fault)
{
    int64_t until = m->epoch.t + FRAME_NS;
    orr_msg_sat_navdata d;
    orr_wire_iter it = {0};
    while (orr_msg_sat_navdata_next(&m->satellites, &it, &d)) {
        if (!keep(v, &d, fault)) return false;
        if (d.answer == ORR_MSG_ANSWER_OK && d.frame_to > m->epoch.t && d.frame_to < until)
            until = d.frame_to;
    }
    v->until_ns = until;
    return true;
}

static bool keep_frame(void *user, const orr_frame *f)
{
    orr_gen_navigation *v = user;
    orr_msg_navdata m;
    if (orr_msg_navdata_decode(f->payload, f->size, &m) != ORR_WIRE_OK)
        return orr_gen_fail(&v->fault, "an answer of the stream of navigation data cannot be read");
    v->used++;
    return keep_answer(v, &m, &v->fault);
}

bool orr_gen_navigation_open(orr_gen_link *link, const orr_gen_service *service,
                             orr_gen_navigation **navigation, orr_gen_fault *fault)
{
    orr_gen_navigation *v = calloc(1, sizeof *v);
    *navigation = v;
    if (v == NULL) return orr_gen_fail(fault, "out of memory");
    v->link = link;
    v->service = service;
    v->stream = (orr_gen_subscription){.link = link,
                                       .request = ORR_MSG_TYPE_POLL_NAVDATA,
                                       .answer = ORR_MSG_TYPE_NAVDATA,
                                       .keep = keep_frame,
                                       .user = v};
    v->until_ns = INT64_MIN;
    return true;
}

// From the end of what is held on: step 0 gives every frame once.
static orr_wire_status subscribe(orr_gen_navigation *v)
{
    uint8_t payload[64]; // satellites are not named: all
    orr_wire_writer w = {.data = payload, .capacity = sizeof payload};
    const orr_msg_poll_navdata poll = {
        .epochs = {v->until_ns, 0, 0}, .kinds = EVERY_MESSAGE, .form = ORR_MSG_NAV_FORM_SYMBOLS};
    const orr_wire_status ws = orr_msg_poll_navdata_encode(&poll, &w);
    v->used = 0;
    return ws == ORR_WIRE_OK ? orr_gen_subscribe(&v->stream, &w, CREDIT) : ws;
}

static orr_wire_status listen_to_stream(orr_gen_navigation *v)
{
    if (!orr_gen_subscribed(&v->stream)) return subscribe(v);
    const size_t used = v->used;
    v->used = 0;
    const orr_wire_status ws = orr_gen_subscription_credit(&v->stream, used);
    return ws == ORR_WIRE_OK ? orr_gen_subscription_wait(&v->stream) : ws;
}

static orr_wire_status ask(orr_gen_navigation *v, orr_gen_fault *fault)
{
    orr_client *c = orr_gen_link_client(v->link);
    const orr_msg_poll_navdata poll = {
        .epochs = {v->until_ns, 0, 1}, .kinds = EVERY_MESSAGE, .form = ORR_MSG_NAV_FORM_SYMBOLS};
    orr_msg_navdata m;
    orr_wire_status ws = orr_client_poll_navdata(c, &poll);
    if (ws == ORR_WIRE_OK) ws = orr_client_navdata(c, &m);
    return ws != ORR_WIRE_OK || keep_answer(v, &m, fault) ? ws : ORR_WIRE_SPACE;
}

bool orr_gen_navigation_cover(orr_gen_navigation *navigation, int64_t from_ns, int64_t to_ns,
                              orr_gen_fault *fault)
{
    orr_gen_navigation *v = navigation;
    if (!v->service->has_navdata) return true;
    if (v->until_ns < from_ns - FRAME_NS) v->until_ns = from_ns - FRAME_NS;
    if (v->until_ns < v->service->navdata.first) v->until_ns = v->service->navdata.first;
    v->forget_before_ns = from_ns - KEPT_NS;
    while (v->until_ns < to_ns && v->until_ns <= v->service->navdata.last && !v->stream.ended) {
        v->fault.text[0] = '\0';
        const orr_wire_status ws = v->polls ? ask(v, &v->fault) : listen_to_stream(v);
        if (!v->polls && orr_gen_no_streams(&v->stream, ws)) {
            v->polls = true;
            continue;
        }
        if (v->fault.text[0] != '\0') {
            *fault = v->fault;
            return false;
        }
        if (ws != ORR_WIRE_OK &&
            !orr_gen_link_again(v->link, ws, v->polls ? "POLL_NAVDATA" : "SUBSCRIBE", fault))
            return false;
    }
    return true;
}

static int symbol_of(const message *m, int64_t sent_ns)
{
    const size_t k = begun(m, sent_ns);
    if (k == 0) return 0;
    const page *p = m->page[k - 1];
    if (sent_ns >= p->t_ns + p->length_ns) return 0;
    return bit(p->symbol, (size_t)((sent_ns - p->t_ns) * p->n / p->length_ns)) ? -1 : 1;
}

int orr_gen_navigation_symbol(const orr_gen_navigation *navigation, size_t signal, char system,
                              unsigned number, int64_t sent_ns)
{
    if (number >= 100) return 0;
    const satellite *s = &navigation->sat[(unsigned char)system & 127][number];
    for (size_t m = 0; m < MESSAGES && s->message[m] != NULL; m++)
        if (s->message[m]->signals >> signal & 1) return symbol_of(s->message[m], sent_ns);
    return 0;
}
