// What a browser remembers of this page. Without storage nothing is remembered.

/** A value in `localStorage` or `sessionStorage`, by its key. */
export const stored = (storage, key) => ({
  read() {
    try { return JSON.parse(window[storage].getItem(key)); } catch { return null; }
  },
  write(value) {
    try { window[storage].setItem(key, JSON.stringify(value)); } catch { /* it holds until the page is closed */ }
  },
});
