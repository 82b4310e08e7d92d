/** Another order of the answers for each student, the same at every visit. The answers keep their ids. */

const LETTERS = "ABCDEFGHIJKL";

/** @param {HTMLElement} quiz @param {string} student */
export function shuffleOptions(quiz, student) {
  for (const question of quiz.querySelectorAll("carts-question")) {
    const body = question.querySelector(".carts-q-options");
    const labels = [...(body?.querySelectorAll("label") ?? [])];
    const order = new Map(
      labels.map((label) => [label, hash(`${student}/${question.id}/${label.dataset.option}`)]),
    );
    labels.sort((a, b) => (order.get(a) ?? 0) - (order.get(b) ?? 0));
    labels.forEach((label, k) => {
      body?.append(label);
      const letter = label.querySelector(".carts-q-letter");
      if (letter) letter.textContent = LETTERS[k] ?? "";
    });
  }
}

/** FNV-1a with a last stir: the first letters must not decide. @param {string} text @returns {number} */
function hash(text) {
  let sum = 0x811c9dc5;
  for (const byte of new TextEncoder().encode(text)) sum = Math.imul(sum ^ byte, 0x01000193);
  sum = Math.imul(sum ^ (sum >>> 15), 0x2c1b3c6d);
  return (sum ^ (sum >>> 13)) >>> 0;
}
