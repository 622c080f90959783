// The field: what the robot believes, and apart from that the truth of a simulated world.

import { html, useEffect, useMemo, useSignal } from '../lib/dom.js';
import { Canvas } from '../lib/canvas.js';
import { number } from '../lib/format.js';
import { cursor, session, watch } from '../lib/store.js';
import { css } from '../lib/theme.js';
import { Bar, Empty, Toggle } from '../lib/ui.js';
import { BallMenu, useDrag } from './field/ball.js';

/** The field of the league's rules of 2009, m. */
const FIELD = { length: 6, width: 4, border: 0.7, areaLength: 0.6, areaWidth: 3, mark: 1.8, circle: 0.6, goal: 1.4 };
/** Where the ball can be placed: half the length and the width of the field, m. */
const REACH = [FIELD.length / 2, FIELD.width / 2];
const TRAIL = 400;

/** Information of the forward that the map draws: component and name. */
const WANTED = {
  pose: ['Localization', 'robot_pose'], spread: ['Localization', 'spread'], sure: ['Localization', 'is_sure'], walked: ['Odometry', 'walked'],
  ball: ['BallDetector', 'ball_position'], ballError: ['BallDetector', 'position_error'], ballVelocity: ['BallDetector', 'ball_velocity'], ballConfidence: ['BallDetector', 'position_confidence'],
  goal: ['GoalDetector', 'goal_position'], goalError: ['GoalDetector', 'position_error'], goalConfidence: ['GoalDetector', 'position_confidence'],
  robots: ['RobotDetector', 'robot_positions'], circle: ['FieldLines', 'circle_centre'],
};

/** A pose followed by a point or pose in its frame. */
const into = ([x, y, heading], { x: ahead, y: left }) => [x + ahead * Math.cos(heading) - left * Math.sin(heading), y + ahead * Math.sin(heading) + left * Math.cos(heading)];

export function FieldMap({ visible }) {
  const shown = session.value;
  const description = shown?.description.value;
  const truthShown = useSignal(true);
  const turned = useSignal(false);
  const places = useMemo(() => Object.fromEntries(Object.entries(WANTED).map(([key, names]) => [key, shown?.findInfo(...names) ?? null])), [shown, description]);
  const trail = useMemo(() => ({ belief: [], truth: [] }), [shown, description]);
  const shownMap = (element) => mapOf(element.clientWidth, element.clientHeight, turned.value);
  const { dragged, handlers } = useDrag({ shown, mapOf: shownMap, visible: truthShown.value, reach: REACH });
  useEffect(() => {
    if (!visible.value || !shown || !description) return undefined;
    return watch({ truth: shown.info.value.can.truth, info: Object.values(places).filter(Boolean).map((place) => [...place, 3]) });
  }, [visible.value, shown, description]);

  if (!description) return html`<${Empty} what="No field yet" help="Open a world, a robot or a recording." />`;
  const believes = Object.values(places).some(Boolean);
  if (!believes && !shown.info.value.can.truth) return html`<${Empty} what="This tree has nothing that the map can draw" help="The map reads the information of Localization, Odometry, BallDetector, GoalDetector and RobotDetector." />`;
  const read = (key) => (places[key] ? shown.info_of(...places[key]).now.value?.value ?? null : null);
  const belief = () => beliefOf(read, shown.truth.value?.truth);
  const reads = () => {
    void [shown.truth.value, truthShown.value, turned.value, cursor.value, dragged.value];
    Object.values(places).forEach((place) => place && shown.info_of(...place).now.value);
  };
  const draw = (context, width, height) => {
    const map = mapOf(width, height, turned.value);
    drawField(context, map, shown.truth.value?.truth.attacks_blue);
    const truth = shown.truth.value?.truth;
    const now = belief();
    remember(trail, now, truth, cursor.value);
    if (cursor.value === null) {
      drawTrail(context, map, trail.belief, css('--control'), []);
      if (truthShown.value) drawTrail(context, map, trail.truth, css('--truth'), [2, 4]);
    }
    if (now) drawBelief(context, map, now, read);
    if (truth && truthShown.value) drawTruth(context, map, truth);
    drawLegend(context, map, Boolean(truth && truthShown.value));
    if (dragged.value) disc(context, map, dragged.value, 0.06, 9, { stroke: css('--truth') });
  };
  return html`<${Bar} label="Field">
      <span class="dim place"><${Source} belief=${belief} /></span><span class="grow"></span>
      ${shown.info.value.can.truth && html`<${Toggle} on=${truthShown.value} label="Truth" title="The simulator's state, dashed. The robot never gets it." colour=${css('--truth')} onChange=${(on) => { truthShown.value = on; }} />`}
      ${shown.info.value.can.ball && html`<${BallMenu} shown=${shown} reach=${REACH} />`}
      <${Toggle} on=${turned.value} label="Turn" title="Turn the field by 180°" onChange=${(on) => { turned.value = on; }} />
      <button aria-label="Clear trail" title="Clear the trail" onClick=${() => { trail.belief.length = trail.truth.length = 0; }}>Clear</button>
    <//>
    <div class="fill field"><${Canvas} reads=${reads} draw=${draw} visible=${visible} label="Field map" ...${handlers} /></div>`;
}

function Source({ belief }) {
  const now = belief();
  if (!now) return 'the robot does not know where it is';
  return `${now.source} · ${number(now.pose[0])}, ${number(now.pose[1])} m · ${((now.pose[2] * 180) / Math.PI).toFixed(0)}°`;
}

/** Pose in the field's frame: localization, or else odometry from where it began, or from the middle. */
function beliefOf(read, truth) {
  const pose = read('pose');
  if (pose) return { pose: [pose.x, pose.y, pose.heading], source: read('sure') ? 'localized' : 'localized, not sure', spread: read('spread') };
  const walked = read('walked');
  if (!walked) return null;
  const start = truth?.start ?? [0, 0, 0];
  return { pose: [...into(start, walked), start[2] + walked.heading], source: truth ? 'odometry from the start' : 'odometry, start unknown', spread: null };
}

function remember(trail, now, truth, at) {
  if (at !== null) return;
  const add = (list, x, y) => {
    const last = list.at(-1);
    if (last && Math.hypot(last[0] - x, last[1] - y) < 0.01) return;
    list.push([x, y]);
    if (list.length > TRAIL) list.shift();
  };
  if (now) add(trail.belief, now.pose[0], now.pose[1]);
  if (truth) add(trail.truth, truth.robot[0], truth.robot[1]);
}

function mapOf(width, height, turned) {
  const [length, wide] = [FIELD.length + 2 * FIELD.border, FIELD.width + 2 * FIELD.border];
  const scale = Math.min((width - 8) / length, (height - 8) / wide);
  const sign = turned ? -1 : 1;
  return {
    scale, sign, width, height, x: (x) => width / 2 + sign * x * scale, y: (y) => height / 2 - sign * y * scale,
    /** The position, m, of a point of the canvas. */
    at: (x, y) => [(x - width / 2) / (sign * scale), (height / 2 - y) / (sign * scale)],
    angle: (heading) => (turned ? Math.PI - heading : -heading),
  };
}

function drawField(context, map, attacksBlue) {
  const { scale, x, y, sign } = map;
  const rect = (left, top, length, width) => context.strokeRect(Math.min(x(left), x(left + length)), Math.min(y(top), y(top - width)), length * scale, width * scale);
  const [half, side] = [FIELD.length / 2, FIELD.width / 2];
  context.fillStyle = css('--grass');
  context.fillRect(x(-sign * (half + FIELD.border)), y(sign * (side + FIELD.border)), (FIELD.length + 2 * FIELD.border) * scale, (FIELD.width + 2 * FIELD.border) * scale);
  context.strokeStyle = css('--marking');
  context.lineWidth = Math.max(1.2, 0.04 * scale);
  rect(-half, side, FIELD.length, FIELD.width);
  for (const end of [-1, 1]) {
    rect(end > 0 ? half - FIELD.areaLength : -half, FIELD.areaWidth / 2, FIELD.areaLength, FIELD.areaWidth);
    context.fillStyle = css('--marking');
    context.fillRect(x(end * (half - FIELD.mark)) - 2, y(0) - 2, 4, 4);
  }
  context.beginPath();
  context.moveTo(x(0), y(side));
  context.lineTo(x(0), y(-side));
  context.moveTo(x(0) + FIELD.circle * scale, y(0));
  context.arc(x(0), y(0), FIELD.circle * scale, 0, 2 * Math.PI);
  context.stroke();
  for (const end of [-1, 1]) {
    context.strokeStyle = attacksBlue === undefined ? css('--marking') : (end > 0) === attacksBlue ? '#4aa3ff' : '#f2c11d';
    context.lineWidth = Math.max(3, 0.1 * scale);
    context.beginPath();
    context.moveTo(x(end * half), y(FIELD.goal / 2));
    context.lineTo(x(end * half), y(-FIELD.goal / 2));
    context.stroke();
  }
}

/** What the colours mean, in the border of the field, as far as there is room. */
function drawLegend(context, map, withTruth) {
  const all = [['--control', 'robot'], ['--ball', 'ball'], ['--machine', 'goal'], ['--act', 'other robots'], ...(withTruth ? [['--truth', 'truth (dashed)']] : [])];
  context.font = `11px ${css('--font')}`;
  context.textBaseline = 'middle';
  const [y, right] = [map.height / 2 + (FIELD.width / 2 + FIELD.border / 2) * map.scale, map.width / 2 + FIELD.length / 2 * map.scale];
  let x = map.width / 2 - FIELD.length / 2 * map.scale;
  for (const [colour, text] of all) {
    const width = context.measureText(text).width + 24;
    if (x + width > right) return;
    context.fillStyle = css(colour);
    context.fillRect(x, y - 4, 8, 8);
    context.fillStyle = css('--marking');
    context.fillText(text, x + 12, y + 0.5);
    x += width;
  }
}

function drawTrail(context, map, points, colour, dash) {
  if (points.length < 2) return;
  context.strokeStyle = colour;
  context.globalAlpha = 0.6;
  context.lineWidth = 1.4;
  context.setLineDash(dash);
  context.beginPath();
  points.forEach(([x, y], index) => context[index ? 'lineTo' : 'moveTo'](map.x(x), map.y(y)));
  context.stroke();
  context.setLineDash([]);
  context.globalAlpha = 1;
}

function robot(context, map, [x, y, heading], { fill, stroke, dash = [] }) {
  const size = Math.max(0.13 * map.scale, 6);
  context.save();
  context.translate(map.x(x), map.y(y));
  context.rotate(map.angle(heading));
  if (map.sign < 0) context.scale(1, 1);
  context.beginPath();
  context.arc(0, 0, size, 0, 2 * Math.PI);
  context.setLineDash(dash);
  context.lineWidth = 2;
  if (fill) {
    context.fillStyle = fill;
    context.fill();
  }
  context.strokeStyle = stroke;
  context.stroke();
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(0, 0);
  context.lineTo(size * 1.7, 0);
  context.stroke();
  context.restore();
}

function disc(context, map, [x, y], metres, least, { fill, stroke, dash = [] }) {
  context.beginPath();
  context.arc(map.x(x), map.y(y), Math.max(metres * map.scale, least), 0, 2 * Math.PI);
  if (fill) {
    context.fillStyle = fill;
    context.fill();
  }
  if (stroke) {
    context.setLineDash(dash);
    context.strokeStyle = stroke;
    context.lineWidth = 1.6;
    context.stroke();
    context.setLineDash([]);
  }
}

function drawBelief(context, map, { pose, spread }, read) {
  const colour = css('--control');
  if (spread) disc(context, map, pose, spread, 4, { fill: `${colour}33`, stroke: colour, dash: [4, 3] });
  robot(context, map, pose, { fill: `${colour}66`, stroke: '#ffffff' });
  const goal = read('goal');
  if (goal && read('goalConfidence') !== 0) {
    const at = into(pose, goal);
    disc(context, map, at, read('goalError') ?? 0.1, 5, { stroke: css('--machine'), dash: [4, 3] });
    cross(context, map, at, css('--machine'));
  }
  for (const other of read('robots') ?? []) if (other) disc(context, map, into(pose, other), 0.15, 6, { stroke: css('--act'), fill: `${css('--act')}33` });
  const circle = read('circle');
  if (circle) cross(context, map, into(pose, circle), css('--perceive'));
  const ball = read('ball');
  if (!ball) return;
  const at = into(pose, ball);
  const error = read('ballError');
  if (error) disc(context, map, at, error, 0, { stroke: css('--ball'), dash: [3, 3] });
  context.globalAlpha = Math.max(0.35, read('ballConfidence') ?? 1);
  disc(context, map, at, 0.04, 5, { fill: css('--ball') });
  context.globalAlpha = 1;
  const velocity = read('ballVelocity');
  if (velocity && Math.hypot(velocity.x, velocity.y) > 0.02) {
    const end = into(pose, { x: ball.x + velocity.x, y: ball.y + velocity.y });
    context.strokeStyle = css('--ball');
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(map.x(at[0]), map.y(at[1]));
    context.lineTo(map.x(end[0]), map.y(end[1]));
    context.stroke();
  }
}

function cross(context, map, [x, y], colour) {
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(map.x(x) - 5, map.y(y));
  context.lineTo(map.x(x) + 5, map.y(y));
  context.moveTo(map.x(x), map.y(y) - 5);
  context.lineTo(map.x(x), map.y(y) + 5);
  context.stroke();
}

function drawTruth(context, map, truth) {
  const style = { stroke: css('--truth'), dash: [3, 3] };
  robot(context, map, truth.robot, style);
  disc(context, map, truth.ball, 0.06, 7, style);
  for (const other of truth.others) disc(context, map, other, 0.15, 8, style);
}
