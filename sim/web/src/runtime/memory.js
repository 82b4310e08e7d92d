// Browsers say in many ways that there is no memory left.

/** @param {unknown} error @returns {boolean} */
export const isOutOfMemory = (error) =>
  error instanceof RangeError || /memory|allocat/i.test(String(error));

/**
 * One that surely means it: a damaged picture of the memory fails with “memory access out of bounds”, and
 * old browsers with a range of their tables; after those the plain way is tried.
 * @param {unknown} error @returns {boolean}
 */
export const isNotAllocated = (error) =>
  error instanceof RangeError && /memory|allocat/i.test(error.message);
