// Offsets: the server counts bytes of UTF-8, JavaScript counts UTF-16 units.

const ENCODER = new TextEncoder();

/** Number of bytes of a text. */
export const bytesOf = (text) => ENCODER.encode(text).length;

/** Both ways between the offsets of one text. */
export class Offsets {
  constructor(text) {
    this.text = text;
    this.plain = !/\P{ASCII}/u.test(text);
    if (this.plain) return;
    this.bytes = new Uint32Array(text.length + 1);
    let at = 0;
    for (let index = 0; index < text.length; index += 1) {
      this.bytes[index] = at;
      const unit = text.charCodeAt(index);
      // The second half of a pair has no bytes of its own.
      if (unit >= 0xdc00 && unit < 0xe000) at += 0;
      else if (unit >= 0xd800 && unit < 0xdc00) at += 4;
      else at += unit < 0x80 ? 1 : unit < 0x800 ? 2 : 3;
    }
    this.bytes[text.length] = at;
  }

  /** Bytes before a UTF-16 offset. */
  byte(index) { return this.plain ? index : this.bytes[Math.max(0, Math.min(index, this.text.length))]; }

  /** The UTF-16 offset of a byte. */
  index(byte) {
    if (this.plain) return Math.max(0, Math.min(byte, this.text.length));
    let [low, high] = [0, this.text.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.bytes[middle] < byte) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** A part of the text by its bytes. */
  slice([start, end]) { return this.text.slice(this.index(start), this.index(end)); }
}

/** Applies lists of splices, one list after the other, to a text. */
export function spliced(text, lists) {
  let now = text;
  for (const list of lists) {
    const offsets = new Offsets(now);
    let [out, at] = ['', 0];
    for (const { span: [start, end], text: put } of [...list].sort((a, b) => a.span[0] - b.span[0])) {
      const from = offsets.index(start);
      out += now.slice(at, from) + put;
      at = offsets.index(end);
    }
    now = out + now.slice(at);
  }
  return now;
}
