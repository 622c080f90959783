// Line ends: the editor counts each as one character, a file may have two.

/** A text as the editor has it. */
export const plain = (text) => (text.includes('\r') ? text.replace(/\r\n?/g, '\n') : text);

/** The line end that a text uses. */
export const endOf = (text) => (text.includes('\r\n') ? '\r\n' : '\n');

/** Both ways between offsets of a text and of the editor. */
export class Lines {
  constructor(text) {
    this.length = text.length;
    /** Offsets in the text of the second character of each long line end. */
    this.seconds = [];
    for (let at = text.indexOf('\r\n'); at >= 0; at = text.indexOf('\r\n', at + 2)) this.seconds.push(at + 1);
  }

  /** Length of the editor's text. */
  get short() {
    return this.length - this.seconds.length;
  }

  /** Number of long line ends whose first character lies before an offset of the text. */
  before(index) {
    let [low, high] = [0, this.seconds.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.seconds[middle] < index) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  toEditor(index) { return index - this.before(index); }

  toText(place) {
    let index = place;
    // Each step finds more line ends before it, until none is new.
    for (;;) {
      const next = place + this.before(index + 1);
      if (next === index) return index;
      index = next;
    }
  }
}
