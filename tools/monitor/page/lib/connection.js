// The WebSocket: connects again after a loss, numbers requests, hands messages on.

import { signal } from './dom.js';
import { REFUSED, enter, keep } from './entrance.js';

/** connecting, open or lost. */
export const link = signal('connecting');

const RETRY_MS = 1000;
const listeners = [];
const waiting = new Map();
let socket = null;
let lastId = 0;

/** Registers a receiver of messages (objects) and of binary frames (ArrayBuffer). */
export const listen = (listener) => listeners.push(listener);

/** Connects, and again after each loss. Requests of a lost connection fail; none of them is sent again. */
export function connect() {
  const mine = enter();
  socket = mine;
  mine.binaryType = 'arraybuffer';
  mine.onmessage = ({ data }) => receive(data);
  mine.onclose = ({ code }) => {
    if (socket !== mine) return;
    // A page that was open waits: another tab may enter, with the address of a program that was started again.
    if (code === REFUSED && link.value === 'connecting') location.replace(`enter.html${location.hash}`);
    link.value = 'lost';
    socket = null;
    for (const { reject } of waiting.values()) reject({ text: 'the connection to the program was lost', help: 'it is being restored' });
    waiting.clear();
    setTimeout(connect, RETRY_MS);
  };
}

/** JSON, in which a whole number that a `number` cannot hold is a BigInt: `{"$int": "9007199254740993"}`, or digits in what is sent. */
export const parsed = (text) => JSON.parse(text, text.includes('{"$int":') ? (_, value) => (value?.$int ? BigInt(value.$int) : value) : undefined);
export const written = (value) => JSON.stringify(value, (_, one) => (typeof one === 'bigint' ? `\uE000${one}` : one)).replaceAll(/"\uE000(-?\d+)"/g, '$1');

function receive(data) {
  const message = typeof data === 'string' ? parsed(data) : null;
  if (message?.type === 'entered') {
    keep(message.secret);
    link.value = 'open';
  } else if (message?.type === 'answer') {
    const asked = waiting.get(message.id);
    waiting.delete(message.id);
    if (message.error) asked?.reject(message.error);
    else asked?.resolve(message.result);
  } else for (const listener of listeners) listener(message, message ? null : data);
}

/** Sends a request; the promise has its result, or its error `{text, help, entry}`. */
export function request(type, fields = {}) {
  const none = { text: 'there is no connection to the program', help: 'it is being restored; try again then' };
  if (link.value !== 'open') return Promise.reject(none);
  lastId += 1;
  const id = lastId;
  socket.send(written({ id, type, ...fields }));
  const answer = new Promise((resolve, reject) => waiting.set(id, { resolve, reject }));
  answer.id = id;
  return answer;
}
