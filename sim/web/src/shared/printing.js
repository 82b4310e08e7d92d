/** Prints a page that is another one for it. */

/**
 * Where `print()` is refused, as in a frame of a learning platform, nobody says that it is over: then the page is
 * as before once it is used again. @param {() => void} undo
 */
export function printWith(undo) {
  const over = new AbortController();
  const { signal } = over;
  const end = () => {
    over.abort();
    undo();
  };
  for (const kind of ["afterprint", "pointerdown", "keydown"])
    addEventListener(kind, end, { signal });
  window.print();
}
