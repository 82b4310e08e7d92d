/** Of linkedom we use one function; its own types do not agree with those of the DOM. */
export function parseHTML(html: string): { document: Document };
