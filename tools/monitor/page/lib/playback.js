// Playback of a recording: moves the cursor with the clock.

import { effect } from './dom.js';
import { cursor, playing, seek, session } from './store.js';

let lastFrame = 0;

function play(now) {
  if (!playing.value) return;
  const passed = Math.min(now - lastFrame, 200);
  lastFrame = now;
  const shown = session.value;
  if (shown && cursor.value !== null) {
    const end = shown.info.value.until_us;
    const next = cursor.value + passed * 1000;
    seek(Math.min(next, end));
    // What is still being read has not ended.
    if (next >= end && shown.info.value.connection !== 'connecting') playing.value = false;
  }
  requestAnimationFrame(play);
}

effect(() => {
  if (playing.value) requestAnimationFrame((now) => {
    lastFrame = now;
    play(now);
  });
});

/** Space: pauses what moves, and lets it go on. */
export function playOrPause() {
  const info = session.value?.info.value;
  if (!info) return;
  if (info.kind === 'recording') {
    if (cursor.value === null || cursor.value >= info.until_us) seek(info.from_us);
    playing.value = !playing.value;
  } else if (cursor.value === null) seek(session.value.live.value?.time_us ?? 0);
  else seek(null);
}
