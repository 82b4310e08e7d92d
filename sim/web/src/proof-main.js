/** Which digits are proved: loaded when a reader opens “How is this computed?”, and not before. */

import { Proof } from "./proof/proof.js";

/** @type {any} */ (globalThis).cartsProof = Proof;
