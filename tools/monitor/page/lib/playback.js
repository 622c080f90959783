// Playback of a recording, or of a chosen span of any session: moves the cursor with the clock.

import { effect, signal } from './dom.js';
import { span } from './span.js';
import { cursor, playing, seek, session } from './store.js';

/** Speed of playback: 1 is the robot's time. */
export const speed = signal(1);
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10];
/** Whether playback begins again at its end. */
export const looping = signal(false);

let lastFrame = 0;

/** What is played: the span if one is chosen, else the session. */
function bounds({ from_us: from, until_us: until }) {
  return span.value ?? [from, until];
}

function play(now) {
  if (!playing.value) return;
  const passed = Math.min(now - lastFrame, 200);
  lastFrame = now;
  const shown = session.value;
  if (shown && cursor.value !== null) {
    const [begin, end] = bounds(shown.info.value);
    const next = cursor.value + passed * 1000 * speed.value;
    if (next < end) seek(next);
    else if (looping.value) seek(begin);
    else {
      seek(end);
      // What is still being read has not ended.
      if (shown.info.value.connection !== 'connecting') playing.value = false;
    }
  }
  requestAnimationFrame(play);
}

effect(() => {
  if (playing.value) requestAnimationFrame((now) => {
    lastFrame = now;
    play(now);
  });
});

/** Plays the span, or pauses. */
export function playSpan() {
  const [begin, end] = bounds(session.value.info.value);
  if (!playing.value && (cursor.value === null || cursor.value < begin || cursor.value >= end)) seek(begin);
  playing.value = !playing.value;
}

/** Space: pauses what moves, and lets it go on. */
export function playOrPause() {
  const info = session.value?.info.value;
  if (!info) return;
  if (info.kind === 'recording') playSpan();
  else if (playing.value) playing.value = false;
  else if (cursor.value === null) seek(session.value.live.value?.time_us ?? 0);
  else seek(null);
}
