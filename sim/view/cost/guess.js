/**
 * A guess before the figure: who gets to an error with the least time, and how much that is. What
 * comes out is read from the rows that were measured, so a guess can be made again for another scene.
 */

import { joined, tr } from "../language.js";
import { html } from "../markup.js";
import { short, superscript } from "../numbers.js";
import { METHODS, stepping } from "./methods.js";

/** @typedef {import("./figure.js").CostRow} CostRow */

/** m/s */
export const ASKED = [1e-2, 1e-4, 1e-6, 1e-9, 1e-12];
const FIRST = 1e-6;

/** @param {number} error m/s */
const errorText = (error) => `10${superscript(Math.round(Math.log10(error)))} m/s`;

/** @returns {import("../markup.js").Markup} the form; a script takes it away when it was answered */
export function guess() {
  const errors = ASKED.map(
    (error) =>
      html`<option value=${error}${error === FIRST && html` selected`}>${errorText(error)}</option>`,
  );
  const methods = stepping().map(
    (name) => html`<option value=${name}>${METHODS[name]?.label}</option>`,
  );
  const none = html`<option value="">${tr("choose")}</option>`;
  return html`<div class="carts-cost-guess" role="group" aria-label=${tr("your guess")} hidden>
<p>${tr("Say first how right you want it.")} <label>${tr("Velocities wrong by at most")} <select autocomplete="off" class="carts-cost-error">${errors}</select></label>
<label>${tr("Which method gets there in the least time?")} <select autocomplete="off" class="carts-cost-bet">${none}${methods}</select></label>
<label>${tr("How many times as long as the exact outcome?")} <input class="carts-cost-times carts-number" type="text" inputmode="numeric" size="6" autocomplete="off"></label></p>
<p class="carts-cost-answer"><button type="button" class="carts-button carts-cost-show">${tr("Show")}</button> <button type="button" class="carts-button carts-cost-skip">${tr("Show without a guess")}</button> <span class="carts-cost-verdict" role="status"></span></p>
</div>`;
}

/** The cheapest measured row of a method that is right enough. @param {CostRow[]} rows @param {string | null} method null: any that steps @param {number} error m/s */
function cheapest(rows, method, error) {
  const names = method === null ? stepping() : [method];
  return rows
    .filter((row) => names.includes(row.method) && row.error_v !== null && row.error_v <= error)
    .sort((a, b) => a.time_ratio - b.time_ratio)[0];
}

/** @param {CostRow[]} rows @param {{error: number, bet: string, times: number}} said `times` NaN: nothing was typed */
export function verdict(rows, { error, bet, times }) {
  const best = cheapest(rows, null, error);
  const label = (/** @type {string} */ name) => METHODS[name]?.label ?? name;
  const exact = errorText(error);
  if (!best)
    return tr("No method that steps was measured to be right to {error}.", { error: exact });
  const first = tr("For {error}: {method}, {ratio} times as long as the exact outcome.", {
    error: exact,
    method: label(best.method),
    ratio: short(best.time_ratio, 2),
  });
  const parts = [
    first,
    bet && ofChoice(label(bet), bet === best.method, cheapest(rows, bet, error)),
  ];
  if (Number.isFinite(times)) parts.push(tr("You said {ratio} times.", { ratio: short(times) }));
  return joined(parts);
}

/** @param {string} method in words @param {boolean} best @param {CostRow | undefined} own its cheapest row that is right enough */
function ofChoice(method, best, own) {
  if (best) return tr("As you said.");
  if (!own) {
    return tr("Your choice, {method}, does not get there with the steps that were measured.", {
      method,
    });
  }
  return tr("Your choice, {method}: {ratio} times as long.", {
    method,
    ratio: short(own.time_ratio, 2),
  });
}
