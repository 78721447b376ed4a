// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of all files of Earth rotation do with a line's values.
#include <math.h>

#include "core/vec.h"
#include "ingest/tables/erp_private.h"

orr_status erp_bad_date(erp_reader *r, double mjd)
{
    return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1, "%g is no modified Julian date", mjd);
}

orr_status erp_add_row(erp_reader *r, const erp_row *row)
{
    const double most = 2.0 / 3600 * ORR_RAD_PER_DEG;
    if (!(row->mjd > ERP_FIRST_MJD && row->mjd < ERP_LAST_MJD)) return erp_bad_date(r, row->mjd);
    if (!(fabs(row->eop.xp_rad) < most && fabs(row->eop.yp_rad) < most))
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1, "a pole more than two arc seconds off");
    if (fabs(row->eop.ut1_utc_s) > 1.0) // |UT1 - UTC| < 0.9 s by definition
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1, "UT1 - UTC of %.4f s cannot be",
                                row->eop.ut1_utc_s);
    orr_status s = orr_records_grow(&r->row, r->n, sizeof *r->row, r->limits.max_records,
                                    "lines of Earth rotation", &r->c, r->diag);
    if (s != ORR_OK) return s;
    r->row[r->n] = *row;
    r->row[r->n].order = r->n;
    r->n++;
    return ORR_OK;
}
