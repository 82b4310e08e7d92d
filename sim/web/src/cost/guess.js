/** The guess before the figure: until it was made, or passed over, the figure and the table wait. */

import { LEFT, RIGHT, yAt } from "../../../view/cost/figure.js";
import { verdict } from "../../../view/cost/guess.js";
import { tr } from "../../../view/language.js";
import { px } from "../../../view/numbers.js";
import { need, put, say } from "../shared/dom.js";
import { complain, ifTyped, numberIn } from "../shared/number-box.js";

/** @param {HTMLElement} root @param {() => import("../../../view/cost/figure.js").CostRow[]} rows those of the chosen scene @returns {() => void} forgets what was said of a guess */
export function guessFirst(root, rows) {
  const [form, known] = [need(root, ".carts-cost-guess"), need(root, ".carts-cost-known")];
  const error = /** @type {HTMLSelectElement} */ (need(root, ".carts-cost-error"));
  const bet = /** @type {HTMLSelectElement} */ (need(root, ".carts-cost-bet"));
  const times = /** @type {HTMLInputElement} */ (need(root, ".carts-cost-times"));
  const [told, line] = [need(root, ".carts-cost-verdict"), need(root, ".carts-cost-asked")];
  const skip = need(root, ".carts-cost-skip");
  form.hidden = false;
  known.hidden = true;
  const open = () => {
    known.hidden = false;
    skip.hidden = true;
  };
  skip.addEventListener("click", () => {
    open();
    need(root, ".carts-cost-show").focus();
  });
  need(root, ".carts-cost-show").addEventListener("click", () => {
    if (known.hidden && !bet.value) {
      say(told, tr("Choose a method first: a wrong guess is worth more than none."));
      return bet.focus();
    }
    const problem = ifTyped(times);
    complain(times, problem);
    if (problem) return times.focus();
    open();
    const asked = Number(error.value);
    const said = { error: asked, bet: bet.value, times: numberIn(times) ?? Number.NaN };
    say(told, verdict(rows(), said));
    put(line, "d", `M${LEFT} ${px(yAt(asked))}H${RIGHT}`);
  });
  return () => {
    say(told, "");
    put(line, "d", "");
  };
}
