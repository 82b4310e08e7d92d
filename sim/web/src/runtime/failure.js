// Every way in which Python can fail to start, and what the reader is told.

import { tr } from "../../../view/language.js";
import { isOnWeb } from "./line.js";

/** @typedef {"not-packed" | "payload-missing" | "payload-damaged" | "no-wasm" | "wasm-refused" | "no-memory" | "no-worker" | "too-old" |
 *   "worker-refused" | "worker-lost" | "snapshot-refused" | "python-failed" | "request-failed" | "stalled" | "stopped"} Reason */

/** @type {Record<Reason, string>} */
const MESSAGES = {
  "not-packed": tr("This page was built without Python. It shows only the runs that came with it."),
  "payload-missing": tr(
    "A file of this page is missing, so Python can't start. Copy the whole folder again.",
  ),
  "payload-damaged": tr(
    "A file of this page is damaged, so Python can't start. Copy the whole folder again.",
  ),
  "no-wasm": tr(
    "This browser has no WebAssembly, so Python can't start here. Try another browser.",
  ),
  "wasm-refused": tr(
    "This browser, or the rules of this network, do not allow Python to start. Try another browser.",
  ),
  "too-old": tr(
    "This browser is too old to run Python. Try Chrome or Edge 103, Firefox 113, Safari 16.4, or newer.",
  ),
  "no-memory": tr(
    "This computer has too little memory free for Python. Close other programs and load the page again.",
  ),
  "no-worker": tr("This browser has no workers, so Python can't start here. Try another browser."),
  "worker-refused": tr("This browser does not let the page start Python. Try another browser."),
  "worker-lost": tr("Python stopped. It may have run out of memory."),
  "snapshot-refused": tr("Python could not start the quick way."),
  "python-failed": tr(
    "Python could not start. Copy the whole folder again or try another browser.",
  ),
  "request-failed": tr("This cannot be computed with these values."),
  stalled: tr("Python does not answer. Close other programs and load the page again."),
  stopped: tr("Python was stopped."),
};

const CAME_NOT = tr("The network was interrupted, or this site was renewed: load the page again.");

/** What is told otherwise on a page of a web server: there is no folder to copy. @type {Partial<Record<Reason, string>>} */
const ON_WEB = {
  "payload-missing": CAME_NOT,
  "payload-damaged": CAME_NOT,
  "python-failed": tr("Python could not start. Load the page again, or try another browser."),
};

/** @param {Reason} reason */
const told = (reason) => (isOnWeb() && ON_WEB[reason]) || MESSAGES[reason];

/** An error whose message is for the reader, `reason` for the program, `detail` for the console. */
export class RuntimeFailure extends Error {
  /**
   * @param {Reason} reason
   * @param {string} [detail]
   * @param {string} [file] the payload that is missing or damaged
   */
  constructor(reason, detail = "", file = "") {
    super(told(reason) ?? told("python-failed"));
    this.name = "RuntimeFailure";
    this.reason = reason;
    this.detail = detail;
    this.file = file;
  }
}
