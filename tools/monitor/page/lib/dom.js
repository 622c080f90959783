// The libraries of the page in one place.

import { h, render, Fragment } from '../vendor/preact.js';
import { useEffect, useLayoutEffect, useRef, useState, useMemo, useCallback } from '../vendor/hooks.js';
import { signal, computed, effect, batch, untracked, useSignal, useComputed, useSignalEffect } from '../vendor/signals.js';
import htm from '../vendor/htm.js';

export const html = htm.bind(h);
export { render, Fragment, useEffect, useLayoutEffect, useRef, useState, useMemo, useCallback };
export { signal, computed, effect, batch, untracked, useSignal, useComputed, useSignalEffect };
