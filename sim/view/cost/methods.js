/** The methods of “What accuracy costs”, in the order of the figure. A shape each: no line is told by its colour alone. */

import { tr } from "../language.js";

/** @type {Record<string, {label: string, mark: string, colour: string}>} colours: for a figure that stands alone */
export const METHODS = {
  exact: {
    label: tr("exact, closed form"),
    mark: "M0-6L1.6-2 6-2 2.5 1 4 6 0 3-4 6-2.5 1-6-2-1.6-2Z",
    colour: "#0072b2",
  },
  "exact-run": { label: tr("exact, any scene"), mark: "M0-5L5 0 0 5-5 0Z", colour: "#0072b2" },
  certified: {
    label: tr("certificate, proved"),
    mark: "M0-6L5.2-3V3L0 6-5.2 3V-3Z",
    colour: "#0072b2",
  },
  euler: { label: "Euler", mark: "M-4-4H4V4H-4Z", colour: "#c04a00" },
  "semi-implicit": { label: tr("semi-implicit Euler"), mark: "M0-5L5 4H-5Z", colour: "#00805d" },
  verlet: { label: tr("velocity Verlet"), mark: "M0 5L5-4H-5Z", colour: "#a8457f" },
  yoshida: {
    label: tr("Yoshida, order 4, symplectic"),
    mark: "M-5 0L0-5 5 0M-5 4L0-1 5 4 0 2Z",
    colour: "#a8457f",
  },
  richardson: {
    label: "Verlet + Richardson",
    mark: "M-5-4H5V-1H-5ZM-5 1H5V4H-5Z",
    colour: "#8a5f00",
  },
  rk4: { label: "RK4", mark: "M-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0Z", colour: "#8a5f00" },
  "rk4-events": {
    label: tr("RK4 + located touches"),
    mark: "M-5-1.5H-1.5V-5H1.5V-1.5H5V1.5H1.5V5H-1.5V1.5H-5Z",
    colour: "#2779a7",
  },
  rk45: {
    label: tr("adaptive RK45 + located touches"),
    mark: "M-5-3.5H5L0 0L5 3.5H-5L0 0Z",
    colour: "#6b3f7d",
  },
  adaptive: {
    label: tr("adaptive DOP853 + located touches"),
    mark: "M-5 0L-1.5-4H1.5L5 0 1.5 4H-1.5Z",
    colour: "#555",
  },
};

const STEPLESS = ["exact", "exact-run", "certified"];

/** @returns {string[]} those that step, which a reader can choose */
export const stepping = () => Object.keys(METHODS).filter((name) => !STEPLESS.includes(name));
