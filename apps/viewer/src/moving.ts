// Layers of many boxes that change as time goes on: bodies, the cells that hold them, and links between two of them.
// All of a layer at one moment is one drawing, joined on the page: a card that is a program draws thousands of copies
// one after the other, and takes long.
import { Box3, BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshLambertMaterial, Object3D, Sphere, Vector3 } from 'three';
import { bodyColours, stepColours, type Theme } from './colours';
import type { BoxesPlace, Layer, LayerStep, PageData } from './data';
import { segments } from './layers';
import { matrixOf, shownPlace } from './place';

const width = 7; // numbers of a box: its lower and upper corner, and its class

/// Corner i has the upper x where bit 0 is set, the upper y where bit 1 is, the upper z where bit 2 is.
const sides = [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5];
const edges = [0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7];

/// The boxes of a moment, as the engine wrote them.
function boxesOf(layer: Layer, data: PageData, step: LayerStep): Uint16Array {
  return data.shorts(layer.data).subarray(width * step.first, width * (step.first + step.count));
}

const isEmpty = (boxes: Uint16Array, at: number) => boxes[at] > boxes[at + 3];

export function colourOfClass(layer: Layer, one: number): number {
  const colours = layer.kind === 'bodies' ? bodyColours : stepColours;
  return colours[one % colours.length];
}

/// From the numbers of boxes to what is drawn.
function placeOf(layer: Layer, { header, report }: PageData): Matrix4 {
  const { lower, step } = layer.data as BoxesPlace;
  const inner = [step[0], 0, 0, 0, step[1], 0, 0, 0, step[2], ...lower];
  return matrixOf(layer.object === undefined ? inner : shownPlace(header.frame, report.objects[layer.object].pose, inner));
}

/// Eight corners for each box, in the colour of its class, and the index that `pattern` makes of them.
function joined(layer: Layer, data: PageData, step: LayerStep, pattern: number[]): BufferGeometry {
  const boxes = boxesOf(layer, data, step);
  const positions = new Float32Array(24 * step.count);
  const colours = new Float32Array(24 * step.count);
  const index = new Uint32Array(pattern.length * step.count);
  const classes = (layer.classes ?? ['']).map((_, i) => new Color(colourOfClass(layer, i)));
  let drawn = 0;
  for (let at = 0; at < boxes.length; at += width) {
    if (isEmpty(boxes, at)) continue;
    const colour = classes[boxes[at + 6] % classes.length];
    for (let corner = 0; corner < 8; ++corner) {
      const place = 24 * drawn + 3 * corner;
      for (let axis = 0; axis < 3; ++axis) positions[place + axis] = boxes[at + axis + 3 * ((corner >> axis) & 1)];
      colour.toArray(colours, place);
    }
    for (let i = 0; i < pattern.length; ++i) index[pattern.length * drawn + i] = 8 * drawn + pattern[i];
    ++drawn;
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('color', new BufferAttribute(colours, 3));
  geometry.setIndex(new BufferAttribute(index.subarray(0, pattern.length * drawn), 1));
  geometry.boundingSphere = new Sphere(); // nothing asks for it, and three.js would look at all corners
  return geometry;
}

function placed<T extends Object3D>(drawn: T, layer: Layer, data: PageData): T {
  drawn.matrixAutoUpdate = false;
  drawn.matrix.copy(placeOf(layer, data));
  drawn.frustumCulled = false;
  return drawn;
}

export function bodies(layer: Layer, data: PageData, step: LayerStep, through: boolean): Object3D {
  const seeThrough = through ? { transparent: true, opacity: 0.3, depthWrite: false } : {};
  const material = new MeshLambertMaterial({ vertexColors: true, flatShading: true, ...seeThrough });
  return placed(new Mesh(joined(layer, data, step, sides), material), layer, data);
}

export function cells(layer: Layer, data: PageData, step: LayerStep): Object3D {
  const material = new LineBasicMaterial({ vertexColors: true, transparent: true, opacity: step.count > 1000 ? 0.45 : 0.8 });
  const drawn = placed(new LineSegments(joined(layer, data, step, edges), material), layer, data);
  drawn.renderOrder = 1;
  return drawn;
}

/// A segment from the middle of one box to that of the other, for each pair of the moment.
export function links(layer: Layer, data: PageData, step: LayerStep, moment: number, theme: Theme): Object3D {
  const of = data.header.layers[layer.of ?? 0];
  return linesBetween(middles(of, data, moment), pairsOf(layer, data, step), theme);
}

function middles(of: Layer, data: PageData, moment: number): Float32Array {
  const [first, count] = of.moments?.[moment] ?? [0, 0];
  const boxes = boxesOf(of, data, { label: '', first, count });
  const { lower, step } = of.data as BoxesPlace;
  const points = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i)
    for (let axis = 0; axis < 3; ++axis) points[3 * i + axis] = lower[axis] + (step[axis] * (boxes[width * i + axis] + boxes[width * i + axis + 3])) / 2;
  return points;
}

function pairsOf(layer: Layer, data: PageData, step: LayerStep): Uint16Array | Uint32Array {
  const all = layer.data.bytes === 2 ? data.shorts(layer.data) : data.integers(layer.data);
  return all.subarray(2 * step.first, 2 * (step.first + step.count));
}

/// They lie within the boxes, so that they are drawn faintly over these too. Broad ones while they are few: a broad one
/// is a small surface, and thousands of them take long.
function linesBetween(points: Float32Array, pairs: Uint16Array | Uint32Array, theme: Theme): Object3D {
  const ends = new Float32Array(3 * pairs.length);
  pairs.forEach((body, i) => ends.set(points.subarray(3 * body, 3 * body + 3), 3 * i));
  if (pairs.length <= 4000) return segments(ends, theme.contact, 2.5, true);
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(ends, 3));
  const drawn = new LineSegments(geometry, new LineBasicMaterial({ color: theme.contact, depthTest: false, transparent: true, opacity: 0.5 }));
  drawn.frustumCulled = false;
  drawn.renderOrder = 2;
  return drawn;
}

/// The most boxes, of any layer, that are drawn at a moment.
export function mostBoxes({ header }: PageData): number {
  const counts = header.layers.flatMap(({ kind, moments }) => (kind === 'bodies' || kind === 'cells' ? (moments ?? []).map(([, count]) => count) : []));
  return counts.reduce((most, count) => Math.max(most, count), 0);
}

/// Around all bodies, at all moments.
export function boxOfBodies(data: PageData): Box3 {
  const whole = new Box3();
  for (const layer of data.header.layers) {
    if (layer.kind !== 'bodies') continue;
    const { lower, step } = layer.data as BoxesPlace;
    whole.expandByPoint(new Vector3(...lower));
    whole.expandByPoint(new Vector3(...lower.map((x, i) => x + 65535 * step[i])));
  }
  return whole;
}
