/** Measures every method of a scene in this browser, row by row, until it is done or left. */

import { told, tr } from "../../../view/language.js";
import { need, say } from "../shared/dom.js";
import { refusal } from "../shared/waiting.js";

/** @typedef {import("../../../view/cost/figure.js").CostRow} CostRow */
/**
 * @typedef {{going: () => boolean, rows: (rows: CostRow[]) => void,
 *   refused: (method: string, reason: string) => void,
 *   tell: (floor: number, digits: Record<string, number>) => void}} Watching
 */

export const ADAPTIVE = ["rk45", "adaptive"]; // they have a tolerance in place of a step
export const PACKAGES = ["numpy", "scipy"]; // for the methods that choose their steps

/**
 * Whether it came to its end; raises what Python refuses.
 * @param {import("../runtime/client.js").Client} client @param {HTMLElement} root @param {object | undefined} scene
 * @param {Watching} watching @returns {Promise<boolean>}
 */
export async function measureAll(client, root, scene, { going, rows, refused, tell }) {
  const ask = async (/** @type {object} */ what) => {
    const request = () => ({ kind: "cost", scene, ...what });
    const { header } = await client.ask(need(root, ".carts-cost-go"), request);
    if (going() && !header.ok) throw refusal(header.problems ?? []);
    return /** @type {any} */ (header);
  };
  await client.need(PACKAGES);
  /** @type {CostRow[]} */
  const found = [];
  for (let row = 0, of = 1; row < of; row += 1) {
    if (!going()) return false;
    const answer = await ask({ row });
    if (!going()) return false;
    of = answer.of;
    found.push(...answer.rows);
    rows(found);
    if (answer.not_run) refused(answer.not_run.method, told(answer.not_run.reason));
    const progress = /** @type {HTMLProgressElement} */ (need(root, ".carts-cost-progress"));
    progress.value = (row + 1) / of;
    say(
      need(root, ".carts-cost-say"),
      tr("{done} of {all} runs measured", { done: row + 1, all: of }),
    );
  }
  const { floor, digits } = await ask({ digits: found });
  if (going()) tell(floor, digits);
  return going();
}
