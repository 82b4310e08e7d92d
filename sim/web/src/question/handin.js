/**
 * The hand-in code: the chosen answers of a form in twelve letters and digits, to write on paper.
 * The same as sim/lesson/handin.py, which explains it.
 */

const ALPHABET = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
const ANSWER_BITS = 44n;
const CHECK_BITS = 16n;

/** @param {number[]} options how many options each item has; 0: not a choice @returns {boolean} */
export function fits(options) {
  const all = options.length > 0 && options.every((count) => count > 0);
  return all && options.reduce((size, count) => size * BigInt(count + 1), 1n) <= 1n << ANSWER_BITS;
}

/** @param {number[]} options @param {number[]} chosen from 1; 0: not answered @param {string} form its word and hash @returns {string} */
export function encode(options, chosen, form) {
  let number = 0n;
  options.forEach((count, k) => {
    number = number * BigInt(count + 1) + BigInt(chosen[k] ?? 0);
  });
  const whole = (number << CHECK_BITS) | BigInt(check(number, form));
  const letters = Array.from(
    { length: 12 },
    (_, k) => ALPHABET[Number((whole >> BigInt(55 - 5 * k)) & 31n)],
  );
  return [0, 4, 8].map((k) => letters.slice(k, k + 4).join("")).join("-");
}

/** CRC-CCITT of the form's name and the answers as six bytes. @param {bigint} number @param {string} form */
function check(number, form) {
  const bytes = [...new TextEncoder().encode(form)];
  for (let k = 5n; k >= 0n; k -= 1n) bytes.push(Number((number >> (8n * k)) & 255n));
  let crc = 0xffff;
  for (const byte of bytes) {
    crc ^= byte << 8;
    for (let bit = 0; bit < 8; bit += 1) {
      crc = (crc & 0x8000 ? (crc << 1) ^ 0x1021 : crc << 1) & 0xffff;
    }
  }
  return crc;
}
