/** What a scene tells of itself. */

import { tr } from "../../../view/language.js";

export const ASK_FIRST = tr("Make your prediction and lock it first.");
export const LIVE = tr("live: Python computes in this page");
export const NOT_STARTED = tr("Python could not start.");
export const STILL_PLAYS = tr("The prepared run still plays; values cannot be changed.");
export const NOT_SHOWN = tr("Your prediction is kept; the run cannot be shown.");
export const PREDICTION_KEPT = tr("Your prediction is kept.");
