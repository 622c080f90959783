// The scene in three dimensions: what the map draws, as areas, lines and points. All of a kind is one buffer, which each moment fills anew.

import {
  CanvasTexture, Color, DirectionalLight, DoubleSide, Float32BufferAttribute, HemisphereLight, BufferGeometry, LineMaterial, LineSegments2, LineSegmentsGeometry,
  Mesh, MeshBasicMaterial, MeshLambertMaterial, OrbitControls, PerspectiveCamera, Points, PointsMaterial, Scene, ShapeUtils, Vector2, Vector3, WebGLRenderer,
} from '../../vendor/three.js';
import { applied, times } from '../../lib/frames.js';
import { pointsOf } from '../../lib/shapes.js';
import { css } from '../../lib/theme.js';

/** Sizes of dots, px, and of lines. */
const [DOT, SMALL, LINE] = [9, 4, 2];
/** Length of the axes of a frame, m. */
const AXIS = 0.1;
/** Distance of the camera from what it follows, m. */
const NEAR = 1.9;
/** A pose as a body that points ahead: its outline on the ground and its top, m. */
const OUTLINE = [[0.2, 0, 0], [-0.12, 0.11, 0], [-0.06, 0, 0], [-0.12, -0.11, 0]];
const TOP = [-0.02, 0, 0.09];

/** Triangles or points with colours, as a buffer of the graphics card. */
class Buffer {
  constructor(object) {
    [this.object, this.at, this.colours] = [object, [], []];
    object.frustumCulled = false;
  }

  add(point, colour) {
    this.at.push(...point);
    this.colours.push(...colour);
  }

  show() {
    const { geometry } = this.object;
    geometry.dispose();
    this.object.geometry = this.filled();
    this.object.visible = this.at.length > 0;
    [this.at, this.colours] = [[], []];
  }

  filled() {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(this.at, 3));
    geometry.setAttribute('color', new Float32BufferAttribute(this.colours, 4));
    if (this.object.material.isMeshLambertMaterial) geometry.computeVertexNormals();
    return geometry;
  }
}

/** Pairs of points. */
class Lines extends Buffer {
  constructor(options = {}) {
    super(new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({ vertexColors: true, linewidth: LINE, transparent: true, ...options })));
  }

  add(point, colour) {
    super.add(point, colour.slice(0, 3));
  }

  filled() {
    const geometry = new LineSegmentsGeometry();
    if (this.at.length === 0) return geometry;
    geometry.setPositions(this.at);
    geometry.setColors(this.colours);
    this.object.geometry = geometry;
    if (this.object.material.dashed) this.object.computeLineDistances();
    return geometry;
  }
}

/** Round points of a size, px. */
function dots(size) {
  const canvas = Object.assign(document.createElement('canvas'), { width: 32, height: 32 });
  const context = canvas.getContext('2d');
  context.fillStyle = '#ffffff';
  context.arc(16, 16, 15, 0, 2 * Math.PI);
  context.fill();
  const material = new PointsMaterial({ size, sizeAttenuation: false, vertexColors: true, map: new CanvasTexture(canvas), alphaTest: 0.5, transparent: true });
  return new Buffer(new Points(new BufferGeometry(), material));
}

/** The mesh of triangles in mm, of one colour. */
function meshOf({ colour, triangles }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(triangles.flat().map((at) => at / 1000), 3));
  geometry.computeVertexNormals();
  const mesh = new Mesh(geometry, new MeshLambertMaterial({ color: colour }));
  mesh.matrixAutoUpdate = mesh.frustumCulled = false;
  return mesh;
}

export class Space {
  /** Draws on a canvas; `element` takes the pointer, `changed` is called when the camera has moved. */
  constructor(canvas, element, changed) {
    // A picture of the panel reads what was drawn.
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(42, 1, 0.02, 300);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, element);
    this.controls.maxPolarAngle = Math.PI / 2 - 0.02;
    // The right button opens the menu of actions.
    Object.assign(this.controls.mouseButtons, { MIDDLE: this.controls.mouseButtons.RIGHT, RIGHT: null });
    this.controls.addEventListener('change', changed);
    // What lies on the ground is painted in its order, then lines and points: of two things at one height none is nearer.
    this.areas = new Buffer(new Mesh(new BufferGeometry(), new MeshBasicMaterial({ vertexColors: true, transparent: true, side: DoubleSide, forceSinglePass: true, depthWrite: false })));
    this.bodies = new Buffer(new Mesh(new BufferGeometry(), new MeshLambertMaterial({ vertexColors: true, side: DoubleSide })));
    [this.lines, this.dashes] = [new Lines(), new Lines({ dashed: true, dashSize: 0.03, gapSize: 0.025 })];
    [this.dots, this.small] = [dots(DOT), dots(SMALL)];
    this.areas.object.renderOrder = -1;
    this.buffers = [this.areas, this.bodies, this.lines, this.dashes, this.dots, this.small];
    const sun = new DirectionalLight('#ffffff', 1.6);
    sun.position.set(1, -2, 4);
    this.scene.add(new HemisphereLight('#ffffff', '#8090a0', 1.6), sun, ...this.buffers.map(({ object }) => object));
    [this.followed, this.bounds, this.placed, this.body] = [null, null, false, []];
  }

  dispose() {
    this.controls.dispose();
    this.clearBody();
    for (const { object } of this.buffers) {
      object.geometry.dispose();
      object.material.map?.dispose();
      object.material.dispose();
    }
    this.renderer.dispose();
  }

  /**
   * Draws layers, frames, the fields of view of cameras, and the body of the robot: {links, matrices}, or null. `follow` is the place of a
   * frame that the camera follows, or null.
   */
  draw(width, height, { layers, frames, views, body, follow }) {
    [this.ground, this.points] = [new Color(css('--panel')), []];
    for (const layer of layers) for (const part of layer.parts) this.part(part, layer);
    for (const frame of frames) this.frame(frame);
    for (const view of views) this.view(view);
    for (const buffer of this.buffers) buffer.show();
    this.pose(body);
    this.measure();
    this.follow(follow);
    this.renderer.setPixelRatio(window.devicePixelRatio || 1);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (!this.placed && this.bounds) this.fit();
    this.scene.background = this.ground;
    this.renderer.render(this.scene, this.camera);
  }

  /** A colour of the style sheet as its parts in linear light; one that is faint is mixed with the ground. */
  colour(text, faint) {
    const colour = new Color(text.slice(0, 7));
    if (faint) colour.lerp(this.ground, 0.6);
    return [colour.r, colour.g, colour.b, text.length > 7 ? Number.parseInt(text.slice(7, 9), 16) / 255 : 1];
  }

  part(part, { matrix, style }) {
    const colour = this.colour(style.colour, style.faint);
    const lines = style.dash ? this.dashes : this.lines;
    if (part.pose) return this.pointer(times(matrix, part.pose), colour, style.dash ? lines : null);
    const points = pointsOf(part, matrix);
    this.points.push(...points);
    if (part.dots) return points.forEach((point) => (part.small ? this.small : this.dots).add(point, colour));
    if (part.closed && style.fill) return this.area(points, colour);
    const ring = part.closed ? [...points, points[0]] : points;
    for (let index = 1; index < ring.length; index += 1) {
      if (style.width) this.strip(ring[index - 1], ring[index], style.width, colour);
      else for (const at of [ring[index - 1], ring[index]]) lines.add(at, colour);
    }
    return undefined;
  }

  /** A pose as a solid that points ahead; only its edges with `lines`. */
  pointer(matrix, colour, lines) {
    const [outline, top] = [OUTLINE.map((at) => applied(matrix, at)), applied(matrix, TOP)];
    this.points.push(top);
    outline.forEach((at, index) => {
      const next = outline[(index + 1) % outline.length];
      for (const point of lines ? [at, next, at, top] : [at, next, top]) (lines ?? this.bodies).add(point, colour);
    });
  }

  area(points, colour) {
    const flat = points.map(([x, y]) => new Vector2(x, y));
    for (const corners of ShapeUtils.triangulateShape(flat, [])) for (const corner of corners) this.areas.add(points[corner], colour);
  }

  /** A line with a width on the ground. */
  strip([x, y, z], [toX, toY, toZ], width, colour) {
    const length = Math.hypot(toX - x, toY - y) || 1;
    const [aside, ahead] = [((y - toY) / length) * (width / 2), ((toX - x) / length) * (width / 2)];
    const corners = [[x + aside, y + ahead, z], [toX + aside, toY + ahead, toZ], [toX - aside, toY - ahead, toZ], [x - aside, y - ahead, z]];
    for (const corner of [0, 1, 2, 0, 2, 3]) this.areas.add(corners[corner], colour);
  }

  /** The axes of a frame, and the link to the frame above it. */
  frame({ matrix, above }) {
    const origin = applied(matrix, [0, 0, 0]);
    const axes = [[[AXIS, 0, 0], '--act'], [[0, AXIS, 0], '--perceive'], [[0, 0, AXIS], '--control']];
    for (const [tip, name] of axes) for (const at of [origin, applied(matrix, tip)]) this.lines.add(at, this.colour(css(name)));
    if (above) for (const at of [applied(above, [0, 0, 0]), origin]) this.lines.add(at, this.colour(css('--dim')));
  }

  /** The frustum of a camera. */
  view({ matrix, corners, colour: name }) {
    const [origin, colour] = [applied(matrix, [0, 0, 0]), this.colour(name)];
    const ends = corners.map((corner) => applied(matrix, corner));
    ends.forEach((end, index) => {
      for (const at of [origin, end, end, ends[(index + 1) % ends.length]]) this.lines.add(at, colour);
    });
  }

  /** Moves the links of the body; their meshes are made once. */
  pose(body) {
    if (body?.links !== this.links) {
      this.links = body?.links;
      this.clearBody();
      this.body = body?.links.map(({ meshes }) => meshes.map(meshOf)) ?? [];
      this.scene.add(...this.body.flat());
    }
    body?.matrices.forEach((matrix, index) => this.body[index].forEach((mesh) => mesh.matrix.set(...matrix, 0, 0, 0, 1)));
  }

  clearBody() {
    for (const mesh of this.body.flat()) {
      this.scene.remove(mesh);
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
  }

  measure() {
    const finite = this.points.filter((point) => point.every(Number.isFinite));
    if (finite.length === 0) return;
    this.bounds = [0, 1, 2].map((axis) => finite.reduce(([low, high], point) => [Math.min(low, point[axis]), Math.max(high, point[axis])], [Infinity, -Infinity]));
  }

  /** Moves the camera with what it follows. */
  follow(place) {
    const at = place && new Vector3(...applied(place, [0, 0, 0.2]));
    if (at && this.followed) this.move(at.clone().sub(this.controls.target));
    else if (at) {
      const back = new Vector3(-0.75, -0.7, 0.62).multiplyScalar(NEAR);
      this.look(at, at.clone().add(back));
    }
    this.followed = at;
  }

  move(by) {
    this.camera.position.add(by);
    this.controls.target.add(by);
  }

  look(target, from) {
    this.placed = true;
    this.controls.target.copy(target);
    this.camera.position.copy(from);
    this.controls.update();
  }

  /** Shows everything: obliquely, or from above. */
  fit(above = false) {
    if (!this.bounds) return;
    const middle = new Vector3(...this.bounds.map(([low, high]) => (low + high) / 2));
    const [wide, deep] = this.bounds.map(([low, high]) => high - low);
    const distance = Math.max(wide / this.camera.aspect, deep, 1) * (above ? 1.4 : 1.6);
    // Exactly above the middle the controls would know no direction.
    this.look(middle, middle.clone().add(above ? new Vector3(0, -0.001, distance) : new Vector3(0, -0.7 * distance, 0.7 * distance)));
  }

  /** Where a point is on the canvas, px; null behind the camera. */
  project(point, width, height) {
    const { x, y, z } = new Vector3(...point).project(this.camera);
    return z > 1 ? null : [((x + 1) / 2) * width, ((1 - y) / 2) * height];
  }

  /** The place on the ground below a point of the canvas; null above the horizon. */
  at(x, y, width, height) {
    const from = this.camera.position;
    const ray = new Vector3((x / width) * 2 - 1, 1 - (y / height) * 2, 0.5).unproject(this.camera).sub(from);
    return ray.z < 0 ? [from.x - (from.z / ray.z) * ray.x, from.y - (from.z / ray.z) * ray.y] : null;
  }
}
