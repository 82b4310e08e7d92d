/** A second cue beside colour: each body has its own mark. */

/** @type {Record<string, string>} */
export const MARKERS = {
  b0: "M-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0Z",
  b1: "M-3.5 -3.5H3.5V3.5H-3.5Z",
  b2: "M0 -5L5 0L0 5L-5 0Z",
  b3: "M-4.5 3.5L0 -4.5L4.5 3.5Z",
  b4: "M-4.5 -3.5L0 4.5L4.5 -3.5Z",
  b5: "M-4 -1.5H-1.5V-4H1.5V-1.5H4V1.5H1.5V4H-1.5V1.5H-4Z",
  b6: "M-4.5 -2.5H4.5V2.5H-4.5Z",
  b7: "M-2.5 -4.5H2.5V4.5H-2.5Z",
  wall: "M-3 -3L3 3M-3 3L3 -3",
  total: "M-2.5 0a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0Z",
};

/** @param {number} index of a cart, from the left @returns {string} its style: colour, dash, marker */
export function styleOf(index) {
  return `b${index % 8}`;
}
