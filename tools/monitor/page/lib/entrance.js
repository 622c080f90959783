// Entering: the key of the address, and the secret of this origin. A cookie would go to every port of this host; storage does not.

const NAME = 'jmanager-secret';
/** What a reload needs until the secret is there: the key, and a text that proves that this tab used it. */
const BEGUN = 'jmanager-entering';
/** Code with which the program closes the WebSocket of a page that may not enter. */
export const REFUSED = 4403;

let begun = { key: '', page: '' };
// For a browser without storage.
let own = '';

function stored() {
  try { return localStorage.getItem(NAME) ?? own; } catch { return own; }
}

/** Keeps the secret for reloads and other tabs; the key is used up. */
export function keep(secret) {
  begun = { key: '', page: '' };
  own = secret;
  try {
    localStorage.setItem(NAME, secret);
    sessionStorage.removeItem(BEGUN);
  } catch { /* this tab has it */ }
}

/** Takes the key out of the address, so that it is in no history and no bookmark. */
function takeKey() {
  const parameters = new URLSearchParams(location.hash.slice(1));
  if (!parameters.has('key')) return;
  begun = { key: parameters.get('key'), page: crypto.getRandomValues(new Uint32Array(4)).join('') };
  try { sessionStorage.setItem(BEGUN, JSON.stringify(begun)); } catch { /* a reload loses it */ }
  parameters.delete('key');
  history.replaceState(null, '', `${location.pathname}${parameters.size > 0 ? `#${parameters}` : ''}`);
}

try { begun = JSON.parse(sessionStorage.getItem(BEGUN)) ?? begun; } catch { /* no storage */ }
takeKey();
window.addEventListener('hashchange', takeKey);

/** Opens a WebSocket whose first message proves that this page may enter. */
export function enter(token = '') {
  const socket = new WebSocket(`${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/socket`);
  socket.onopen = () => socket.send(JSON.stringify({ ...begun, secret: stored(), token }));
  return socket;
}
