/** The nearest number that is not below `low` nor above `high`. @param {number} v @param {number} low @param {number} high */
export const clamp = (v, low, high) => Math.max(low, Math.min(high, v));
