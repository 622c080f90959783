// Links to a moment with a layout: #session=NAME&beside=NAME&t=SECONDS&layout=LAYOUT, and the same in a file. The address itself has no layout: after a
// reload it would undo changes. A layout is a preset's name, or, after `~`, compressed data.

import { effect, signal } from './dom.js';
import * as dock from './dock.js';
import { PRESETS } from './presets.js';
import { companions, cursor, hello, notify, putBeside, seek, session, sessions, show } from './store.js';

/** Largest layout in a link, characters. */
const LARGEST = 200e3;

/** The session and the time of a link, µs, until the page shows them. */
const pending = signal(null);
let writing = null;

async function piped(bytes, stream) {
  return new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer();
}

async function packed(data) {
  const bytes = new Uint8Array(await piped(JSON.stringify(data), new CompressionStream('deflate-raw')));
  return `~${btoa(String.fromCharCode(...bytes)).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
}

async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text.slice(1).replaceAll('-', '+').replaceAll('_', '/')), (one) => one.charCodeAt(0));
  const json = new TextDecoder().decode(await piped(bytes, new DecompressionStream('deflate-raw')));
  if (json.length > LARGEST) throw new Error('it is too large');
  return JSON.parse(json);
}

/** Applies the layout of a link. Its watches pause nothing: a link may be anybody's. */
async function applyShared(text) {
  // The shown preset stays: to make its panels again would take longer than all else that a link to a moment does.
  if (PRESETS[text]) return dock.isPreset() && dock.layoutName.value === text ? undefined : dock.preset(text);
  try {
    const { watches = [], ...layout } = await unpacked(text);
    if (dock.applyLayout({ ...layout, watches: watches.map((one) => ({ ...one, pause: false })) }, 'link')) return undefined;
  } catch {
    // It is reported below.
  }
  return notify('error', 'the layout of the link cannot be read', 'copy the whole link, or ask for the layout as a file');
}

export const parametersOf = ({ hash }) => Object.fromEntries(new URLSearchParams(hash.slice(1)));

/** Shows a session by its name, null for the shown one, others beside it, and a time, µs, as soon as they are known. */
export function goTo(name, time, beside = []) {
  if (name || time !== null) pending.value = { name, time, beside };
}

/** Follows a link. The address may have been written again since its event. */
export function follow(event) {
  const url = event ? new URL(event.newURL) : location;
  const { session: name, t, layout } = parametersOf(url);
  const seconds = Number.parseFloat(t);
  goTo(name, Number.isFinite(seconds) ? seconds * 1e6 : null, new URLSearchParams(url.hash.slice(1)).getAll('beside'));
  // The dock begins with the preset of the first address.
  if (layout && (event || !PRESETS[layout])) setTimeout(() => applyShared(layout));
}

const besides = () => companions.value.map(({ of }) => of.info.value.name);

/** What a link or a file contains besides the layout. */
const moment = () => ({ session: session.value?.info.value.name, beside: besides(), time: cursor.value ?? session.value?.moment.value?.time_us ?? 0 });

export async function copyLink() {
  const layout = dock.isPreset() ? dock.layoutName.value : await packed(dock.layout());
  const url = location.origin + dock.address({ ...moment(), layout });
  try {
    await navigator.clipboard.writeText(url);
    notify('done', 'the link to this moment and layout is in the clipboard');
  } catch {
    notify('done', url);
  }
}

/** The layout with its moment, as a file has it; and back. Returns whether it is one. */
export const shared = () => ({ ...dock.layout(), moment: moment() });

export function applyFile(data, name) {
  if (!dock.applyLayout(data, name)) return false;
  const { session: of, beside, time } = data.moment ?? {};
  if (typeof of === 'string' && Number.isFinite(time)) goTo(of, time, Array.isArray(beside) ? beside : []);
  return true;
}

effect(() => {
  if (!pending.value || !hello.value) return;
  const { name, time, beside } = pending.value;
  const all = [...sessions.value.values()];
  const one = name ? all.find((each) => each.info.value.name === name) : session.value;
  if (name && !one) {
    pending.value = null;
    notify('error', `the session “${name}” of the link is not open`, 'open it with +, then follow the link again');
  }
  if (!one?.description.value) return;
  pending.value = null;
  clearTimeout(writing);
  // The cursor must not become a dependency of this effect.
  setTimeout(() => {
    show(one.id);
    for (const other of all) if (beside.includes(other.info.value.name)) putBeside(other.id, true);
    if (time !== null) seek(time);
  });
});

/** Keeps the address that of the shown moment. */
export function writeAddress() {
  const at = cursor.value;
  const name = session.value?.info.value.name;
  const [several, beside] = [sessions.value.size > 1, besides()];
  clearTimeout(writing);
  writing = setTimeout(() => history.replaceState(null, '', dock.address({ session: several || at !== null ? name : null, beside, time: at })), 400);
}
