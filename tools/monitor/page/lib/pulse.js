// A pulse for what must go on in the background, where a browser throttles the timers of a page, and not those of a worker.

const listeners = new Set();
const worker = new Worker(new URL('beat.js', import.meta.url));
worker.onmessage = () => listeners.forEach((run) => run());

/** Runs a function twice a second, also while the tab is in the background. Returns how to end it. */
export function pulse(run) {
  listeners.add(run);
  return () => listeners.delete(run);
}
