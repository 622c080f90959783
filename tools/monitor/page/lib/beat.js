// The worker of pulse.js.

setInterval(() => postMessage(null), 500);
