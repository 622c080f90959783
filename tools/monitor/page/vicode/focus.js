// The way from the canvas to the code panel, which may not be open yet.

let how = null;
let wanted = false;

/** The code panel says how it gets the focus. */
export function setFocusCode(focus) {
  how = focus;
  if (focus && wanted) {
    wanted = false;
    focus();
  }
}

export function focusCode() {
  if (how) how();
  else wanted = true;
}
