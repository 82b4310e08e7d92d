/**
 * What Python answers, see sim/pages/teach/answer.py.
 *
 * @typedef {{path: (string | number)[], group: string, label: string, kind: "line" | "area" | "choice",
 *   value: string, place: [number, number], options: string[]}} Field
 * @typedef {{kind: "top" | "text" | "block", text: string, line: number, name?: string, id?: string,
 *   title?: string, fields?: Field[]}} Piece
 * @typedef {{file: string, line: number, col: number, message: string, hint: string}} Finding
 * @typedef {{state: "shown" | "wrong" | "kept" | "needs" | "later", key?: string, html?: string | null}} Shown
 * @typedef {{pieces: Piece[], findings: Finding[], frame: string | null, blocks: Shown[], more: boolean,
 *   needs: string[]}} Look
 * @typedef {"" | "warning" | "fault"} Kind of what the panel says
 */

export {};
