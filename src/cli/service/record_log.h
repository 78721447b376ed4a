// SPDX-License-Identifier: GPL-3.0-or-later
// The log that orrery record writes: eight bytes, the frame of the SUBSCRIBE, then the frames of the stream, all as on the wire.
#ifndef ORR_CLI_SERVICE_RECORD_LOG_H
#define ORR_CLI_SERVICE_RECORD_LOG_H

#define ORR_RECORD_MAGIC "ORRYLOG1"

#endif
