/** Runs in numbers, side by side: velocities at the end, the greatest push on each cart, all momentum. */

import { tr } from "../../../view/language.js";
import { fixed, speedUnit } from "../../../view/numbers.js";
import { greatest } from "../predict/arrow-parts.js";
import { html } from "../shared/dom.js";

/** @typedef {import("../../../view/types.js").Run} Run */

/** @param {{label: string, run: Run}[]} columns of one scene @param {import("../../../view/types.js").View} view */
export function ends(columns, { decimals, velocity }) {
  const [per, unit] = speedUnit(velocity);
  const real = /** @type {{run: Run}} */ (columns[0]).run;
  const table = html("table", "carts-worlds-ends");
  const head = html("tr");
  head.append(
    html("td"),
    ...columns.map(({ label }) => {
      const cell = html("th", "", label);
      cell.setAttribute("scope", "col");
      return cell;
    }),
  );
  table.append(head);
  const rows = [
    ...real.header.bodies.map(({ name }) => ({
      label: tr("velocity of {name} at the end", { name }),
      of: (/** @type {Run} */ run) => `${fixed(last(run, name) / per, decimals.v ?? 2)} ${unit}`,
    })),
    ...pushed(real).map(({ pair, on, by }) => ({
      label: tr("greatest push on {on} by {by}", { on, by }),
      of: (/** @type {Run} */ run) => `${fixed(greatestOn(run, pair, on), decimals.F ?? 1)} N`,
    })),
    {
      label: tr("momentum of all carts, start → end"),
      of: (/** @type {Run} */ run) => {
        const [start, end] = [momentum(run, 0), momentum(run, -1)];
        return `${fixed(start, decimals.p ?? 2)} → ${fixed(end, decimals.p ?? 2)} N s`;
      },
    },
  ];
  for (const { label, of } of rows) {
    const row = html("tr");
    const title = html("th", "", label);
    title.setAttribute("scope", "row");
    row.append(title, ...columns.map(({ run }) => html("td", "", of(run))));
    table.append(row);
  }
  return table;
}

/** Pushes between two carts. @param {Run} run */
function pushed({ header }) {
  const names = new Set(header.bodies.map(({ name }) => name));
  return header.contacts
    .filter(({ bodies, stiffness }) => stiffness && bodies.every((name) => names.has(name)))
    .flatMap(({ pair, bodies: [a, b] }) => [
      { pair, on: a, by: b },
      { pair, on: b, by: a },
    ]);
}

/** N. The greatest push of a pair on one of the two. @param {Run} run @param {string} pair @param {string} on */
export function greatestOn(run, pair, on) {
  const own = run.trajectory.on?.[`${pair} ${on}`];
  return own ? Math.max(0, ...Array.from(own)) : greatest(run, pair);
}

/** @param {Run} run @param {string} name */
function last({ trajectory }, name) {
  return Number(trajectory.v[name]?.[trajectory.t.length - 1]);
}

/** N s. @param {Run} run @param {0 | -1} row first or last */
function momentum({ header, trajectory }, row) {
  const k = row === 0 ? 0 : trajectory.t.length - 1;
  return header.bodies.reduce(
    (sum, { name, mass }) => sum + mass * Number(trajectory.v[name]?.[k]),
    0,
  );
}
