// SPDX-License-Identifier: GPL-3.0-or-later
// What `orrery compare` says of the predicted part of a product.
#ifndef ORR_CLI_ORBIT_COMPARE_PREDICTION_H
#define ORR_CLI_ORBIT_COMPARE_PREDICTION_H

#include "orbit/judge/prediction.h"
#include "src/cli/frame/json.h"

// A table on standard output; nothing where nothing is predicted.
void compare_prediction_print(const orr_prediction_judgement *j);
// The value of the key "prediction": null where nothing is predicted.
json_t *compare_prediction_json(const orr_prediction_judgement *j);

#endif
