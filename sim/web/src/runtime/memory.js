// Browsers say in many ways that there is no memory left.

/** @param {unknown} error @returns {boolean} */
export const isOutOfMemory = (error) =>
  error instanceof RangeError || /memory|allocat/i.test(String(error));
