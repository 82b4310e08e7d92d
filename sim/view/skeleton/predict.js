/**
 * The question before the run. Works with pointer, keyboard and on paper. “autocomplete” is off because
 * Firefox would bring back after a reload what the page has forgotten.
 */

import { body, forceOn } from "../bodies.js";
import { tr } from "../language.js";
import { styleOf } from "../markers.js";
import { html } from "../markup.js";
import { STEP as APART, LEFT, POINTS, pad, path } from "../pad.js";
import { niceAbove } from "../scales.js";

/** @typedef {import("../types.js").Baked} Baked */
/** @typedef {import("../types.js").PredictSpec} PredictSpec */

const FULL = 10; // N, of the longest arrow where the scene has no scale of its own
const STEP = 0.05; // of the longest arrow that can be drawn, where no newtons are asked for
const CERTAINTY = /** @type {[string, string][]} */ ([
  ["guess", tr("a guess")],
  ["think", tr("I think so")],
  ["sure", tr("I am sure")],
]);
const TIMES = {
  contact: [
    tr("at first touch"),
    tr("after a quarter"),
    tr("in the middle"),
    tr("after three quarters"),
    tr("at the end"),
  ],
  run: [
    tr("at the start"),
    tr("after a quarter"),
    tr("in the middle"),
    tr("after three quarters"),
    tr("at the end"),
  ],
};
const KNOBS = Array.from({ length: POINTS }, (_, k) => k);

/** @type {Record<PredictSpec["kind"], (baked: Baked, spec: PredictSpec) => import("../markup.js").Markup>} */
const FORMS = { arrows, curve, choice, text };

/** @param {Baked} baked @param {PredictSpec} spec */
export function predict(baked, spec) {
  const { id } = baked.fence;
  const lock = spec.talk ? tr("Lock my prediction") : tr("Lock my prediction and show the run");
  return html`<div class="carts-predict" data-kind=${spec.kind} role="group" aria-labelledby="${id}-ask">
<p class="carts-heading">${tr("Predict first")}</p>
<p class="carts-ask" id="${id}-ask">${spec.ask}</p>
${FORMS[spec.kind](baked, spec)}
${spec.sure && certainty(id)}
<p class="carts-lock-row"><button type="button" class="carts-button carts-lock" disabled>${lock}</button> <span class="carts-saved" role="status"></span></p>
<p class="carts-error carts-predict-error" role="alert" hidden></p>
<div class="carts-talk" tabindex="-1" role="group" aria-label=${tr("Talk with your partner")} hidden><p><b>${tr("Locked.")}</b> ${tr("Now tell your partner what you expect, and why. Listen to the other reason too. You may change your prediction once; both are kept.")}</p><p class="carts-lock-row"><button type="button" class="carts-button carts-talk-change">${tr("Change it once")}</button> <button type="button" class="carts-button carts-talk-run">${tr("Keep it and show the run")}</button></p></div>
<div class="carts-compared" tabindex="-1" hidden></div>
<label class="carts-why" hidden>${tr("Explain: what did you see, and why is it so?")} <textarea rows="3" maxlength="20000" autocomplete="off" placeholder=" "></textarea></label>
<div class="carts-write" aria-hidden="true"><hr><hr><hr><hr></div>
<p class="carts-lock-row carts-again-row" hidden><button type="button" class="carts-button carts-again">${tr("Start again")}</button><span class="carts-forget" hidden>${tr("Forget this prediction and what was written below it?")} <button type="button" class="carts-button carts-forget-yes">${tr("Forget it")}</button> <button type="button" class="carts-button carts-forget-no">${tr("Keep it")}</button></span></p>
</div>`;
}

/** How sure the reader is. @param {string} id of the scene */
function certainty(id) {
  const label = tr("How sure are you?");
  const choices = CERTAINTY.map(
    ([word, says]) =>
      html`<label><input type="radio" autocomplete="off" name="${id}-sure" value=${word} disabled> ${says}</label> `,
  );
  return html`<p class="carts-certainty" role="radiogroup" aria-label=${label}><span>${label}</span> ${choices}</p>`;
}

/** A length for each force: a slider, and a box where it is asked for in newtons. @param {Baked} baked @param {PredictSpec} spec */
function arrows({ fence, view, run: { header } }, { pairs, scale }) {
  const numbers = scale === "newtons";
  const full = numbers ? view.force || FULL : 1;
  const step = numbers ? niceAbove(full / 100) : STEP;
  const asked = pairs.flatMap(([left, right]) => [
    { pair: `${left}-${right}`, on: left, by: right },
    { pair: `${left}-${right}`, on: right, by: left },
  ]);
  const rows = asked.map(({ pair, on, by }, k) => {
    const i = header.bodies.findIndex(({ name }) => name === on);
    const force = forceOn(body(on, header.track), body(by, header.track));
    const label = tr("{force}, length of the arrow", { force });
    const id = `${fence.id}-guess-${k + 1}`;
    return html`<div class="carts-guess carts-${i < 0 ? "wall" : styleOf(i)}" data-pair=${pair} data-on=${on}><label for=${id}>${force}</label><input type="range" autocomplete="off" min="0" max=${full} step=${step} value="0" aria-label=${label}${!numbers && html` id=${id}`} disabled>${numbers && html`<span class="carts-typed"><input type="text" class="carts-number-box" id=${id} inputmode="decimal" autocomplete="off" value="" disabled> <span class="carts-unit-text">N</span></span><p class="carts-error" hidden></p>`}</div>
`;
  });
  const how = tr(
    "Pull each arrow in the picture, or here, until it is as long as you think. Only which one is longer counts, not how many newtons.",
  );
  const paper = tr(
    "On paper: draw an arrow from each dot. The stronger you think the force is, the longer.",
  );
  return html`${!numbers && html`<p class="carts-quiet carts-pull-how">${how}</p>`}<p class="carts-quiet carts-draw-how">${paper}</p><div class="carts-guesses">
${rows}</div>${!numbers && html`<p class="carts-relation" role="status"></p>`}`;
}

/** A curve drawn by hand: five points over the time of the contact, or of the run. @param {Baked} baked @param {PredictSpec} spec */
function curve({ run: { header } }, { cart, quantity }) {
  const i = header.bodies.findIndex(({ name }) => name === cart);
  const place = pad(quantity);
  const knobs = KNOBS.map(
    (k) =>
      html`<circle class="carts-knob" data-index=${k} cx=${LEFT + APART * k} cy=${place.zero} r="7"/>`,
  );
  const mode = place.low < 0 ? "text" : "decimal"; // a phone's keys for decimals lack a minus
  const heights = TIMES[quantity === "F" ? "contact" : "run"].map(
    (name) =>
      html`<label>${name} <input type="text" class="carts-height" inputmode=${mode} autocomplete="off" disabled></label>`,
  );
  const flat = path(place, [0, 0, 0, 0, 0]);
  return html`<div class="carts-sketch">
<svg class="carts-pad" viewBox="0 0 360 170" width="360" height="170" aria-hidden="true"><path class="carts-grid" d="M40 10V130M40 130H350M117.5 10V130M195 10V130M272.5 10V130M350 10V130M40 70H350M40 10H350"/>${axes(quantity)}<path data-part="answer" class="carts-curve carts-${styleOf(Math.max(0, i))}" d=""/><path data-part="sketch" class="carts-sketch-line" d=${flat}/>${knobs}</svg>
<div class="carts-heights"><p>${quantity === "F" ? tr("Move the five points, or type heights from 0 to 10.") : tr("Move the five points, or type heights from −10 to 10: right is positive.")}</p>${heights}</div>
</div>`;
}

/** What the edges of the pad mean. @param {PredictSpec["quantity"]} quantity */
function axes(quantity) {
  if (quantity === "F")
    return html`<text x="40" y="147">${tr("touch")}</text><text x="350" y="147" text-anchor="end">${tr("apart")}</text><text x="195" y="164" text-anchor="middle">${tr("time during the contact")}</text><text class="carts-pad-up" x="34" y="16" text-anchor="end">${tr("large")}</text><text x="28" y="134" text-anchor="end">0</text>`;
  const middle = quantity === "v" ? tr("at rest") : tr("start");
  return html`<text data-way="1" x="46" y="24">${tr("to the right")}</text><text data-way="-1" x="46" y="126">${tr("to the left")}</text><text data-way="0" x="311" y="61" text-anchor="middle">${middle}</text><text x="195" y="164" text-anchor="middle">${tr("time from start to end")}</text>`;
}

/** @param {Baked} baked @param {PredictSpec} spec */
function choice({ fence: { id } }, { options }) {
  const rows = options.map(
    (option, k) =>
      html`<label><input type="radio" autocomplete="off" name="${id}-predict" value=${k} disabled> <span>${option}</span></label>`,
  );
  return html`<div class="carts-options" role="radiogroup" aria-labelledby="${id}-ask">${rows}</div>`;
}

/** @param {Baked} baked */
function text({ fence: { id } }) {
  return html`<textarea class="carts-words" rows="3" maxlength="20000" autocomplete="off" aria-labelledby="${id}-ask" disabled></textarea>`;
}
