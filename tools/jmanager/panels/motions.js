// The motion editor for the robots of this program.

import { right } from '../lib/places.js';
import { Motion } from '../motion/panel.js';

export default {
  panels: { motion: { title: 'Motion', view: Motion } },
  lastPresets: { motions: { title: 'Editing motions', panels: (width) => [['motion', {}], ['code', right('motion', Math.max(320, width * 0.28))]] } },
};
