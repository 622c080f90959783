// The page that asks for the secret of the token file.

import { enter, keep } from './lib/entrance.js';

const why = document.getElementById('why');

document.getElementById('enter').addEventListener('submit', (event) => {
  event.preventDefault();
  const socket = enter(document.getElementById('token').value.trim());
  socket.onmessage = ({ data }) => {
    const { type, secret } = JSON.parse(data);
    if (type !== 'entered') return;
    keep(secret);
    location.replace(`./${location.hash}`);
  };
  socket.onclose = ({ reason }) => { why.textContent = reason || 'The program does not answer. Is it still running?'; };
});
