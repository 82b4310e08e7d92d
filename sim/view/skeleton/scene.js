/**
 * A scene as it stands in the page before a run is drawn in it: everything that the classes of
 * `sim/web/src/scene` need, and nothing that only a run knows.
 */

import { tr } from "../language.js";
import { html } from "../markup.js";
import { fixed, short } from "../numbers.js";
import { motion } from "../words.js";
import { near, views } from "./beside.js";
import { graph } from "./graph.js";
import { liveMark } from "./mark.js";
import { panel } from "./panel.js";
import { predict } from "./predict.js";
import { stage } from "./stage.js";
import { timeline, transport } from "./time.js";
import { tools } from "./tools.js";

/** @typedef {import("../types.js").Baked} Baked */
/** @typedef {import("../markup.js").Markup} Markup */

const FORCE_QUANTITIES = ["F", "R", "a"]; // left out where the lesson lets students find the force

/**
 * @param {Baked} baked
 * @param {boolean} found whether it shows the forces that a reader has found
 * @returns {Markup} the inside of `<carts-scene>`
 */
export function inside(baked, found = false) {
  const { fence, view, run } = baked;
  const { id, predict: asked } = fence;
  const quantities = fence.show.filter(
    (quantity) => fence.forces === "shown" || !FORCE_QUANTITIES.includes(quantity),
  );
  const paper = asked
    ? tr("Make your prediction on paper. The run needs JavaScript.")
    : tr("The picture shows the start. Playing the run needs JavaScript.");
  return html`<div class="carts-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${run.header.title ?? tr("Carts on an air track")}</p><button type="button" class="carts-sign carts-project" title=${tr("Full screen for the class (key P)")} aria-pressed="false" disabled>${tr("projector")}</button>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
<div class="carts-world" tabindex="0" role="group" aria-label=${tr("Carts on the track")} aria-describedby="${id}-described ${id}-keys">
${view.layouts.map((layout) => stage(baked, layout))}
<p class="carts-torn" data-now="no"${!view.mayTear && html` hidden`}>${tr("A torn box is not to scale: its cart is heavier.")}</p>
${run.header.effects.length > 0 && html`<p class="carts-acting"></p>`}
${fence.camera !== 0 && html`<p class="carts-camera">${cameraText(fence.camera)}</p>`}
</div>
<p class="carts-hidden" id="${id}-described">${description(baked)}</p>
<p class="carts-hidden" id="${id}-keys">${tr("The space bar plays and pauses, the arrow keys step.")}</p>
${timeline(baked)}
${transport(baked)}
${tools(baked)}
<noscript><p class="carts-noscript">${paper}</p></noscript>
${asked && predict(baked, asked)}
${near(baked)}
${panel(baked)}
${views(baked)}
<div class="carts-results" id="${id}-graphs"${asked && html` hidden`}>
<div class="carts-graphs-bar"><details class="carts-more carts-choose"><summary>${tr("Choose what to see")}</summary><div class="carts-choices"></div></details><label>${tr("Time axis")} <select class="carts-window" disabled><option value="">${tr("whole run")}</option></select></label></div>
<div class="carts-graphs">
${quantities.map((quantity) => graph(baked, quantity))}
<div class="carts-story"><p class="carts-heading">${tr("What happens")}</p>
<ol class="carts-events" aria-label=${tr("What happens")}></ol></div>
</div>
${asksForForces(baked) && find()}${found && html`<p class="carts-found" hidden></p>`}
</div>
<details class="carts-more carts-model"${asksForForces(baked) && html` hidden`}><summary>${tr("What is in this model")}</summary><ul></ul></details>
<details class="carts-more carts-how"><summary>${tr("How is this computed?")}</summary><div class="carts-how-body"></div><noscript><p>${tr("Every run is computed exactly, formula by formula. How this one was needs JavaScript.")}</p></noscript></details>
<div class="carts-hidden carts-announcer" aria-live="polite"></div>
</div>`;
}

/** Whether the lesson hides forces that a reader can find. @param {Baked} baked */
function asksForForces({ fence, run }) {
  return fence.forces === "hidden" && run.header.contacts.some(({ stiffness }) => stiffness);
}

/** What a reader has to do to see the hidden forces. */
function find() {
  const [before, after] = tr(
    "While they touch, the mean force on a cart is {formula}. Read its velocity before and after off the graph or its table, and the times off “What happens”.",
  ).split("{formula}");
  return html`<details class="carts-more carts-find" open><summary>${tr("The forces are hidden. Find those on both carts, and you see them all")}</summary><p>${before}<i>F</i> = <i>m</i> · Δ<i>v</i> / Δ<i>t</i>${after}</p><form class="carts-find-form"><label>${tr("Mean force on")} <select class="carts-find-which" disabled></select></label> <span class="carts-find-value"><input type="text" inputmode="decimal" autocomplete="off" aria-label=${tr("mean force in N, plus is to the right")} disabled> N</span> <button type="submit" class="carts-button" disabled>${tr("Check")}</button></form><p class="carts-find-note" role="status"></p></details>`;
}

/** The start of every cart as a sentence. @param {Baked} baked */
function description({ fence: { camera }, view, run: { header } }) {
  const carts = header.bodies.map(({ name, mass, position, velocity }) => {
    const told = { cart: name, mass: short(mass), place: fixed(position, 2) };
    if (velocity === camera) return tr("{cart}, {mass} kg, is at {place} m and is at rest.", told);
    const seen = motion(velocity - camera, view.decimals.v ?? 2, view.velocity);
    return tr("{cart}, {mass} kg, is at {place} m and moves at {velocity}.", {
      ...told,
      velocity: seen,
    });
  });
  return tr("At the start: {carts}", { carts: carts.join(" ") });
}

/** @param {number} camera in m/s */
function cameraText(camera) {
  return tr(
    "Seen from a camera that moves at {velocity} along the track. Positions and velocities are measured from the camera.",
    { velocity: motion(camera, 2, Math.abs(camera)) },
  );
}
