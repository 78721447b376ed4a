// SPDX-License-Identifier: GPL-3.0-or-later
// Group delays of single signals against the satellite clock of a precise product.
//
// The analysis centres' clocks are those of an ionosphere-free pair of code signals: C1W/C2W for GPS, C1P/C2P
// for GLONASS, C1C/C5Q (or C1X/C5X) for Galileo, C2I/C6I (or C2I/C7I) for BeiDou, C1C/C2L (or its relatives)
// for QZSS. A delay here is what one signal lags behind that pair; the pair's own combination has none, by
// definition. Bias files keep that only as far as their clocks do (CODE's to 1e-4 ns, GRG's, whose clocks are
// those of the phase, to 1 ns), so the combination of their values is taken away: with P = rho - c (dt -
// delay) a receiver of both signals of the pair sees the product's clock exactly.
//
// All delays are seconds, to be subtracted from the satellite's clock for a user of that signal alone, as TGD
// is (IS-GPS-200N 20.3.3.3.3.2). Signals are RINEX 3 codes without the leading letter ("1C", "2W", "5Q").
#ifndef ORR_ORBIT_SPACECRAFT_SIGNAL_DELAY_H
#define ORR_ORBIT_SPACECRAFT_SIGNAL_DELAY_H

#include "core/signal.h"
#include "ingest/tables/bias.h"
#include "orbit/broadcast/broadcast.h"

// Group delay of a signal from a bias file, of absolute (OSB) or differential (DSB, DCB) biases alike.
// Given:
//   bias     biases
//   sat      satellite
//   signal   RINEX 3 code without the leading letter, for example "1C"
//   t        instant; up to a day outside the file's span the value at its end is taken, since biases change by a tenth of
//            a nanosecond in weeks
// Returned:
//   delay_s  delay against the clock's pair, s
// Errors: ORR_E_NODATA where the file does not connect the signal with the clock's pair; ORR_E_ARG for a code of another
// length.
orr_status orr_signal_delay_osb(const orr_bias_set *bias, orr_sat sat, const char *signal, orr_time t,
                                double *delay_s);

// The same of a signal with all its components: files name them together ("1X") or one of them.
// Given:
//   bias     biases
//   sat      satellite
//   s        signal of its system
//   t        instant, as above
// Returned:
//   delay_s  delay against the clock's pair, s
// Errors: ORR_E_NODATA.
orr_status orr_signal_delay_of(const orr_bias_set *bias, orr_sat sat, const orr_signal *s, orr_time t,
                               double *delay_s);

// Phase bias of a signal from a bias file, of the satellite's part of the carrier, against the same pair of code signals: to be
// subtracted from the satellite's clock for a user of the carrier, so that a receiver that takes the file's biases off finds
// whole cycles where its maker did.
// Given:
//   bias     biases
//   sat      satellite
//   s        signal; of several components any one's bias is taken
//   t        instant, as orr_signal_delay_osb
// Returned:
//   delay_s  bias, s
// Errors: ORR_E_NODATA where the file has no phase bias of it in seconds, or does not connect it with the clock's pair.
orr_status orr_signal_phase_of(const orr_bias_set *bias, orr_sat sat, const orr_signal *s, orr_time t,
                               double *delay_s);

// From a broadcast record. Its clock may be that of other signals than the product's: Galileo I/NAV's is of
// E1/E5b, BeiDou's of B3I, GLONASS' of L1; the record's own delays bridge the two. ORR_E_NODATA where it does
// not tell.
orr_status orr_signal_delay_broadcast(const orr_nav_eph *eph, const char *signal, double *delay_s);
// What has to be added to the clock of a broadcast record for that of the product's pair. ORR_E_NODATA as
// above.
orr_status orr_signal_broadcast_to_product(const orr_nav_eph *eph, double *shift_s);

// TGD as GPS and QZSS send it: the delay of L1 of the clock's pair, (b1 - b2) / (1 - gamma), gamma =
// (f1/f2)^2. ORR_E_NODATA for other systems, and where the file does not tell.
orr_status orr_signal_tgd(const orr_bias_set *bias, orr_sat sat, orr_time t, double *tgd_s);

// What GLONASS' message sends of its group delays.
// Given:
//   bias              biases
//   sat               GLONASS satellite
//   t                 instant
// Returned:
//   l1_clock_shift_s  to be added to the product's clock for the clock of L1, s
//   delta_tau_s       by how much L2 lags behind L1, b2 - b1, s
// Errors: ORR_E_NODATA.
// Notes: of the open signals where the file has them, of the P signals otherwise.
// Reference: GLONASS ICD L1/L2 edition 5.1, 2008, 4.4.
orr_status orr_signal_glonass(const orr_bias_set *bias, orr_sat sat, orr_time t, double *l1_clock_shift_s,
                              double *delta_tau_s);

#endif
