/** The picture of the world as it stands in the page: track, walls, ruler, and a place for all that moves. */

import { linkedPairs } from "../effects.js";
import { tr } from "../language.js";
import { styleOf } from "../markers.js";
import { html } from "../markup.js";
import { fixed, px, short, speedUnit } from "../numbers.js";
import { axisDecimals, niceAbove, ticks } from "../scales.js";
import { blockArrow, lineArrow } from "../shapes.js";
import { SKINS } from "../skins.js";
import { tape } from "./tools.js";

/** @typedef {import("../types.js").Baked} Baked */
/** @typedef {import("../types.js").Layout} Layout */
/** @typedef {import("../markup.js").Markup} Markup */

/** @type {Record<string, number>} units between two numbers on the ruler */
const LABEL_ROOM = { wide: 54, narrow: 46 };
const BREAK = "M-14 -56l7 -6l7 6l7 -6l7 6M-14 -49l7 -6l7 6l7 -6l7 6"; // across a box too tall to draw
const MOST_NUMBERS = 150; // on the ruler of a long moving-camera run
const LETTER = 8; // units that a letter of the key's word takes, in Latin script; others take twice that
const BEYOND = 60; // units that the track goes on at an open end

/** @param {Baked} baked @param {Layout} layout @returns {Markup} */
export function stage(baked, layout) {
  const { fence, run } = baked;
  const { kind, width, height } = layout;
  const forces = fence.forces === "shown";
  const hatch = `${fence.id}-${kind}-hatch`;
  const size = html`viewBox="0 0 ${px(width)} ${px(height)}" width=${px(width)} height=${px(height)}`;
  return html`<svg class="carts-stage carts-stage-${kind}" data-kind=${kind} ${size} aria-hidden="true">
<defs>
<pattern id=${hatch} width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path class="carts-hatch" d="M0 0V8"/></pattern>
</defs>
${ground(baked, layout, hatch)}
<g data-part="effects-behind"></g>
${run.header.bodies.map(velocity)}
${run.header.bodies.map((body, i) => cart(body.name, i, fence.skins[body.name] ?? "cart"))}
${run.header.bodies.map(({ name }) => html`<text class="carts-mass" data-body=${name}></text>`)}
<path class="carts-was"/>
<g data-part="effects-front"></g>
${forces && pushes(baked)}
<g data-part="guess"></g>
${layout.tape > 0 && tape(layout)}
${legend(baked, layout)}
</svg>`;
}

/** @param {{name: string}} body @param {number} i */
function velocity({ name }, i) {
  return html`<g class="carts-velocity carts-${styleOf(i)}" data-body=${name}><path data-part="leader" class="carts-leader"/><path data-part="arrow" class="carts-line-arrow"/><text data-part="text"></text></g>
`;
}

/** @param {string} name @param {number} i @param {string} skin */
function cart(name, i, skin) {
  const { corner, wheels } = /** @type {import("../skins.js").Skin} */ (SKINS[skin]);
  const face = (/** @type {string} */ side) =>
    html`<rect data-part="face-${side}" class="carts-face" x="-1.5" y="-22" width="3" height="21" rx="1.5"/>`;
  return html`<g class="carts-cart carts-${styleOf(i)}" data-body=${name}><path data-part="spring-left" class="carts-spring"/><path data-part="spring-right" class="carts-spring"/>${face("left")}${face("right")}<rect data-part="box" class="carts-box" rx=${corner}/>${skin !== "cart" && html`<path data-part="skin" class="carts-skin"/>`}${wheels && html`<path data-part="wheels" class="carts-wheels"/>`}<g data-part="break" class="carts-break"><path d=${BREAK}/></g><text data-part="name" class="carts-name"></text></g>
`;
}

/** One entry per contact force, on each of the two bodies. @param {Baked} baked */
function pushes({ run: { header } }) {
  const linked = linkedPairs(header);
  const style = (/** @type {string} */ name) => {
    const i = header.bodies.findIndex((body) => body.name === name);
    return i < 0 ? "wall" : styleOf(i);
  };
  return header.contacts
    .filter(({ stiffness, pair }) => stiffness || linked.has(pair))
    .flatMap(({ pair, bodies }) =>
      bodies.map(
        (on) =>
          html`<g class="carts-push carts-${style(on)}" data-pair=${pair} data-on=${on}><path data-part="arrow" class="carts-block-arrow"/><text data-part="text" visibility="hidden"></text></g>
`,
      ),
    );
}

/** Track, walls and ruler; they move to the left under a camera that moves to the right. */
/** @param {Baked} baked @param {Layout} layout @param {string} hatch id of a pattern */
function ground({ fence, run: { header } }, layout, hatch) {
  const travel = fence.camera * header.until;
  const [low, high] = [layout.low + Math.min(0, travel), layout.high + Math.max(0, travel)];
  const { left, right, length } = header.track;
  const at = (/** @type {number} */ x) => layout.origin + x * layout.scale;
  const first = left === "wall" ? 0 : low;
  const last = right === "wall" ? Number(length) : high;
  const slider = fence.controls.find((control) => control.set === "track.length");
  const longest = slider ? slider.high * slider.per : last;
  const start = left === "wall" ? at(0) : at(low) - BEYOND;
  const end = right === "wall" ? at(last) : at(high) + BEYOND;
  const under = layout.track + layout.beam;
  let step = niceAbove((LABEL_ROOM[layout.kind] ?? 0) / layout.scale);
  while ((high - low) / step > MOST_NUMBERS) step = niceAbove(step * 1.5);
  const numbers = { low: first, high: Math.max(last, longest), step };
  const parts = /[1-9]/.exec(short(step))?.[0] === "2" ? 4 : 5;
  const fine = ticks({ ...numbers, step: step / parts }).map((x) => `M${px(at(x))} ${px(under)}v4`);
  const wall = (/** @type {string} */ side) =>
    html`<g data-wall=${side}><path class="carts-wall"/><path fill="url(#${hatch})"/><path class="carts-wall-face"/></g>
`;
  return html`<g data-part="ground">
${left === "wall" && wall("left")}${right === "wall" && wall("right")}<rect class="carts-beam" x=${px(start)} y=${px(layout.track)} width=${px(end - start)} height=${px(layout.beam)}/>
<path class="carts-rule" d="M${px(start)} ${px(layout.track)}H${px(end)}"/>
<path class="carts-fine" d=${fine.join("")}/>
${ticks(numbers).map(
  (x) =>
    html`<path class="carts-fine" d="M${px(at(x))} ${px(under)}v8"/><text class="carts-number" x=${px(at(x))} y=${px(under + 22)}>${fixed(x, axisDecimals(numbers))}</text>
`,
)}</g>`;
}

/**
 * The length of a force and of a velocity arrow, written out. A word says that they are a key and nothing that
 * acts; where there is no room for it before the arrows, it stands above the first.
 * @param {Baked} baked @param {Layout} layout
 */
function legend({ fence, view }, layout) {
  const y = layout.height - 10;
  const wide = layout.kind === "wide";
  const [per, unit] = speedUnit(view.velocity);
  const text = (/** @type {number} */ x, /** @type {string} */ said) =>
    html`<text x=${px(x)} y=${px(y + 5)}>${said}</text>`;
  const force = fence.forces === "shown" && view.force > 0;
  const asked = fence.predict?.kind === "arrows" ? "" : "carts-unasked"; // its arrows are drawn in this scale
  const word = tr("scale:");
  const start = layout.above ? 12 : 12 + roomOf(word) + 4;
  const next = start + layout.velocity + 6;
  const x = next + 68;
  const end = force ? x + layout.force + 6 : next;
  const axis = wide ? tr("x in m, + is to the right") : tr("x in m, + →");
  const moving = wide ? tr("position on the track in m") : tr("track in m");
  return html`<g class="carts-legend">
<text x="12" y=${px(layout.above ? y - 9 : y + 5)}>${word}</text>
<path class="carts-line-arrow" d=${lineArrow(start, y, layout.velocity)}/>${text(next, `${short(view.velocity / per)} ${unit}`)}
${force && html`<g class=${asked}><path class="carts-block-arrow" d=${blockArrow(x, y, layout.force)}/>${text(end, `${short(view.force)} N`)}</g>`}
${wide && html`<text class="carts-torn" data-now="no" x=${px(end + 70)} y=${px(y + 5)}>${tr("torn: not to scale")}</text>`}
<text x=${px(layout.width - 12)} y=${px(y + 5)} text-anchor="end">${fence.camera ? moving : axis}</text>
</g>`;
}

/** @param {string} word @returns {number} units that it takes at most */
function roomOf(word) {
  return [...word].reduce((sum, sign) => sum + (sign > "\u02ff" ? 2 * LETTER : LETTER), 0);
}
