// This page stands at an address that is not there, at any depth: the nearest folder above it that has
// our picture is the site. Where none has, whoever reads is told to go back.

(() => {
  const home = /** @type {HTMLElement} */ (document.getElementById("home"));
  const link = /** @type {HTMLAnchorElement} */ (home.firstChild);
  const steps = location.pathname.split("/");

  /** @param {number} depth */
  function look(depth) {
    if (depth < 1) return;
    // The host is named: a path that begins with two slashes would else lead to another.
    const root = `${location.protocol}//${location.host}${steps.slice(0, depth).join("/")}/`;
    const picture = new Image();
    picture.onload = () => {
      link.href = `${root}index.html`;
      home.hidden = false;
    };
    picture.onerror = () => look(depth - 1);
    picture.src = `${root}@@PICTURE@@`;
  }

  look(steps.length - 1);
})();
